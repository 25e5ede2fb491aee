//! The number of digits left of a result: an estimate of the error that rounding, or the tolerance of a numerical method, causes in
//! the state.
//!
//! A second run, the companion run, starts from a state and parameters that differ by a few roundings. With a numerical method it has
//! ten times the tolerance, or twice the time step. (If ten times the tolerance is more than a scene may have, the companion has a tenth of
//! the tolerance.) The companion has its own rounding errors, and the motion amplifies them as it amplifies those of the run. The distance
//! between the two runs is therefore an estimate of the error:
//!
//! digits = -log10(10 d), where d is the largest difference of a coordinate or speed, in units of its size in the run. The unit of a
//! coordinate that rotates continuously is one pitch ([`super::work_precision::error`]).
//!
//! If no digit is left, the motion is chaotic, or the tolerance is too coarse: the state is one of many possible ones. Conserved
//! quantities and averages may still be right.

use crate::model::Start;
use crate::run::{Digits, Outcome};
use crate::scene::solver::{Method, Precision};
use crate::scene::{Scene, TimeHistory};
use crate::trajectory::{Moment, Trajectory};

use super::work_precision::{Runner, error};
use crate::tolerance::{analysis, methods};

/// Maximum number of samples at which the two runs are compared.
const SAMPLES: usize = 512;

/// The scene of the companion of `run`, a run of `scene`. `ends` says that only its end state is needed.
pub fn companion(scene: &Scene, run: &Outcome, ends: bool) -> Scene {
    let trajectory = &run.trajectory;
    let mut other = scene.clone();
    other.output.events = false;
    other.output.record.clear();
    other.output.plots = vec![];
    if ends {
        other.output.rate = 0.5 / scene.t_end;
    } else {
        // Divide the rate by a power of two, so that the companion's samples are at exactly the times of samples of the run.
        let samples = (scene.t_end * scene.output.rate) as usize / SAMPLES;
        other.output.rate = scene.output.rate / (samples + 1).next_power_of_two() as f64;
    }
    other.t_end = trajectory.t.last().copied().filter(|t| *t > 0.0).unwrap_or(scene.t_end);
    // The changes have alternating signs. Equal relative changes of all numbers could have no effect, as a change of the unit of mass has
    // none.
    let part = analysis::PERTURBATION * f64::EPSILON;
    let by = |i: usize| if i.is_multiple_of(2) { 1.0 + part } else { 1.0 - part };
    let sizes = error::sizes(trajectory);
    for (i, coordinate) in scene.model.coordinates.iter().enumerate() {
        let (Some(q), Some(v)) = (trajectory.q[i].first(), trajectory.q_dot[i].first()) else { return other };
        // A phase may start on a boundary between cells. It is not changed, so that it stays in its cell.
        let is_phase = scene.model.laws.iter().any(|law| law.phase == coordinate.name);
        // A coordinate that stays at zero has the size zero and is not changed.
        let moved = Some(sizes.0[i] * (by(i) - 1.0)).filter(|moved| !is_phase && moved.is_normal()).unwrap_or(0.0);
        if !is_phase || scene.start.q[i].is_static() {
            other.start.q[i] = Start::At(q + moved);
        }
        other.start.q_dot[i] = Some(v * by(i + 1));
    }
    for (i, parameter) in other.parameters.iter_mut().enumerate() {
        let varies = scene.time_histories.iter().any(|(which, _): &(usize, TimeHistory)| *which == i);
        // Numbers of teeth stay whole numbers, and a parameter that varies in time keeps the first value of its time history.
        if !varies && parameter.fract() != 0.0 {
            *parameter *= by(i);
        }
    }
    other.solver.precision = Precision::Plain;
    other.solver.method = Method::ALL.iter().find(|(_, name)| *name == run.solver.method).map(|(method, _)| *method);
    if let Some(step) = &mut other.solver.step {
        *step *= 2.0;
    }
    let coarser = analysis::COMPANION_TOLERANCE * other.solver.tolerance;
    // If this exceeds the largest tolerance that a scene may have, the companion is more accurate than the run. The distance still
    // estimates the error of the less accurate one.
    other.solver.tolerance = match methods::ALLOWED.contains(&coarser) {
        true => coarser,
        false => other.solver.tolerance / analysis::COMPANION_TOLERANCE,
    };
    other
}

/// The number of digits left of `run`, a run of `scene`, from its `companion` run.
pub fn left(scene: &Scene, run: &Outcome, companion: &Outcome) -> Digits {
    let (a, b) = (&run.trajectory, &companion.trajectory);
    let curve = differences(a, b);
    let digits = |difference: f64| -(analysis::CLAIM_MARGIN * difference).log10();
    let end = curve.last().map_or(0.0, |last| last.0);
    let reached = a.t.last() == b.t.last() || run.stopped_by.is_some();
    let last =
        curve.iter().filter(|(t, _)| *t >= (1.0 - analysis::LAST_PART) * end).map(|(_, d)| *d).fold(0.0, f64::max);
    let plain = if reached { digits(last.max(f64::MIN_POSITIVE)).clamp(0.0, analysis::PLAIN_DIGITS) } else { 0.0 };
    let gone = curve.iter().rposition(|(_, d)| digits(*d) >= 1.0).map_or(0, |i| i + 1);
    let none_from = curve.get(gone).map(|(t, _)| *t).filter(|_| plain < 1.0);
    if scene.solver.precision == Precision::Plain {
        return Digits { at_end: plain, none_from };
    }
    // The companion runs in plain precision and has its rounding errors. A compensated run loses as many digits as a plain one. If the
    // plain run loses all its digits, the rate at which it lost them is extrapolated to the end.
    let lost = match none_from {
        Some(t) if t > 0.0 => analysis::PLAIN_DIGITS * end / t,
        Some(_) => analysis::COMPENSATED_DIGITS,
        None => analysis::PLAIN_DIGITS - plain,
    };
    let left = analysis::COMPENSATED_DIGITS - lost;
    let none_from = none_from.filter(|_| left < 1.0).map(|t| t * analysis::COMPENSATED_DIGITS / analysis::PLAIN_DIGITS);
    Digits { at_end: left.clamp(0.0, analysis::PLAIN_DIGITS), none_from }
}

/// Runs the companion of `outcome`, a run of `scene`, and sets the number of digits left in `outcome`.
pub fn noted(scene: &Scene, mut outcome: Outcome, run: Runner<'_>) -> Outcome {
    if let Ok(companion) = run(&companion(scene, &outcome, false)) {
        outcome.digits = Some(left(scene, &outcome, &companion));
    }
    outcome
}

/// Time and largest difference of two runs \[s, 1\], at each time at which both have a sample.
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
