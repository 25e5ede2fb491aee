//! Order spectra of the recorded transmission errors and forces, over orders of a shaft: peak amplitudes.

use super::marks::marks;
use super::outputs::{engineering, of_unit};
use super::{Axis, Figure, Panel, Plot, PlotError, Run, Series, first_run, scene_names};
use crate::analysis::orders::{Turning, meshes, reference_shaft};
use crate::analysis::spectrum::SpectrumError;
use crate::model::Output;
use crate::output::number::short;

/// The entry in [`super::PLOTS`].
pub const PLOT: Plot = Plot { name: "orders", draw };

/// The units of the outputs that are drawn; the first output of each.
const UNITS: [&str; 4] = ["m", "rad", "N", "N*m"];
/// The axis ends at this multiple of the highest mesh order.
pub(crate) const LONGEST: f64 = 4.5;
/// The axis of amplitudes begins at this part of the highest line.
pub(crate) const DECADES: f64 = 1e-6;

/// The samples of each run at the angles of a shaft.
pub(super) fn turnings(runs: &[Run<'_>], shaft: &'static Output) -> Result<Vec<Turning>, PlotError> {
    let turning =
        |run: &Run<'_>| Turning::of(run.trajectory, shaft.name, run.asked.spectrum.from).map_err(of(run, shaft.name));
    runs.iter().map(turning).collect()
}

/// Why an output of a run has no spectrum.
pub(super) fn of(run: &Run<'_>, signal: &'static str) -> impl Fn(SpectrumError) -> PlotError {
    move |source| PlotError::Spectrum { signal, run: run.label.to_owned(), source }
}

fn draw(runs: &[Run<'_>]) -> Result<Figure, PlotError> {
    let first = first_run(PLOT.name, runs)?.trajectory;
    let nothing = |why: String| PlotError::Nothing { plot: PLOT.name, why };
    let shaft = reference_shaft(first, runs[0].asked.spectrum.shaft)
        .ok_or_else(|| nothing("the run recorded no speed of a rotor".into()))?;
    let mut panels = vec![];
    let turning = turnings(runs, shaft)?;
    let from = runs[0].asked.spectrum.from;
    let meshes = meshes(first, from);
    let highest = meshes.iter().map(|mesh| mesh.frequency).fold(0.0, f64::max) / turning[0].frequency();
    let (mut end, mut revolutions) = (f64::INFINITY, 0);
    for unit in UNITS {
        let Some(output) = of_unit(first, unit).first().copied() else { continue };
        let (shown, factor) = engineering(unit);
        let (mut series, mut peak) = (vec![], 0.0_f64);
        for (n, (run, turning)) in runs.iter().zip(&turning).enumerate() {
            let Some(column) = run.trajectory.output(output.name) else { continue };
            let orders = turning.orders(column).map_err(of(run, output.name))?;
            let longest = orders.order.last().copied().unwrap_or(0.0);
            end = end.min(if highest > 0.0 { longest.min(LONGEST * highest) } else { longest });
            revolutions = orders.revolutions;
            let y: Vec<f64> = orders.amplitude.iter().map(|a| a * factor).collect();
            peak = y.iter().skip(1).copied().fold(peak, f64::max);
            let label = if runs.len() > 1 { run.label } else { "" };
            series.push(Series::new(n, label, orders.order, y));
        }
        let range = (DECADES * peak, 2.0 * peak);
        let y = Axis::log10(output.name, shown).between(range.0, range.1);
        if peak > 0.0 {
            let marks = marks(&meshes, turning[0].frequency(), end, range, &series[0]);
            let (lines, symbols): (Vec<_>, Vec<_>) = marks.into_iter().partition(|mark| mark.style.width > 0.0);
            panels.push(Panel { y, series: lines.into_iter().chain(series).chain(symbols).collect() });
        }
    }
    // The legend of the first panel holds for all.
    panels.iter_mut().skip(1).for_each(Panel::unnamed);
    let orders = meshes.iter().map(|mesh| format!("{} {}", mesh.name, short(mesh.frequency / turning[0].frequency())));
    let orders = orders.collect::<Vec<_>>().join(", ");
    if panels.is_empty() {
        return Err(nothing("the run recorded no transmission error, force or torque that varies".into()));
    }
    let subtitle = format!(
        "{}; {revolutions} revolutions, Hann window, peak amplitudes; mesh orders {}",
        scene_names(runs),
        if meshes.is_empty() { "none" } else { &orders }
    );
    let x = Axis::linear(format!("order of {}", shaft.name), "").between(0.0, end);
    Ok(Figure { title: "Orders".into(), subtitle: Some(subtitle), x, panels })
}
