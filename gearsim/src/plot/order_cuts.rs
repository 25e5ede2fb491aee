//! Order cuts of a run-up: the amplitudes at mesh orders, within the bandwidth of the window, over the speed of the first shaft.

use super::orders::{of, turnings};
use super::outputs::{engineering, of_unit, scale};
use super::{Axis, Figure, Panel, Plot, PlotError, Run, Series, first_run, scene_names};
use crate::analysis::orders::{BANDWIDTH, Mesh, SHAFT, Turning, cuts, meshes, reference_shaft};
use crate::model::Output;
use crate::output::number::short;

/// The entry in [`super::PLOTS`].
pub const PLOT: Plot = Plot { name: "order_cuts", draw };

/// The units of the outputs that are drawn; the first output of each.
const UNITS: [&str; 3] = ["m", "rad", "N"];
/// Multiples of the mesh orders.
const HARMONICS: [f64; 3] = [1.0, 2.0, 3.0];
/// Revolutions in a window.
const WINDOW: usize = 4;
/// Windows that a curve needs at least.
const LEAST: usize = 4;
/// Revolutions from which on a run-up has order cuts by default.
const ENOUGH: usize = 10;

/// Whether order cuts tell more of a run than its spectrum: the speed of a mesh varies, and the shaft makes enough revolutions.
pub(super) fn suits(run: &Run<'_>) -> bool {
    let (trajectory, asked) = (run.trajectory, &run.asked.spectrum);
    let enough = |shaft: &Output| {
        Turning::of(trajectory, shaft.name, asked.from).is_ok_and(|turning| turning.revolutions() >= ENOUGH)
    };
    let drawn = UNITS.iter().any(|unit| !of_unit(trajectory, unit).is_empty());
    let varies = || meshes(trajectory, asked.from).iter().any(|mesh| !mesh.steady);
    drawn && varies() && reference_shaft(trajectory, asked.shaft).is_some_and(enough)
}

fn draw(runs: &[Run<'_>]) -> Result<Figure, PlotError> {
    let first = first_run(PLOT.name, runs)?.trajectory;
    let nothing = |why: &str| PlotError::Nothing { plot: PLOT.name, why: why.into() };
    let shaft = reference_shaft(first, runs[0].asked.spectrum.shaft)
        .ok_or_else(|| nothing("the run recorded no speed of a rotor"))?;
    let turning = turnings(runs, shaft)?;
    let mut panels = vec![];
    for unit in UNITS {
        let Some(output) = of_unit(first, unit).first().copied() else { continue };
        let mut series = vec![];
        for (run, turning) in runs.iter().zip(&turning) {
            curves(run, (shaft, turning), output, runs.len() > 1, &mut series)?;
        }
        let shown = scale(&mut series, unit);
        panels.push(Panel { y: Axis::linear(output.name, shown), series });
    }
    if panels.is_empty() {
        return Err(nothing("the run recorded no transmission error or force"));
    }
    panels.iter_mut().skip(1).for_each(Panel::unnamed);
    let subtitle = format!(
        "{}; windows of {WINDOW} revolutions, Hann, peak amplitudes; bandwidth {} orders (−3 dB)",
        scene_names(runs),
        short(BANDWIDTH / WINDOW as f64)
    );
    let x = Axis::linear(shaft.name, engineering(SHAFT).0);
    Ok(Figure { title: "Order cuts".into(), subtitle: Some(subtitle), x, panels })
}

/// Adds the curves of a run: one for each order, or for the lowest alone where runs are `compared`.
fn curves(
    run: &Run<'_>,
    (shaft, turning): (&Output, &Turning),
    output: &'static Output,
    compared: bool,
    series: &mut Vec<Series>,
) -> Result<(), PlotError> {
    let Some(column) = run.trajectory.output(output.name) else { return Ok(()) };
    let mut wanted = wanted(run, turning);
    if compared {
        wanted.truncate(1);
        wanted[0].0 = run.label.to_owned();
    }
    let orders: Vec<f64> = wanted.iter().map(|(_, order)| *order).collect();
    let cuts = cuts(turning, column, &orders, WINDOW).map_err(of(run, output.name))?;
    if cuts.len() < LEAST {
        let (turns, points) = (turning.revolutions(), cuts.len());
        let why = format!("{turns} revolutions of {} give {points} points of a curve, which needs {LEAST}", shaft.name);
        return Err(PlotError::Nothing { plot: PLOT.name, why });
    }
    let (_, to_rpm) = engineering(SHAFT);
    for (i, (label, _)) in wanted.into_iter().enumerate() {
        let mut points: Vec<_> = cuts.iter().map(|cut| (to_rpm * cut.speed, cut.amplitude[i])).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (x, y) = points.into_iter().unzip();
        series.push(Series::new(series.len(), label, x, y));
    }
    Ok(())
}

/// The orders that are drawn, each with its name: multiples of the mesh orders, or of the shaft's own if no mesh turns.
fn wanted(run: &Run<'_>, turning: &Turning) -> Vec<(String, f64)> {
    let meshes = meshes(run.trajectory, run.asked.spectrum.from);
    let named = |mesh: &Mesh| {
        let base = mesh.frequency / turning.frequency();
        HARMONICS.map(|n| (format!("{n} × {}, order {}", mesh.name, short(n * base)), n * base))
    };
    match &meshes[..] {
        [] => HARMONICS.map(|n| (format!("order {n}"), n)).to_vec(),
        meshes => meshes.iter().flat_map(named).collect(),
    }
}
