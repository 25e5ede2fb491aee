//! How many digits of a result are left: what rounding, or the tolerance of a method, has become at the end of a run.
//!
//! A second run, the companion, starts from a state and parameters that differ by a rounding; by steps it has ten times the
//! tolerance, or twice the step. It makes its own rounding errors at its own places, and the motion makes of them what it makes of
//! those of the run itself. So the distance between the two is an estimate of the error:
//!
//! digits = -log10 of ten times the largest difference of a coordinate or speed, in units of its size in the run; of a coordinate that rolls
//! on, one pitch is the unit ([`super::work_precision::error`]).
//!
//! Where no digit is left the motion is chaotic, or the tolerance too coarse: the state is one of many. What is conserved, and
//! averages, may still be right.

use crate::model::Start;
use crate::run::{Digits, Outcome};
use crate::scene::solver::{Method, Precision};
use crate::scene::{Scene, TimeHistory};
use crate::trajectory::{Moment, Trajectory};

use super::work_precision::{Runner, error};

/// Digits of a number in f64, and of one carried in twice the digits.
const PLAIN: f64 = 15.95;
const COMPENSATED: f64 = 31.0;
/// Roundings by which the companion's start and parameters differ.
const ROUNDINGS: f64 = 4.0;
/// What the error may be of the distance to the one other run, which may come near by chance.
const MARGIN: f64 = 10.0;
/// The most samples at which the two are compared.
const SAMPLES: usize = 512;
/// Part of the run before its end over which the largest difference counts as that of the end: differences oscillate.
const END: f64 = 0.02;
/// How much coarser the companion of a method by steps is.
const COARSER: f64 = 10.0;
/// The coarsest tolerance.
const COARSEST: f64 = 1e-2;

/// The companion of `run`, a run of `scene`. `ends` if only its end is wanted.
pub fn companion(scene: &Scene, run: &Outcome, ends: bool) -> Scene {
    let trajectory = &run.trajectory;
    let mut other = scene.clone();
    other.output.events = false;
    other.output.plots = vec![];
    if ends {
        other.output.rate = 0.5 / scene.t_end;
    } else {
        // A power of two: then the companion's samples are at the very times of samples of the run.
        let samples = (scene.t_end * scene.output.rate) as usize / SAMPLES;
        other.output.rate = scene.output.rate / (samples + 1).next_power_of_two() as f64;
    }
    other.t_end = trajectory.t.last().copied().filter(|t| *t > 0.0).unwrap_or(scene.t_end);
    // Alternating signs, so that what is common to all numbers, as a unit of mass is, does not cancel the disturbance.
    let part = ROUNDINGS * f64::EPSILON;
    let by = |i: usize| if i.is_multiple_of(2) { 1.0 + part } else { 1.0 - part };
    let sizes = error::sizes(trajectory);
    for (i, coordinate) in scene.model.coordinates.iter().enumerate() {
        let (Some(q), Some(v)) = (trajectory.q[i].first(), trajectory.q_dot[i].first()) else { return other };
        // A phase may start on a boundary: it is left on its side of that.
        let is_phase = scene.model.laws.iter().any(|law| law.phase == coordinate.name);
        let moved = if is_phase { 0.0 } else { sizes.0[i] * (by(i) - 1.0) };
        if !is_phase || scene.start.q[i].is_static() {
            other.start.q[i] = Start::At(q + moved);
        }
        other.start.q_dot[i] = Some(v * by(i + 1));
    }
    for (i, parameter) in other.parameters.iter_mut().enumerate() {
        let varies = scene.time_histories.iter().any(|(which, _): &(usize, TimeHistory)| *which == i);
        // Teeth are whole numbers, and what varies in time begins at the value of its course.
        if !varies && parameter.fract() != 0.0 {
            *parameter *= by(i);
        }
    }
    other.solver.precision = Precision::Plain;
    other.solver.method = Method::ALL.iter().find(|(_, name)| *name == run.solver.method).map(|(method, _)| *method);
    if let Some(step) = &mut other.solver.step {
        *step *= 2.0;
    }
    other.solver.tolerance = (COARSER * other.solver.tolerance).min(COARSEST);
    other
}

/// How many digits of `run`, a run of `scene`, are left, by its `companion`.
pub fn left(scene: &Scene, run: &Outcome, companion: &Outcome) -> Digits {
    let (a, b) = (&run.trajectory, &companion.trajectory);
    let curve = differences(a, b);
    let digits = |difference: f64| -(MARGIN * difference).log10();
    let end = curve.last().map_or(0.0, |last| last.0);
    let reached = a.t.last() == b.t.last() || run.stopped_by.is_some();
    let last = curve.iter().filter(|(t, _)| *t >= (1.0 - END) * end).map(|(_, d)| *d).fold(0.0, f64::max);
    let plain = if reached { digits(last.max(f64::MIN_POSITIVE)).clamp(0.0, PLAIN) } else { 0.0 };
    let gone = curve.iter().rposition(|(_, d)| digits(*d) >= 1.0).map_or(0, |i| i + 1);
    let none_from = curve.get(gone).map(|(t, _)| *t).filter(|_| plain < 1.0);
    if scene.solver.precision == Precision::Plain {
        return Digits { at_end: plain, none_from };
    }
    // The companion has plain numbers, and so the error of those. In twice the digits it is as much smaller as they are more; where
    // the plain ones are all lost, at the rate at which they were lost until then.
    let lost = match none_from {
        Some(t) if t > 0.0 => PLAIN * end / t,
        Some(_) => COMPENSATED,
        None => PLAIN - plain,
    };
    let left = COMPENSATED - lost;
    let none_from = none_from.filter(|_| left < 1.0).map(|t| t * COMPENSATED / PLAIN);
    Digits { at_end: left.clamp(0.0, PLAIN), none_from }
}

/// Runs the companion of `outcome`, a run of `scene`, and notes how many digits are left.
pub fn noted(scene: &Scene, mut outcome: Outcome, run: Runner<'_>) -> Outcome {
    if let Ok(companion) = run(&companion(scene, &outcome, false)) {
        outcome.digits = Some(left(scene, &outcome, &companion));
    }
    outcome
}

/// The largest difference of two runs at each time at which both have a sample \[s, 1\].
fn differences(a: &Trajectory, b: &Trajectory) -> Vec<(f64, f64)> {
    let sizes = error::sizes(a);
    let mut rows = a.samples().peekable();
    let mut curve = vec![];
    for j in (0..b.len()).filter(|&j| b.moment[j] == Moment::Sample) {
        while rows.next_if(|&i| a.t[i] < b.t[j]).is_some() {}
        let Some(&i) = rows.peek().filter(|&&i| a.t[i] == b.t[j]) else { continue };
        curve.push((a.t[i], error::difference((a, i), (b, j), &sizes)));
    }
    curve
}
