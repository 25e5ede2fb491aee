//! The spectra of a point, for a waterfall: power spectral densities of the coordinates that do not roll on.

use std::borrow::Cow;

use crate::analysis::spectrum::{Spectrum, segment_length, uniform_samples, welch};
use crate::output::{OutputError, Table, table::Values};
use crate::trajectory::Trajectory;

/// The spectrum of a coordinate.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// Name of the coordinate.
    pub coordinate: Cow<'static, str>,
    /// Frequencies [Hz].
    pub frequency: Vec<f64>,
    /// Density [unit^2/Hz].
    pub density: Vec<f64>,
}

/// Spectrum of coordinate `i` of a run from the time `from` [s] on; `None` if there are too few samples.
pub fn of(run: &Trajectory, i: usize, from: f64) -> Option<Spectrum> {
    let (mut rows, rate) = uniform_samples(run).ok()?;
    rows.retain(|&row| run.t[row] >= from);
    let x: Vec<f64> = rows.iter().map(|&row| run.q[i][row]).collect();
    welch(&x, rate, segment_length(x.len())).ok()
}

/// Rows `point`, `coordinate`, `frequency`, `density` of the lines of some points.
pub(super) fn table<'a>(points: impl Iterator<Item = (usize, &'a [Line])>) -> Result<Table, OutputError> {
    let (mut point, mut coordinate, mut frequency, mut density) = (vec![], vec![], vec![], vec![]);
    for (i, lines) in points {
        for line in lines {
            point.resize(point.len() + line.frequency.len(), i as f64);
            coordinate.resize(coordinate.len() + line.frequency.len(), line.coordinate.clone());
            frequency.extend(&line.frequency);
            density.extend(&line.density);
        }
    }
    let mut table = Table::default();
    table.push("point", "1", Values::Number(point))?;
    table.push("coordinate", "", Values::Text(coordinate))?;
    table.push("frequency", "Hz", Values::Number(frequency))?;
    table.push("density", "unit^2/Hz", Values::Number(density))?;
    Ok(table)
}

/// The lines in such a table, by point.
pub(super) fn read(table: &Table) -> Option<Vec<(usize, Line)>> {
    let (point, coordinate) = (table.numbers("point")?, table.words("coordinate")?);
    let (frequency, density) = (table.numbers("frequency")?, table.numbers("density")?);
    let mut lines: Vec<(usize, Line)> = vec![];
    for i in 0..table.rows() {
        let at = point[i] as usize;
        if lines.last().is_none_or(|(last, line)| *last != at || line.coordinate != coordinate[i]) {
            lines.push((at, Line { coordinate: coordinate[i].clone(), frequency: vec![], density: vec![] }));
        }
        if let Some((_, line)) = lines.last_mut() {
            line.frequency.push(frequency[i]);
            line.density.push(density[i]);
        }
    }
    Some(lines)
}
