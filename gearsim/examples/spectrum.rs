//! Computes the spectrum of the mesh deflection of a gear pair, and prints its highest lines.
//!
//! `cargo run --release --example spectrum`, from the root of the repository.

use std::error::Error;

use gearsim::Scene;
use gearsim::analysis::spectrum::{Spectrum, segment_length, uniform_samples, welch};

fn main() -> Result<(), Box<dyn Error>> {
    let spectrum = spectrum("models/scenes/oh2005/spectrum_4500rpm_exact.toml", "phi")?;
    for i in lines(&spectrum).into_iter().take(5) {
        println!("{:8.1} Hz  {:.3e} rad^2/Hz", spectrum.frequency[i], spectrum.density[i]);
    }
    Ok(())
}

/// The power spectral density of a column of the scene in the file `path`.
pub fn spectrum(path: &str, column: &str) -> Result<Spectrum, Box<dyn Error>> {
    let results = Scene::load(path)?.run()?;
    let column = results.column(column)?;
    // Rows at events are left out, so that the samples are at equal distances in time.
    let (rows, rate) = uniform_samples(results.trajectory())?;
    let x: Vec<f64> = rows.iter().map(|&row| column[row]).collect();
    Ok(welch(&x, rate, segment_length(x.len()))?)
}

/// The indices of the local maxima, the highest first.
pub fn lines(spectrum: &Spectrum) -> Vec<usize> {
    let p = &spectrum.density;
    let mut lines: Vec<_> = (1..p.len() - 1).filter(|&i| p[i - 1] < p[i] && p[i] > p[i + 1]).collect();
    lines.sort_by(|&a, &b| p[b].total_cmp(&p[a]));
    lines
}
