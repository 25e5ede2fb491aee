//! The spectra of a point, for waterfall plots: power spectral densities of the coordinates that do not rotate continuously.

use std::borrow::Cow;

use crate::analysis::spectrum::{Spectrum, segment_length, uniform_samples, welch};
use crate::output::{OutputError, Table, table::Values};
use crate::trajectory::Trajectory;

/// The power spectral density of a coordinate, both columns of equal length.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedSpectrum {
    /// Name of the coordinate.
    pub coordinate: Cow<'static, str>,
    /// Frequencies [Hz].
    pub frequency: Vec<f64>,
    /// Power spectral density [(unit of the coordinate)^2/Hz].
    pub density: Vec<f64>,
}

/// Spectrum of coordinate `i` of a run, from its samples at times >= `from` [s]; `None` if there are too few.
pub fn of(run: &Trajectory, i: usize, from: f64) -> Option<Spectrum> {
    let (mut rows, rate) = uniform_samples(run).ok()?;
    rows.retain(|&row| run.t[row] >= from);
    let x: Vec<f64> = rows.iter().map(|&row| run.q[i][row]).collect();
    welch(&x, rate, segment_length(x.len())).ok()
}

/// A table with the columns `point`, `coordinate`, `frequency` and `density`, one row per frequency, of the spectra of some points.
pub(super) fn table<'a>(points: impl Iterator<Item = (usize, &'a [NamedSpectrum])>) -> Result<Table, OutputError> {
    let (mut point, mut coordinate, mut frequency, mut density) = (vec![], vec![], vec![], vec![]);
    for (i, spectra) in points {
        for spectrum in spectra {
            point.resize(point.len() + spectrum.frequency.len(), i as f64);
            coordinate.resize(coordinate.len() + spectrum.frequency.len(), spectrum.coordinate.clone());
            frequency.extend(&spectrum.frequency);
            density.extend(&spectrum.density);
        }
    }
    let mut table = Table::default();
    table.push("point", "1", Values::Number(point))?;
    table.push("coordinate", "", Values::Text(coordinate))?;
    table.push("frequency", "Hz", Values::Number(frequency))?;
    table.push("density", "unit^2/Hz", Values::Number(density))?;
    Ok(table)
}

/// The spectra in a table made by [`table`], each with its point; `None` if a column is missing.
pub(super) fn read(table: &Table) -> Option<Vec<(usize, NamedSpectrum)>> {
    let (point, coordinate) = (table.numbers("point")?, table.words("coordinate")?);
    let (frequency, density) = (table.numbers("frequency")?, table.numbers("density")?);
    let mut spectra: Vec<(usize, NamedSpectrum)> = vec![];
    for i in 0..table.rows() {
        let at = point[i] as usize;
        if spectra.last().is_none_or(|(last, spectrum)| *last != at || spectrum.coordinate != coordinate[i]) {
            spectra.push((at, NamedSpectrum { coordinate: coordinate[i].clone(), frequency: vec![], density: vec![] }));
        }
        if let Some((_, spectrum)) = spectra.last_mut() {
            spectrum.frequency.push(frequency[i]);
            spectrum.density.push(density[i]);
        }
    }
    Some(spectra)
}
