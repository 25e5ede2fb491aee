//! Cascade of a run-up: amplitude spectra of successive parts of a run, each drawn at the speed of its part. Mesh orders are rays
//! through the origin, natural frequencies are vertical. At constant speed the parts are drawn at their times.

use std::f64::consts::TAU;

use super::cascade::{RunPart, Subject, content, lines, panel};
use super::outputs::sized;
use super::{Axis, Figure, Plot, PlotError, Run, first_run, scene_names};
use crate::analysis::spectrum::{SpectrumError, uniform_samples_from, welch};

/// The entry in [`super::PLOTS`].
pub const PLOT: Plot = Plot { name: "run_up", draw };

/// Parts of the run, which overlap by half.
const PARTS: usize = 30;
/// Least samples of a part.
const LEAST: usize = 64;

fn draw(runs: &[Run<'_>]) -> Result<Figure, PlotError> {
    let first = first_run(PLOT.name, runs)?;
    let run = first.trajectory;
    let Subject { shaft, signal: (signal, _), meshes } = Subject::of(PLOT.name, first)?;
    let mut panels = vec![];
    let (mut end, mut unit) = (0.0_f64, "");
    for run in runs {
        let failed = |source| PlotError::Spectrum { signal, run: run.label.to_owned(), source };
        let (Some((si, column)), Some(speed)) = (run.trajectory.signal(signal), run.trajectory.output(shaft.name))
        else {
            continue;
        };
        let parts = parts(run, column, speed).map_err(failed)?;
        let peak = parts.iter().flat_map(|part| &part.amplitude).copied().fold(0.0, f64::max);
        end = end.max(content(&parts, peak));
        unit = si;
        panels.push((run, parts, peak));
    }
    let (unit, factor) = sized(unit, panels.iter().map(|(.., peak)| *peak).fold(0.0, f64::max));
    let longest = panels.iter().flat_map(|(_, parts, _)| parts).filter_map(|part| part.place.last().copied());
    end = (1.1 * end).min(longest.fold(0.0, f64::max));
    let orders: Vec<(&str, f64)> =
        meshes.iter().map(|mesh| (mesh.name, mesh_order(run, shaft.name, mesh.frequency))).collect();
    let panels = panels.into_iter().map(|(run, parts, peak)| {
        panel(&parts, (run.label, runs.len() > 1), (end, factor * peak, unit), &|range| {
            lines(&orders, range, |order, rpm| order * rpm / 60.0)
        })
    });
    let subtitle = format!(
        "{}; {signal}, {PARTS} parts, Hann window, peak amplitudes; speed of {}",
        scene_names(runs),
        shaft.name
    );
    let x = Axis::linear("frequency f", "Hz").between(0.0, end);
    Ok(Figure { title: "Cascade".into(), subtitle: Some(subtitle), x, panels: panels.collect() })
}

/// Pitches per revolution of the shaft.
fn mesh_order(run: &crate::trajectory::Trajectory, shaft: &str, mesh: f64) -> f64 {
    let speed: Vec<f64> = run.output(shaft).map_or(vec![], |speed| run.samples().map(|row| speed[row]).collect());
    mesh * TAU / (speed.iter().sum::<f64>() / speed.len().max(1) as f64).abs()
}

/// The spectra of the parts of a run.
fn parts(run: &Run<'_>, column: &[f64], speed: &[f64]) -> Result<Vec<RunPart>, SpectrumError> {
    let (rows, rate) = uniform_samples_from(run.trajectory, run.asked.spectrum.from)?;
    let length = (2 * rows.len() / (PARTS + 1) / 2 * 2).max(LEAST.min(rows.len()));
    let part = |rows: &[usize]| {
        let x: Vec<f64> = rows.iter().map(|&row| column[row]).collect();
        let spectrum = welch(&x, rate, x.len())?;
        let speed = rows.iter().map(|&row| speed[row]).sum::<f64>() / rows.len() as f64;
        let time = 0.5 * (run.trajectory.t[rows[0]] + run.trajectory.t[rows[rows.len() - 1]]);
        let amplitude: Vec<f64> = spectrum.rms().map(|rms| rms * 2.0_f64.sqrt()).collect();
        Ok(RunPart { speed: speed.abs(), time, place: spectrum.frequency, amplitude })
    };
    rows.windows(length).step_by((length / 2).max(1)).map(part).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::fixture::MODEL;
    use crate::plot::tests::run;
    use crate::trajectory::{Moment, Trajectory};

    /// A run-up from 5 to 25 revolutions a second in 4 s, with 17 pulses of amplitude 3 a revolution.
    #[test]
    fn each_part_has_its_line_at_its_speed() {
        let mut up = Trajectory::new(&MODEL, &[], &[0, 1]);
        up.t = (0..=80_000).map(|i| f64::from(i) / 20e3).collect();
        up.moment = vec![Moment::Sample; up.t.len()];
        let speed: Vec<f64> = up.t.iter().map(|t| TAU * (5.0 + 5.0 * t)).collect();
        let x: Vec<f64> = up.t.iter().map(|t| 3.0 * (17.0 * TAU * (5.0 * t + 2.5 * t * t)).sin()).collect();
        let parts = parts(&run("up", &up), &x, &speed).unwrap();
        assert!(parts.len() >= PARTS, "{}", parts.len());
        let resolution = parts[0].place[1];
        for part in parts {
            let top =
                (1..part.amplitude.len()).max_by(|&a, &b| part.amplitude[a].total_cmp(&part.amplitude[b])).unwrap();
            let expected = 17.0 * part.speed / TAU;
            // Within a part the order moves by 17 x 5 1/s² x 0.26 s = 22 Hz, which the window narrows.
            assert!((part.place[top] - expected).abs() < 12.0 + resolution, "{} {expected}", part.place[top]);
            assert!(part.amplitude[top] < 3.0);
        }
    }

    #[test]
    fn at_constant_speed_a_part_has_the_amplitude_of_a_sine() {
        let mut steady = Trajectory::new(&MODEL, &[], &[0, 1]);
        steady.t = (0..=80_000).map(|i| f64::from(i) / 20e3).collect();
        steady.moment = vec![Moment::Sample; steady.t.len()];
        let speed = vec![TAU * 10.0; steady.t.len()];
        let x: Vec<f64> = steady.t.iter().map(|t| 3.0 * (TAU * 170.0 * t).sin()).collect();
        for part in parts(&run("steady", &steady), &x, &speed).unwrap() {
            // The root of the summed squares over 1.5 lines of noise bandwidth: the amplitude wherever the frequency lies between lines.
            let power: f64 = part.amplitude.iter().map(|a| a * a).sum::<f64>() / 1.5;
            assert!((power.sqrt() / 3.0 - 1.0).abs() < 1e-3, "{}", power.sqrt());
        }
    }
}
