//! Detects which flanks have parted. An impact counts only if the flanks parted before it. Without load, a flank at rest at its edge can
//! separate by rounding errors, which depend on the method; this does not count as parting.

use smallvec::SmallVec;

use crate::engine::equations::{self, Affine, Exit};
use crate::engine::hybrid::Hybrid;
use crate::engine::motion::Motion;
use crate::engine::record::State;
use crate::engine::switch::{self, Guards};

/// Times at which a motion is examined, besides its start and its end [relative to its duration].
const PLACES: [f64; 3] = [0.5, 0.25, 0.75];

/// The switches that part in a `motion`. They have not parted before, and at one of the examined times they are away from the modes whose
/// entry counts, by more than rounding errors. The motion begins in the state of `now`, and ends in the state `last` after the time `t`
/// \[s\].
#[inline]
pub fn parted(now: &Hybrid<'_>, motion: &mut dyn Motion, (t, last): (f64, &State)) -> SmallVec<[usize; 2]> {
    let waits = |i: &usize| {
        let switch = &now.switches[*i];
        !switch.parted && now.guards.exits[*i].iter().any(|exit| switch.counts(exit.beyond))
    };
    let waiting = (0..now.switches.len()).filter(waits);
    waiting
        .filter(|&i| {
            is_away(now, i, &now.state, 0.0)
                || is_away(now, i, last, t)
                || PLACES.iter().any(|place| is_away(now, i, &motion.at(place * t).state, place * t))
        })
        .collect()
}

/// Forgets the parting of flanks that rest at their edges after a sudden change. Example: a step of a transmission error moves the edge
/// away from a flank at rest, and another step moves it back.
pub fn forget(now: &mut Hybrid<'_>) {
    for i in 0..now.switches.len() {
        if now.switches[i].parted && rests_at_edge(now, i) {
            now.switches[i].parted = false;
        }
    }
}

/// Whether a switch is at rest at the edge to a mode whose entry counts.
fn rests_at_edge(now: &Hybrid<'_>, switch: usize) -> bool {
    let State { q, q_dot, .. } = &now.state;
    let (exits, switch) = (&now.guards.exits[switch], &now.switches[switch]);
    exits.iter().filter(|exit| switch.counts(exit.beyond)).any(|Exit { guard, .. }| {
        let rest = switch::rest(now.equations, (q, q_dot), &guard.on_q);
        let at_edge =
            guard.value(q, q_dot, &now.k).abs() <= edge(guard, &now.k, now.clock.now() - switch.since(), rest);
        at_edge && guard.on_q.dot(q_dot).abs() <= rest
    })
}

/// Whether a switch is away from the modes whose entry counts, in a `state` that the motion reaches after the time `t` \[s\].
fn is_away(now: &Hybrid<'_>, switch: usize, state: &State, t: f64) -> bool {
    let (t, State { q, q_dot, .. }) = (now.clock.now() + t, state);
    let k = now.levels_at(state, t);
    let there = now.equations.bends().then(|| Guards::of(now.equations, &now.switches, q, &k));
    let exits = &there.as_ref().unwrap_or(&now.guards).exits[switch];
    let switch = &now.switches[switch];
    exits.iter().filter(|exit| switch.counts(exit.beyond)).all(|Exit { guard, .. }| {
        let rest = switch::rest(now.equations, (q, q_dot), &guard.on_q);
        guard.value(q, q_dot, &k) > edge(guard, &k, t - switch.since(), rest)
    })
}

/// The value of a guard up to which its deflection is at the edge: its rounding error, plus the distance covered at the rate `rest` in the
/// time `elapsed` \[s\] since the mode began. Rounding errors of the speeds move flanks at rest by less.
fn edge(guard: &Affine, k: &[f64], elapsed: f64, rest: f64) -> f64 {
    equations::rounding(guard, k) + elapsed * rest
}
