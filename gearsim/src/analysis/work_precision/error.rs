//! How far a run is from a reference, apart: at the end, along the path, in the times and number of events, in energy.
//!
//! States are compared coordinate by coordinate and speed by speed, each in units of its own size in the reference; of a
//! coordinate that rolls on, one pitch is the unit. Never across a jump: a sample between an event and its counterpart
//! says how late one is, not how wrong the speed, and is left to the error in times.
//!
//! Events are those at which speeds or strain energy jump. Flanks that meet or part change neither; which of their moments are noted
//! is a matter of the method.

use crate::run::Outcome;
use crate::trajectory::{Moment, Trajectory};

/// How far off a run is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Errors {
    /// Largest of the state at the end.
    pub end: f64,
    /// Largest of the state at any sample, and of the limits at events where their number is right.
    pub path: f64,
    /// Largest in the time of an event \[s\]; `None` where their number is not right, or there are none.
    pub times: Option<f64>,
    /// Events too many, or too few.
    pub events: i64,
    /// Largest energy unaccounted for, of T + V at the start.
    pub energy: f64,
}

/// The errors of `run`. Where ramps of width `blur` \[unit of the phase\] stand for steps, samples that may lie in one are not
/// compared: there a ramp is not a step by its nature.
pub fn of(run: &Outcome, reference: &Outcome, blur: f64) -> Errors {
    let (a, b) = (&run.trajectory, &reference.trajectory);
    let sizes = sizes(b);
    let difference = |i: usize, j: usize| difference((a, i), (b, j), &sizes);
    let samples = |t: &Trajectory| (0..t.len()).filter(|&i| t.moment[i] == Moment::Sample).collect::<Vec<_>>();
    let (mine, theirs) = (jumps(a), jumps(b));
    let events = mine.len() as i64 - theirs.len() as i64;
    let matched = events == 0 && !mine.is_empty();
    let times = matched.then(|| mine.iter().zip(&theirs).fold(0.0f64, |m, (&i, &j)| m.max((a.t[i] - b.t[j]).abs())));

    // Row j of the reference, and i of the run at the same time: is an event of one, and not of the other, between them?
    // A ramp's events have no times: they are as far off as the phases are apart, and the ramp is wide; where only one has
    // turned back so far, they have an event between them.
    let phase = b.model.laws.first().and_then(|law| b.model.coordinates.iter().position(|c| c.name == law.phase));
    let near = |i: usize, j: usize| {
        let ramp = phase.filter(|_| blur > 0.0).map_or(0.0, |phase| {
            let (mine, theirs) = (a.q_dot[phase][i], b.q_dot[phase][j]);
            let apart = blur + (a.q[phase][i] - b.q[phase][j]).abs();
            if mine * theirs > 0.0 { apart / mine.abs().min(theirs.abs()) } else { f64::INFINITY }
        });
        let (t, window) = (b.t[j], ramp.max(1.01 * times.unwrap_or(0.0)));
        let next = theirs.partition_point(|&event| b.t[event] < t - window);
        theirs.get(next).is_some_and(|&event| b.t[event] <= t + window)
    };
    let (a_samples, b_samples) = (samples(a), samples(b));
    let mut path = 0.0f64;
    for (&i, &j) in a_samples.iter().zip(&b_samples) {
        if a.t[i] == b.t[j] && !near(i, j) {
            path = path.max(difference(i, j));
        }
    }
    if matched {
        // The limits at an event, each with its counterpart.
        for (&i, &j) in mine.iter().zip(&theirs) {
            path = path.max(difference(i, j)).max(difference(i + 1, j + 1));
        }
    }
    let end = match (a_samples.last(), b_samples.last()) {
        (Some(&i), Some(&j)) if a.t[i] == b.t[j] => difference(i, j),
        _ => f64::NAN,
    };
    let energy = a.residual.iter().fold(0.0f64, |m, x| m.max(x.abs())) / reference.energy_at_start;
    Errors { end, path, times, events, energy }
}

/// Roundings, of the largest value, that are no jump.
const ROUNDINGS: f64 = 64.0 * f64::EPSILON;

fn largest(column: &[f64]) -> f64 {
    column.iter().fold(f64::MIN_POSITIVE, |m, x| m.max(x.abs()))
}

/// Rows of left limits at which something jumps; each has its right limit in the next row.
fn jumps(t: &Trajectory) -> Vec<usize> {
    let columns = || t.q_dot.iter().chain([&t.strain]);
    let roundings: Vec<f64> = columns().map(|column| ROUNDINGS * largest(column)).collect();
    let jumps = |i: &usize| columns().zip(&roundings).any(|(x, rounding)| (x[i + 1] - x[*i]).abs() > *rounding);
    (0..t.len().saturating_sub(1)).filter(|&i| t.moment[i] == Moment::Before).filter(jumps).collect()
}

/// The largest difference of a coordinate or speed in a row of one run and a row of another, in units of their `sizes`; NaN if one of
/// them is.
pub fn difference((a, i): (&Trajectory, usize), (b, j): (&Trajectory, usize), sizes: &(Vec<f64>, Vec<f64>)) -> f64 {
    let of = |x: &[Vec<f64>], y: &[Vec<f64>], sizes: &[f64]| {
        let each = x.iter().zip(y).zip(sizes).map(|((x, y), size)| (x[i] - y[j]).abs() / size);
        each.fold(0.0f64, |m, x| if x > m || x.is_nan() { x } else { m })
    };
    of(&a.q, &b.q, &sizes.0).max(of(&a.q_dot, &b.q_dot, &sizes.1))
}

/// The sizes of the coordinates and of the speeds of a run.
pub fn sizes(run: &Trajectory) -> (Vec<f64>, Vec<f64>) {
    let q = run.model.coordinates.iter().zip(&run.q).map(|(coordinate, column)| {
        let law = run.model.laws.iter().find(|law| law.rolling && law.phase == coordinate.name);
        law.map_or_else(|| largest(column), |law| law.period)
    });
    (q.collect(), run.q_dot.iter().map(|column| largest(column)).collect())
}
