//! Power spectral density of the coordinates that do not rotate continuously, as in Oh, Grosh and Barber (2005), Fig. 4.
//!
//! If every run has a damped natural frequency wd, the frequency axis is in units of wd and ends at 5 wd; else it is in Hz. The
//! density is always per Hz. Its axis spans at most 12 decades.

use std::f64::consts::TAU;

use super::figure::extremes;
use super::{
    Axis, Figure, Panel, Plot, PlotError, Run, Series, coordinate_index, first_run, rotates, scene_names, symbol,
};
use crate::analysis::spectrum::{Spectrum, segment_length, uniform_samples, welch};

/// The entry in [`super::PLOTS`].
pub const PLOT: Plot = Plot {
    name: "spectrum",
    doc: "power spectral density of the elastic coordinates against frequency, in units of wd where known",
    draw,
};

/// End of the frequency axis in units of wd, as in Oh, Grosh and Barber (2005), Fig. 4.
const LONGEST: f64 = 5.0;

fn draw(runs: &[Run<'_>]) -> Result<Figure, PlotError> {
    let model = first_run(PLOT.name, runs)?.trajectory.model;
    let references: Option<Vec<f64>> =
        runs.iter().map(|run| run.reference_frequency.filter(|wd| *wd > 0.0 && wd.is_finite())).collect();
    let mut panels = vec![];
    let mut longest = 0.0_f64;
    let mut segments = 0;
    for coordinate in model.coordinates {
        let name = coordinate.name;
        if runs.iter().any(|run| rotates(run.trajectory, name)) {
            continue;
        }
        let mut series = vec![];
        for (n, run) in runs.iter().enumerate() {
            let Some(i) = coordinate_index(run.trajectory, name) else {
                continue;
            };
            let spectrum = density(run, i).map_err(|source| PlotError::Spectrum {
                coordinate: name,
                run: run.label.to_owned(),
                source,
            })?;
            let unit = references.as_ref().map_or(1.0, |wd| wd[n] / TAU);
            let frequency: Vec<f64> = spectrum.frequency.iter().map(|f| f / unit).collect();
            longest = longest.max(frequency.last().copied().unwrap_or(0.0));
            segments = spectrum.segments;
            let label = if runs.len() > 1 { run.label } else { coordinate.doc };
            series.push(Series::new(n, label, frequency, spectrum.density));
        }
        let label = format!("PSD of {}", symbol(name));
        let unit = format!("{}^2/Hz", coordinate.unit);
        let y = limited(Axis::log10(label, unit), &series, references.is_some());
        panels.push(Panel { y, series });
    }
    if panels.is_empty() {
        let why = "every coordinate rotates continuously".into();
        return Err(PlotError::Nothing { plot: PLOT.name, why });
    }
    if runs.len() > 1 {
        panels.iter_mut().skip(1).for_each(Panel::unnamed);
    }
    let x = match references {
        Some(_) => Axis::linear("frequency ω/ω_{d}", "").between(0.0, longest.min(LONGEST)),
        None => Axis::linear("frequency f", "Hz").between(0.0, longest),
    };
    let averaged = if segments == 1 { "one segment".into() } else { format!("mean of {segments} segments") };
    let subtitle = format!("{}; Welch, Hann window, {averaged}", scene_names(runs));
    Ok(Figure { title: "Power spectral density".into(), subtitle: Some(subtitle), x, panels })
}

/// Limits the axis to 12 decades below the highest peak: below that, densities are only rounding errors and leakage.
fn limited(axis: Axis, series: &[Series], in_units_of_wd: bool) -> Axis {
    let end = if in_units_of_wd { LONGEST } else { f64::INFINITY };
    let shown = series.iter().flat_map(|s| s.x.iter().zip(&s.y)).filter(|&(&x, _)| x <= end);
    let (lowest, peak) = extremes(shown.map(|(_, &y)| y).filter(|&y| y > 0.0));
    if lowest < 1e-12 * peak { axis.between(1e-12 * peak, 3.0 * peak) } else { axis }
}

/// Power spectral density of coordinate `i` of `run`, from its evenly spaced samples.
fn density(run: &Run<'_>, i: usize) -> Result<Spectrum, crate::analysis::spectrum::SpectrumError> {
    let (rows, rate) = uniform_samples(run.trajectory)?;
    let x: Vec<f64> = rows.iter().map(|&row| run.trajectory.q[i][row]).collect();
    welch(&x, rate, segment_length(x.len()))
}
