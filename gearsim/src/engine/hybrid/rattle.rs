//! Switches that rattle: they change their modes repeatedly at one time, because the values of their guards are rounding errors.

use crate::engine::equations::{self, Affine, Exit};
use crate::engine::switch;
use crate::tolerance::events::{DOUBLINGS, EDGE_ROUNDING, EVENTS_AT_ONE_TIME, NO_TIME};

use super::Hybrid;

/// The last changes of the modes of switches.
#[derive(Debug, Clone, Copy)]
pub struct Rattle {
    /// The time of the last change \[s\].
    since: f64,
    /// The number of changes since the guards last moved by more than rounding errors.
    changes: u32,
    /// Bound on the rates of the motion at the last change \[1/s\].
    rate: f64,
}

impl Default for Rattle {
    fn default() -> Self {
        Rattle { since: f64::NAN, changes: 0, rate: 0.0 }
    }
}

impl Hybrid<'_> {
    /// Value of the guard of an exit of a switch. Before the exit a negative value is a rounding error and counts as zero.
    ///
    /// A train that starts from rest moves at first by less than the rounding errors of its state. These can make a switch rattle: it
    /// changes its mode repeatedly at one time. Such a switch changes only when its guard is violated by more than the rounding error.
    pub fn left_to(&self, exit: &Exit) -> f64 {
        exit.guard.value(&self.state.q, &self.state.q_dot, &self.k).max(0.0) + self.slack_of(exit)
    }

    /// Notes a change of the mode of a switch; `rate` bounds the rates of the motion \[1/s\].
    pub fn note_change(&mut self, rate: f64) {
        let now = self.clock.now();
        let changes = if self.has_not_moved(now - self.rattle.since, rate) { self.rattle.changes + 1 } else { 0 };
        self.rattle = Rattle { since: now, changes, rate };
    }

    /// Whether the guards of the switches have changed by at most their rounding errors in the last `dt` \[s\]. Their signs then say
    /// nothing about the side on which the deflections are.
    fn has_not_moved(&self, dt: f64, rate: f64) -> bool {
        let still = |Exit { guard, .. }: &Exit| {
            let by_speed = guard.on_speed.amax() == 0.0 || dt * rate <= NO_TIME;
            by_speed && (guard.on_q.dot(&self.state.q_dot) * dt).abs() <= self.rounding(guard, rate)
        };
        dt == 0.0 || dt > 0.0 && self.guards.exits.iter().flatten().all(still)
    }

    /// The amount that is added to the value of a guard while a switch rattles: the rounding error of the guard. The amount doubles with
    /// each further change, because the error of a method by steps can be larger.
    pub fn slack_of(&self, Exit { guard, .. }: &Exit) -> f64 {
        let (each, all) = EVENTS_AT_ONE_TIME;
        let Rattle { changes, rate, .. } = self.rattle;
        let Some(further) = changes.checked_sub(all.min(each * self.switches.len() as u32)) else { return 0.0 };
        let speed = switch::rest(self.equations, (&self.state.q, &self.state.q_dot), &guard.on_speed);
        2f64.powi(further.min(DOUBLINGS) as i32) * (self.rounding(guard, rate) + speed)
    }

    /// The rounding error of a guard: of its constants, and of the largest deflection that the kinetic energy of the whole train allows.
    /// The constants alone are not sufficient: for flanks that stick, the guard is the sign of a deflection and has no constants, and
    /// without load it stays at zero. `rate` bounds the rates of the motion \[1/s\].
    pub fn rounding(&self, guard: &Affine, rate: f64) -> f64 {
        let fastest = switch::fastest(self.equations, (&self.state.q, &self.state.q_dot), &guard.on_q);
        let deflection = if rate > 0.0 { fastest / rate } else { 0.0 };
        equations::rounding(guard, &self.k) + EDGE_ROUNDING * deflection
    }
}
