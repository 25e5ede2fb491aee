//! Computes the spectrum of the mesh deflection of a gear pair, and prints its highest lines.
//!
//! `cargo run --release --example spectrum`, from the root of the repository.

use std::path::Path;

use anyhow::{Context, anyhow};
use gearsim::analysis::spectrum::{Spectrum, segment_length, uniform_samples, welch};
use gearsim::generated::MODELS;
use gearsim::scene::Scene;

fn main() -> anyhow::Result<()> {
    let spectrum = spectrum("models/scenes/oh2005/spectrum_4500rpm_exact.toml", "phi")?;
    for i in lines(&spectrum).into_iter().take(5) {
        println!("{:8.1} Hz  {:.3e} rad^2/Hz", spectrum.frequency[i], spectrum.density[i]);
    }
    Ok(())
}

/// The power spectral density of a coordinate of the scene in the file `path`.
pub fn spectrum(path: &str, coordinate: &str) -> anyhow::Result<Spectrum> {
    let models: Vec<_> = MODELS.iter().map(|entry| entry.model).collect();
    let scene = Scene::load(Path::new(path), &[], &models).map_err(|errors| anyhow!(errors.render(100, false)))?;
    let entry = MODELS.iter().find(|entry| entry.model.name == scene.model.name).context("no such model")?;
    let run = entry.run(&scene, &mut |_| {})?.trajectory;
    let i = run.model.coordinates.iter().position(|c| c.name == coordinate).context("no such coordinate")?;
    let (rows, rate) = uniform_samples(&run)?;
    let x: Vec<f64> = rows.iter().map(|&row| run.q[i][row]).collect();
    Ok(welch(&x, rate, segment_length(x.len()))?)
}

/// The indices of the local maxima, the highest first.
pub fn lines(spectrum: &Spectrum) -> Vec<usize> {
    let p = &spectrum.density;
    let mut lines: Vec<_> = (1..p.len() - 1).filter(|&i| p[i - 1] < p[i] && p[i] > p[i + 1]).collect();
    lines.sort_by(|&a, &b| p[b].total_cmp(&p[a]));
    lines
}
