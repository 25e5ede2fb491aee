//! What holds of every motion, on random gear pairs: symmetries, handing over, and the energy account.
//!
//! Chaos multiplies rounding errors: a comparison of states allows `ROUNDINGS` of them an event, times the factor by which
//! the motion itself multiplies a shift of its start (`Pair::conditioning`) and by which M's inertias blur (`Pair::ratio`). Where that leaves nothing to compare, the
//! case is set aside. Where a property holds bit by bit, that is asked.

mod common;
#[path = "properties/draw.rs"]
mod draw;
#[path = "common/pair.rs"]
mod pair;
#[path = "properties/scaled.rs"]
mod scaled;

use pair::{PITCH, Pair, Ran};
use proptest::prelude::*;

/// Rounding errors that an event may add to a state.
const ROUNDINGS: f64 = 32.0;
/// A comparison coarser than this proves nothing.
const COARSE: f64 = 1e-6;

/// What two runs of a pair with `events` events may differ by.
fn tolerance(pair: &Pair, events: usize) -> f64 {
    ROUNDINGS * f64::EPSILON * pair.ratio() * (events + 4) as f64 * pair.conditioning()
}

/// The motion backwards from where a run has ended. On a boundary the cell stays: an end is inside, but for chance.
fn reversed(end: &Ran) -> Ran {
    let mut back = end.clone();
    back.state.q_dot = -back.state.q_dot;
    back
}

/// The pair seen in a mirror: every coordinate, speed and torque of the other sign, the steps in the other order.
fn mirrored(pair: &Pair) -> Pair {
    Pair {
        t0: -pair.t0,
        steps: pair.steps.iter().rev().copied().collect(),
        q: [PITCH - pair.q[0], -pair.q[1]],
        q_dot: pair.q_dot.map(|v| -v),
        ..pair.clone()
    }
}

#[test]
fn time_reversal_leads_back_to_the_start() {
    draw::check(draw::pair(Just(0.0)), |pair| {
        let end = pair.run();
        prop_assume!(end.stop.is_none());
        let tolerance = tolerance(&pair, end.times.len());
        prop_assume!(tolerance < COARSE);
        let back = pair.run_on(&reversed(&end));
        let start = Pair { span: 1e-300, ..pair.clone() }.run();
        let difference = pair.difference(&reversed(&back).state, &start.state);
        prop_assert!(difference < tolerance, "{difference:e}, not {tolerance:e}, after {} events", end.times.len());
        prop_assert_eq!(back.times.len(), end.times.len());
        Ok(())
    });
}

#[test]
fn a_mirror_changes_no_bit() {
    draw::check(draw::pair(draw::damping()), |pair| {
        // Ends just after the last event: within a cell theta is not symmetric, its remainder counts from one side.
        let (a, b) = (pair.run(), mirrored(&pair).run());
        prop_assert_eq!(&a.times, &b.times);
        prop_assert_eq!(a.state.q_dot, -b.state.q_dot);
        prop_assert_eq!(a.state.q[1], -b.state.q[1]);
        prop_assert_eq!(a.cell + b.cell + 1, pair.steps.len());
        prop_assert_eq!(a.state.turns[0], -b.state.turns[0]);
        let sum = a.state.q[0] + b.state.q[0];
        prop_assert!((sum - PITCH).abs() <= 2.0 * f64::EPSILON * PITCH, "{sum}");
        Ok(())
    });
}

#[test]
fn a_run_split_anywhere_is_the_whole() {
    draw::check((draw::pair(draw::damping()), 0.0..1.0f64), |(pair, part)| {
        let whole = pair.run();
        prop_assume!(whole.stop.is_none());
        let tolerance = tolerance(&pair, whole.times.len());
        prop_assume!(tolerance < COARSE);
        let before = part * pair.span;
        prop_assume!(before > 0.0 && before < pair.span);
        let first = Pair { span: before, ..pair.clone() }.run();
        let second = Pair { span: pair.span - before, ..pair.clone() }.run_on(&first);
        let difference = pair.difference(&second.state, &whole.state);
        prop_assert!(difference < tolerance, "{difference:e}, not {tolerance:e}");
        prop_assert_eq!(second.cell, whole.cell);
        prop_assert_eq!(first.times.len() + second.times.len(), whole.times.len());
        // The steps of a search go by the time that is left to the end, so that roundings differ.
        let apart = first.times.iter().zip(&whole.times).map(|(a, b)| (a - b).abs() / pair.span).fold(0.0, f64::max);
        prop_assert!(apart < tolerance, "events {apart:e} of the span apart, not {tolerance:e}");
        Ok(())
    });
}

#[test]
fn energy_never_rises_and_its_account_closes() {
    draw::check(draw::pair(draw::damping()), |pair| {
        let t = pair.recorded();
        let scale = t.kinetic.iter().chain(&t.strain).chain(&t.work).fold(0.0, |m: f64, x| m.max(x.abs()));
        let rounding = ROUNDINGS * f64::EPSILON * pair.ratio() * scale;
        for i in 1..t.len() {
            let rise = t.energy(i) - t.energy(i - 1);
            prop_assert!(rise <= rounding, "rises by {:e} at {}", rise / scale, t.t[i]);
        }
        let events = t.moment.iter().filter(|m| m.name() == "after").count();
        let largest = t.residual.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let allowed = rounding * (events + 4) as f64;
        prop_assert!(largest <= allowed, "residual {:e} of {scale} J after {events} events", largest / scale);
        Ok(())
    });
}
