//! Waterfall of a run-up over orders: order spectra of windows of whole revolutions, each drawn at the speed of the first shaft in that
//! window. Orders are vertical, natural frequencies are hyperbolas. At constant speed the windows are drawn at their times.

use super::cascade::{RunPart, Subject, content, lines, panel};
use super::orders::{of, turnings};
use super::outputs::sized;
use super::spectrum::reach;
use super::{Axis, Figure, Plot, PlotError, Run, first_run, scene_names};
use crate::analysis::orders::{Window, windows};

/// The entry in [`super::PLOTS`].
pub const PLOT: Plot = Plot { name: "order_waterfall", draw };

/// Revolutions in a window. Lines are then a quarter of an order apart; the main lobe of the Hann window is four lines wide.
const WINDOW: usize = 4;
/// Revolutions from one window to the next.
const APART: f64 = 2.0;
/// Windows that are drawn at most, evenly chosen.
const MOST: usize = 40;

fn draw(runs: &[Run<'_>]) -> Result<Figure, PlotError> {
    let first = first_run(PLOT.name, runs)?;
    let Subject { shaft, signal: (signal, si), meshes } = Subject::of(PLOT.name, first)?;
    let turning = turnings(runs, shaft)?;
    let orders: Vec<(&str, f64)> =
        meshes.iter().map(|mesh| (mesh.name, mesh.frequency / turning[0].frequency())).collect();
    let highest = orders.iter().map(|(_, order)| *order).fold(0.0, f64::max);
    let (mut all, mut end) = (vec![], 0.0_f64);
    for (run, turning) in runs.iter().zip(&turning) {
        let Some((_, column)) = run.trajectory.signal(signal) else { continue };
        let windows = windows(turning, column, WINDOW, APART).map_err(of(run, signal))?;
        if windows.len() < 2 {
            let why = format!("the run has {} revolutions of {}, and needs six", turning.revolutions(), shaft.name);
            return Err(PlotError::Nothing { plot: PLOT.name, why });
        }
        let each = windows.len().div_ceil(MOST);
        let parts: Vec<RunPart> = windows.into_iter().step_by(each).map(part).collect();
        let longest = parts.iter().filter_map(|part| part.place.last().copied()).fold(0.0, f64::max);
        let peak = parts.iter().flat_map(|part| &part.amplitude).copied().fold(0.0, f64::max);
        end = end.max(reach([content(&parts, peak)].into_iter(), highest, longest));
        all.push((run, parts, peak));
    }
    let (unit, factor) = sized(si, all.iter().map(|(.., peak)| *peak).fold(0.0, f64::max));
    let panels = all.into_iter().map(|(run, parts, peak)| {
        panel(&parts, (run.label, runs.len() > 1), (end, factor * peak, unit), &|range| {
            lines(&orders, range, |order, _| order)
        })
    });
    let subtitle = format!(
        "{}; {}, windows of {WINDOW} revolutions, Hann, peak amplitudes; speed of {}",
        scene_names(runs),
        signal,
        shaft.name
    );
    let x = Axis::linear(format!("order of {}", shaft.name), "").between(0.0, end);
    Ok(Figure { title: "Waterfall over orders".into(), subtitle: Some(subtitle), x, panels: panels.collect() })
}

/// A window without its mean, which is order zero.
fn part(Window { speed, time, orders }: Window) -> RunPart {
    let (place, amplitude) = (orders.order[1..].to_vec(), orders.amplitude[1..].to_vec());
    RunPart { speed: speed.abs(), time, place, amplitude }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use crate::analysis::orders::Turning;
    use crate::output::fixture::MODEL;
    use crate::trajectory::{Moment, Trajectory};

    /// A run-up from 5 to 25 revolutions a second in 4 s with 17 pulses of amplitude 3 a revolution: the line stays at order 17 with its
    /// amplitude in every window, where a spectrum over frequency smears it.
    #[test]
    fn an_order_stays_in_its_place_while_the_speed_rises() {
        let mut up = Trajectory::new(&MODEL, &[], &[0, 1]);
        up.t = (0..=80_000).map(|i| f64::from(i) / 20e3).collect();
        up.moment = vec![Moment::Sample; up.t.len()];
        up.outputs[0].1 = up.t.iter().map(|t| TAU * (5.0 + 5.0 * t)).collect();
        let x: Vec<f64> = up.t.iter().map(|t| 3.0 * (17.0 * TAU * (5.0 * t + 2.5 * t * t)).sin()).collect();
        let turning = Turning::of(&up, "rotor_speed", 0.0).unwrap();
        let parts: Vec<RunPart> = windows(&turning, &x, WINDOW, APART).unwrap().into_iter().map(part).collect();
        assert!(parts.len() > 25, "{}", parts.len());
        for part in &parts {
            let top = (0..part.place.len()).max_by(|&a, &b| part.amplitude[a].total_cmp(&part.amplitude[b])).unwrap();
            assert!((part.place[top] - 17.0).abs() < 1e-9, "{}", part.place[top]);
            assert!((part.amplitude[top] / 3.0 - 1.0).abs() < 1e-2, "{}", part.amplitude[top]);
        }
        assert!(parts.windows(2).all(|pair| pair[0].speed < pair[1].speed && pair[0].time < pair[1].time));
    }
}
