//! Whether the samples of a run are close enough for its vibrations and excitations. Content above half the sampling rate is folded to
//! lower frequencies. Spectra, lines of mesh orders, sounds and load cycles then have frequencies and amplitudes that the motion does not
//! have.
//!
//! Frequencies of meshes and of torques are known. Other vibrations show in the recorded speeds. Between two samples, h apart, a coordinate
//! moves by the integral of its speed. The trapezoidal rule has an error there: for a component of the coordinate with the angular
//! frequency w and the amplitude A it is at most 2 A (sin x - x cos x), x = w h/2. This is 0.04 A at eight samples a period, 0.3 A at four,
//! 2 A at two, and more with fewer samples.

use std::f64::consts::TAU;

use crate::analysis::modes;
use crate::analysis::orders::meshes;
use crate::analysis::spectrum::uniform_samples_from;
use crate::known;
use crate::scene::Scene;
use crate::tolerance::analysis::{FOLDED, RESOLVED, SHOWN, STILL};
use crate::trajectory::Trajectory;

/// What the samples of a run cannot show.
#[derive(Debug, Clone, PartialEq)]
pub struct Folding {
    /// The rate of the samples \[Hz\].
    pub rate: f64,
    /// The excitations above half this rate, in words, and their frequencies \[Hz\]: meshes at their fastest, then torques.
    pub frequencies: Vec<(String, f64)>,
    /// The first coordinate that vibrates faster than samples can show.
    pub vibrates: Option<&'static str>,
    /// A rate that suffices \[Hz\].
    pub enough: f64,
}

/// What the samples of a run from the time `from` \[s\] on cannot show; `None` if they show everything.
pub fn folding(scene: &Scene, run: &Trajectory, from: f64) -> Option<Folding> {
    let (_, rate) = uniform_samples_from(run, from).ok()?;
    let meshes = meshes(run, from).into_iter();
    let meshes = meshes.map(|mesh| (format!("the mesh frequency of `{}`", mesh.name), mesh.fastest));
    let torques = scene.time_histories.iter().flat_map(|(parameter, history)| {
        let parameter = &scene.model.parameters[*parameter];
        let (name, present) = (parameter.name, scene.effects.activate(parameter.with, scene.model));
        let acts = history.harmonics.iter().filter(move |harmonic| present && harmonic.amplitude != 0.0);
        acts.map(move |harmonic| (format!("a harmonic of `{name}`"), harmonic.omega.abs() / TAU))
    });
    let frequencies: Vec<_> = meshes.chain(torques).filter(|(_, frequency)| *frequency > 0.5 * rate).collect();
    let vibrates = vibrates_too_fast(run, from).filter(|_| may_vibrate(scene, rate));
    let fastest = frequencies.iter().fold(0.0, |fastest: f64, (_, frequency)| fastest.max(*frequency));
    let enough = (SHOWN * fastest).max(if vibrates.is_some() { SHOWN * rate } else { 0.0 });
    (enough > 0.0).then(|| Folding { rate, frequencies, vibrates, enough: two_digits(enough) })
}

/// The next number with two significant digits.
fn two_digits(x: f64) -> f64 {
    let unit = 10f64.powf(x.log10().floor() - 1.0);
    (x / unit).ceil() * unit
}

/// The frequency at which samples at `rate` show a vibration of the frequency `f` \[Hz\].
pub fn folded(f: f64, rate: f64) -> f64 {
    (f - rate * (f / rate).round()).abs()
}

/// Whether a mode of the scene may vibrate too fast for samples at `rate` \[Hz\]: an overdamped one does not vibrate, although its speeds
/// change within a sample. True for a scene whose modes are not known.
fn may_vibrate(scene: &Scene, rate: f64) -> bool {
    let system = known::of(scene).and_then(|entry| entry.system(scene).ok());
    let modes =
        system.and_then(|system| modes::of(&system, &scene.mid_stiffnesses(), &modes::Parts::default(), &|| {}).ok());
    modes.is_none_or(|cell| cell.modes.iter().any(|mode| mode.damped > rate / RESOLVED))
}

/// The first coordinate whose samples from the time `from` \[s\] on are too far apart for its vibration; `None` if there is no such one.
fn vibrates_too_fast(run: &Trajectory, from: f64) -> Option<&'static str> {
    let (rows, _) = uniform_samples_from(run, from).ok()?;
    let missed = |i: &usize| {
        let (q, v) = (&run.q[*i], &run.q_dot[*i]);
        let steps = rows.windows(2).map(|pair| {
            let mean = 0.5 * (v[pair[0]] + v[pair[1]]);
            q[pair[1]] - q[pair[0]] - mean * (run.t[pair[1]] - run.t[pair[0]])
        });
        let missed: f64 = steps.map(|x| x * x).sum();
        let (varies, size) = about_a_line(rows.iter().map(|&row| (run.t[row], q[row])));
        // If the speed is constant, only rounding errors are left.
        varies > STILL * size && missed > FOLDED * FOLDED * varies
    };
    (0..run.q.len()).find(missed).map(|found| run.model.coordinates[found].name)
}

/// The sum of the squared distances of points from the line that fits them best, and the sum of their squared values.
fn about_a_line(points: impl Iterator<Item = (f64, f64)> + Clone) -> (f64, f64) {
    let n = points.clone().count() as f64;
    let (t, x) = points.clone().fold((0.0, 0.0), |sum, (t, x)| (sum.0 + t / n, sum.1 + x / n));
    let (tt, tx) = points.clone().fold((0.0, 0.0), |s, p| (s.0 + (p.0 - t).powi(2), s.1 + (p.0 - t) * (p.1 - x)));
    let slope = if tt > 0.0 { tx / tt } else { 0.0 };
    points.fold((0.0, 0.0), |s, p| (s.0 + (p.1 - x - slope * (p.0 - t)).powi(2), s.1 + p.1 * p.1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::fixture::MODEL;
    use crate::trajectory::Moment;

    /// A phase that turns, with a vibration of `samples` a period beside a slow one of the same amplitude.
    fn run(samples: f64) -> Trajectory {
        let mut run = Trajectory::new(&MODEL, &[], &[]);
        let w = std::f64::consts::TAU / samples;
        run.t = (0..1000).map(|i| f64::from(i) * 1e-3).collect();
        run.moment = vec![Moment::Sample; 1000];
        run.q[0] =
            (0..1000).map(|i| 0.3 * f64::from(i) + (w * f64::from(i)).sin() + (0.01 * f64::from(i)).sin()).collect();
        let rate = |i: f64| 1e3 * (0.3 + w * (w * i).cos() + 0.01 * (0.01 * i).cos());
        run.q_dot[0] = (0..1000).map(|i| rate(f64::from(i))).collect();
        for i in 1..run.q.len() {
            (run.q[i], run.q_dot[i]) = (vec![0.0; 1000], vec![0.0; 1000]);
        }
        run
    }

    #[test]
    fn folded_vibrations_are_found_by_the_speeds() {
        for (samples, folded) in [(50.0, false), (8.3, false), (1.9, true), (1.13, true), (0.37, true)] {
            let found = vibrates_too_fast(&run(samples), 0.0);
            assert_eq!(found.is_some(), folded, "{samples} samples a period: {found:?}");
        }
        assert_eq!(vibrates_too_fast(&run(f64::INFINITY), 0.0), None);
    }
}
