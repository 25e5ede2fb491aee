//! The errors of a run against a reference, separately: at the end, along the path, in the times and number of events, and in energy.
//!
//! Every coordinate and every speed is compared in units of its own size in the reference. The unit of a coordinate that rotates
//! continuously is one pitch. Samples between an event and its counterpart in the other run are not compared: their difference shows
//! the delay of the event, which the error in times measures, not an error of the speed.
//!
//! Only events at which speeds or strain energy jump are compared. Flanks that meet or part change neither, and methods record
//! different ones of these events.

use crate::run::Outcome;
use crate::tolerance::analysis::{AT_REST, NO_JUMP};
use crate::trajectory::{Moment, Trajectory};

/// The errors of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Errors {
    /// Largest error of the state at the end; NaN if the end was not reached.
    pub end: f64,
    /// Largest error of the state at any sample, and before and after events if their number is right.
    pub path: f64,
    /// Largest error in the time of an event \[s\]; `None` if their number is not right, or there are none.
    pub times: Option<f64>,
    /// Number of events less that of the reference.
    pub events: i64,
    /// Largest energy residual, over T + V at the start.
    pub energy: f64,
}

/// The errors of `run`. If ramps of width `blur` \[unit of the phase\] replace steps, samples that may lie on a ramp are not compared:
/// there a ramp differs from a step in any case.
pub fn of(run: &Outcome, reference: &Outcome, blur: f64) -> Errors {
    let (a, b) = (&run.trajectory, &reference.trajectory);
    let sizes = sizes(b);
    let difference = |i: usize, j: usize| difference((a, i), (b, j), &sizes);
    let samples = |t: &Trajectory| (0..t.len()).filter(|&i| t.moment[i] == Moment::Sample).collect::<Vec<_>>();
    let (mine, theirs) = (jumps(a), jumps(b));
    let events = mine.len() as i64 - theirs.len() as i64;
    let matched = events == 0 && !mine.is_empty();
    let times = matched.then(|| mine.iter().zip(&theirs).fold(0.0f64, |m, (&i, &j)| m.max((a.t[i] - b.t[j]).abs())));

    // For row j of the reference and row i of the run at the same time: can an event have happened in one and not yet in the other?
    // The events of ramps have no times. Their delay is at most the distance of the two phases plus the width of the ramp, over the
    // speed. If the phases move in opposite directions, there is an event between the two rows.
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
        // Compare the rows before and after each event with those of its counterpart.
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

fn largest(column: &[f64]) -> f64 {
    column.iter().fold(f64::MIN_POSITIVE, |m, x| m.max(x.abs()))
}

/// The rows before an event at which a speed or the strain energy jumps; the row after the event is the next one.
///
/// A speed has the rounding errors of the speeds from which it is computed: the rate of a deflection is the difference of two rotational
/// speeds that are many times as large. A change of a speed is therefore compared with the speed that the coordinate would have if it alone
/// had the kinetic energy.
pub(super) fn jumps(t: &Trajectory) -> Vec<usize> {
    let kinetic = largest(&t.kinetic);
    let possible = |i: usize| t.inertia.get(i).map_or(0.0, |inertia| (2.0 * kinetic / inertia).sqrt());
    let speeds = t.q_dot.iter().enumerate().map(|(i, column)| (column, largest(column).max(possible(i))));
    let columns: Vec<_> = speeds.chain([(&t.strain, largest(&t.strain))]).collect();
    let jumps = |i: &usize| columns.iter().any(|(x, size)| (x[i + 1] - x[*i]).abs() > NO_JUMP * size);
    (0..t.len().saturating_sub(1)).filter(|&i| t.moment[i] == Moment::Before).filter(jumps).collect()
}

/// The largest difference of a coordinate or speed between row `i` of run `a` and row `j` of run `b`, in units of their `sizes`; NaN if
/// a difference is NaN.
pub fn difference((a, i): (&Trajectory, usize), (b, j): (&Trajectory, usize), sizes: &(Vec<f64>, Vec<f64>)) -> f64 {
    let of = |x: &[Vec<f64>], y: &[Vec<f64>], sizes: &[f64]| {
        let each = x.iter().zip(y).zip(sizes).map(|((x, y), size)| (x[i] - y[j]).abs() / size);
        each.fold(0.0f64, |m, x| if x > m || x.is_nan() { x } else { m })
    };
    of(&a.q, &b.q, &sizes.0).max(of(&a.q_dot, &b.q_dot, &sizes.1))
}

/// The sizes of the coordinates and of the speeds of a run: the largest absolute value, or one pitch for a rotating coordinate. The
/// size of a coordinate is at least the share `AT_REST` of the largest size with the same unit. A speed below this share is zero but for
/// errors that the larger ones cause: its size is the largest one. Example: the rate of a deflection while a pair accelerates evenly.
///
/// If all speeds with the same unit are at rest, the largest one is an error too. In its place is the speed that a coordinate would have if
/// it alone had the energy of the run; and for coordinates the distance that it would cover with this speed.
pub fn sizes(run: &Trajectory) -> (Vec<f64>, Vec<f64>) {
    let coordinates = &run.model.coordinates;
    let n = coordinates.len();
    let same = |i: usize| (0..n).filter(move |&j| coordinates[j].unit == coordinates[i].unit);
    let largest_of = |sizes: &[f64], i: usize| same(i).fold(0.0f64, |most, j| most.max(sizes[j]));

    let (energy, duration) = (run.largest_energy(), run.t.last().map_or(0.0, |t| t - run.t[0]));
    let possible = |i: usize| run.inertia.get(i).map_or(0.0, |inertia| (2.0 * energy / inertia).sqrt());
    let speeds: Vec<f64> = run.q_dot.iter().map(|column| largest(column)).collect();
    let at_rest = |i: usize| same(i).all(|j| speeds[j] <= AT_REST * possible(j));

    let q: Vec<f64> = coordinates
        .iter()
        .zip(&run.q)
        .map(|(coordinate, column)| {
            let law = run.model.laws.iter().find(|law| law.rolling && law.phase == coordinate.name);
            law.map_or_else(|| largest(column), |law| law.period)
        })
        .collect();
    (0..n)
        .map(|i| {
            let possible = if at_rest(i) { possible(i) } else { 0.0 };
            let place = q[i].max(AT_REST * largest_of(&q, i).max(possible * duration));
            // A speed at rest has no digits of its own.
            let fastest = largest_of(&speeds, i).max(possible);
            (place, if speeds[i] <= AT_REST * fastest { fastest } else { speeds[i] })
        })
        .unzip()
}
