//! Spectra of outputs and coordinates: power spectral density, peak or rms amplitude, or levels of them in dB.
//!
//! The scene chooses what is drawn (`[output] spectrum`). The axis is in Hz and reaches as far as the content of the spectra and the first
//! mesh lines. Alternatively it is in units of the damped natural frequency wd, as in Oh, Grosh and Barber (2005), Fig. 4. The density is
//! always per Hz.

mod scale;

use std::f64::consts::TAU;

use super::figure::name_once;
use super::marks::{HARMONICS, MarkedCurve, marks};
use super::outputs::of_unit;
use super::{Axis, Figure, Panel, Plot, PlotError, Run, Series, first_run, rotates, scene_names};
use crate::analysis::orders::{Mesh, meshes};
use crate::analysis::spectrum::{Spectrum, SpectrumError, segment_length, uniform_samples_from, welch};
use crate::trajectory::Trajectory;
use scale::Shown;

/// The entry in [`super::PLOTS`].
pub const PLOT: Plot = Plot { name: "spectrum", draw };

/// End of the frequency axis in units of wd, as in Oh, Grosh and Barber (2005), Fig. 4.
const LONGEST: f64 = 5.0;
/// Least end of the axis of frequencies or orders in multiples of the highest mesh frequency or order.
const MESHES: f64 = 4.5;
/// The axis reaches so far that less than this fraction of the power lies beyond it.
pub(crate) const CONTENT: f64 = 1e-3;
/// Most forces of meshes if the scene does not choose.
const FORCES: usize = 2;
/// Most panels if the scene does not choose.
const MOST: usize = 4;

