//! Whether the samples of a run are close enough for its vibrations. Content above half the sampling rate is folded to lower frequencies.
//! Spectra, lines of mesh orders, sounds and load cycles then have frequencies and amplitudes that the motion does not have.
//!
//! The recorded speeds show it. Between two samples, h apart, a coordinate moves by the integral of its speed. The trapezoidal rule has an
//! error there: for a component of the coordinate with the angular frequency w and the amplitude A it is at most 2 A (sin x - x cos x), x =
//! w h/2. This is 0.04 A at eight samples a period, 0.3 A at four, 2 A at two, and more with fewer samples.

use crate::analysis::spectrum::uniform_samples_from;
use crate::tolerance::analysis::{FOLDED, STILL};
use crate::trajectory::Trajectory;

/// The first coordinate whose samples from the time `from` \[s\] on are too far apart, and the rate \[Hz\] of the samples; `None` if there
/// is no such coordinate.
pub fn too_far_apart(run: &Trajectory, from: f64) -> Option<(&'static str, f64)> {
    let (rows, rate) = uniform_samples_from(run, from).ok()?;
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
    let found = (0..run.q.len()).find(missed)?;
    Some((run.model.coordinates[found].name, rate))
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
            let found = too_far_apart(&run(samples), 0.0);
            assert_eq!(found.is_some(), folded, "{samples} samples a period: {found:?}");
        }
        assert_eq!(too_far_apart(&run(f64::INFINITY), 0.0), None);
    }
}
