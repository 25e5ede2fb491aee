//! Properties of every motion, tested on random gear pairs: symmetries, runs in two parts, and the energy account.
//!
//! A comparison of states allows `ROUNDINGS` rounding errors per event, times two factors: the growth of a small change of the start
//! (`Pair::conditioning`) and the loss of digits of the smaller inertia in M (`Pair::ratio`). If the tolerance is then above
//! `COARSE`, the case is skipped. Properties that hold bit by bit are tested bit by bit.

mod common;
#[path = "properties/draw.rs"]
mod draw;
#[path = "common/pair.rs"]
mod pair;
#[path = "properties/scaled.rs"]
mod scaled;

use pair::{PITCH, Pair, Ran};
use proptest::prelude::*;

/// Number of rounding errors that an event may add to a state.
const ROUNDINGS: f64 = 32.0;
/// A comparison with a larger tolerance than this proves nothing.
const COARSE: f64 = 1e-6;

/// The difference allowed between two runs of a pair with `events` events.
fn tolerance(pair: &Pair, events: usize) -> f64 {
    ROUNDINGS * f64::EPSILON * pair.ratio() * (events + 4) as f64 * pair.conditioning()
}

/// The end of a run with reversed speeds, as a start. The cell is kept; this is right because an end is inside a cell, except by
/// chance.
fn reversed(end: &Ran) -> Ran {
    let mut back = end.clone();
    back.state.q_dot = -back.state.q_dot;
    back
}

/// The mirror image of a pair: every coordinate, speed and torque has the opposite sign, and the steps come in reverse order.
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
fn a_mirrored_pair_gives_mirrored_bits() {
    draw::check(draw::pair(draw::damping()), |pair| {
        // theta is compared only up to rounding errors, because its remainder is counted from the lower end of the pitch.
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
fn two_parts_of_a_run_equal_the_whole_run() {
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
        // The steps of a search depend on the time to the end of the run, so the rounding errors differ.
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