fn draw(runs: &[Run<'_>]) -> Result<Figure, PlotError> {
    let first = first_run(PLOT.name, runs)?;
    let signals = signals(runs);
    if signals.is_empty() {
        let why = "every coordinate rotates continuously, and no force or transmission error is recorded".into();
        return Err(PlotError::Nothing { plot: PLOT.name, why });
    }
    let mut spectra = vec![];
    for name in signals {
        let found = runs.iter().map(|run| {
            let unknown = SpectrumError::TooShort { samples: 0 };
            let column = run.trajectory.signal(name).ok_or(unknown).and_then(|(_, column)| density(run, column));
            column.map_err(|source| PlotError::Spectrum { signal: name, run: run.label.to_owned(), source })
        });
        spectra.push((name, found.collect::<Result<Vec<_>, _>>()?));
    }
    let meshes: Vec<Mesh> = meshes(first.trajectory, first.asked.spectrum.from);
    let (x, units) = abscissa(runs, &meshes, spectra.iter().flat_map(|(_, all)| all));
    let (_, end) = x.range.unwrap_or((0.0, f64::INFINITY));
    // A mesh whose speed varies has no line over frequency.
    let steady: Vec<Mesh> = meshes.into_iter().filter(|mesh| mesh.steady).collect();
    let segments = spectra[0].1[0].segments;
    let mut panels = vec![];
    for (name, all) in spectra {
        let shown = Shown::of(first, name, &all);
        let mut series = vec![];
        for (n, (spectrum, run)) in all.into_iter().zip(runs).enumerate() {
            let label = if runs.len() > 1 { run.label.to_owned() } else { shown.doc.to_owned() };
            let y = shown.values(&spectrum);
            let frequency = spectrum.frequency.iter().map(|f| f / units[n]).collect();
            series.push(Series::new(n, label, frequency, y));
        }
        let (y, range) = shown.axis(&series, end);
        let least = |median| shown.prominent(median);
        let curve = MarkedCurve { series: &series[0], closer: 1, least: &least };
        let marks = marks(&steady, (units[0], end, HARMONICS), range, curve);
        // Lines are drawn behind the curves, symbols in front of them.
        let (lines, symbols): (Vec<_>, Vec<_>) = marks.into_iter().partition(|mark| mark.style.width > 0.0);
        panels.push(Panel { y, series: lines.into_iter().chain(series).chain(symbols).collect() });
    }
    // All curves except the signal itself are in all panels.
    name_once(&mut panels, |series| runs.len() > 1 || series.style.width < 1.0);
    let averaged = if segments == 1 { "one segment".into() } else { format!("mean of {segments} segments") };
    let subtitle = format!("{}; {}, Hann window, {averaged}", scene_names(runs), scale::words(&first.asked.spectrum));
    Ok(Figure { title: scale::title(&first.asked.spectrum).into(), subtitle: Some(subtitle), x, panels })
}

/// What is drawn: the signals that the scene names, or the forces of the first meshes, a transmission error and the coordinates that do
/// not rotate.
fn signals(runs: &[Run<'_>]) -> Vec<&'static str> {
    let run = runs[0].trajectory;
    let has = |name: &&'static str| runs.iter().all(|run| run.trajectory.signal(name).is_some());
    if !runs[0].asked.spectrum.of.is_empty() {
        return runs[0].asked.spectrum.of.iter().copied().filter(has).collect();
    }
    let forces = meshes(run, runs[0].asked.spectrum.from).into_iter().filter_map(|mesh| mesh.force).take(FORCES);
    let errors = of_unit(run, "m").into_iter().chain(of_unit(run, "rad")).map(|output| output.name);
    let outputs = forces.chain(errors.take(1));
    let elastic = run.model.coordinates.iter().map(|c| c.name);
    let elastic = elastic.filter(|name| !runs.iter().any(|run| rotates(run.trajectory, name)));
    outputs.filter(has).chain(elastic.filter(has)).take(MOST).collect()
}

/// The frequency axis, and for each run the frequency that is 1 on it \[Hz\].
fn abscissa<'a>(
    runs: &[Run<'_>],
    meshes: &[Mesh],
    all: impl Iterator<Item = &'a Spectrum> + Clone,
) -> (Axis, Vec<f64>) {
    let references: Option<Vec<f64>> = runs
        .iter()
        .filter(|run| run.asked.spectrum.natural)
        .map(|run| run.reference_frequency.filter(|wd| *wd > 0.0 && wd.is_finite()).map(|wd| wd / TAU))
        .collect();
    let mesh = meshes.iter().map(|mesh| mesh.frequency).fold(0.0, f64::max);
    let longest = all.clone().filter_map(|s| s.frequency.last().copied()).fold(0.0, f64::max);
    match references {
        Some(units) if units.len() == runs.len() => {
            let end = LONGEST.max(MESHES * mesh / units[0]).min(longest / units[0]);
            (Axis::linear("frequency ω/ω_{d}", "").between(0.0, end), units)
        }
        _ => {
            let end = reach(all.map(|s| s.highest(CONTENT)), mesh, longest);
            (Axis::linear("frequency f", "Hz").between(0.0, end), vec![1.0; runs.len()])
        }
    }
}

/// The end of an axis of frequencies or orders: beyond the `highest` content of each spectrum, and beyond the first multiples of the
/// highest mesh frequency or order `mesh`, up to the `longest` that there is.
pub(crate) fn reach(highest: impl Iterator<Item = f64>, mesh: f64, longest: f64) -> f64 {
    let content = highest.map(|x| 1.1 * x).fold(0.0, f64::max);
    content.max(MESHES * mesh).min(longest)
}

/// Power spectral density of a column of `run`, from its evenly spaced samples.
fn density(run: &Run<'_>, column: &[f64]) -> Result<Spectrum, SpectrumError> {
    let trajectory: &Trajectory = run.trajectory;
    let (rows, rate) = uniform_samples_from(trajectory, run.asked.spectrum.from)?;
    let x: Vec<f64> = rows.iter().map(|&row| column[row]).collect();
    welch(&x, rate, segment_length(x.len()))
}
