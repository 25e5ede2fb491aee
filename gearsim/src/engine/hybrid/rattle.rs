//! Switches that rattle: they change their modes repeatedly at one time, because the guards are rounding errors.

use crate::engine::equations::Exit;
use crate::engine::switch;
use crate::tolerance::events::{DOUBLINGS, EVENTS_AT_ONE_TIME, NO_TIME};

use super::Hybrid;

impl Hybrid<'_> {
    /// Value of the guard of an exit of a switch. Before the exit a negative value is a rounding error and counts as zero.
    ///
    /// A train that starts from rest moves at first by less than the rounding errors of its state. These can make a switch rattle: it
    /// changes its mode repeatedly at one time. Such a switch changes only when its guard is violated by more than the rounding error.
    pub fn left_to(&self, exit: &Exit) -> f64 {
        exit.guard.value(&self.state.q, &self.state.q_dot, &self.k).max(0.0) + self.slack_of(exit)
    }

    /// Whether the guards of the switches have changed by at most their rounding errors in the last `dt` \[s\]. Their signs then say nothing
    /// about the side on which the deflections are. `rate` bounds the rates of the motion \[1/s\].
    pub fn has_not_moved(&self, dt: f64, rate: f64) -> bool {
        let still = |Exit { guard, .. }: &Exit| {
            let by_speed = guard.on_speed.amax() == 0.0 || dt * rate <= NO_TIME;
            by_speed && (guard.on_q.dot(&self.state.q_dot) * dt).abs() <= guard.rounding(&self.k)
        };
        dt == 0.0 || dt > 0.0 && self.guards.exits.iter().flatten().all(still)
    }

    /// What is added to the value of a guard while a switch rattles: the rounding error of the guard. It doubles with each further change, since
    /// a method by steps has larger errors.
    pub fn slack_of(&self, Exit { guard, .. }: &Exit) -> f64 {
        let (each, all) = EVENTS_AT_ONE_TIME;
        let Some(further) = self.rattle.1.checked_sub(all.min(each * self.switches.len() as u32)) else { return 0.0 };
        let rate = switch::rest(self.equations, (&self.state.q, &self.state.q_dot), &guard.on_speed);
        2f64.powi(further.min(DOUBLINGS) as i32) * (guard.rounding(&self.k) + rate)
    }
}
