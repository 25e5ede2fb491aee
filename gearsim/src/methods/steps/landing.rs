//! Landing: the step that meets a guard is repeated so that it ends at the guard.

use crate::engine::equations;
use crate::engine::motion::Guard;
use crate::methods::Trial;
use crate::methods::flow::Flow;
use crate::tolerance::methods::LANDING;

use super::motion::{Found, Step};

/// Largest number of steps tried in a landing.
const MOST_TRIALS: usize = 8;

impl Step<'_, '_> {
    /// The step that ends at the event `found`: its length \[s\] and its trial.
    pub(super) fn land(&mut self, found: Found) -> (f64, Trial) {
        let Found { guard, side, x, t } = found;
        if x == 0.0 {
            let (end, rate) = (self.start.clone(), self.rate.clone());
            return (0.0, Trial { end, rate, error: 0.0, stiffness: 0.0 });
        }
        let allowed = self.solver.control.allowed();
        let mut taken = t;
        for _ in 0..MOST_TRIALS {
            let super::BySteps { field, method, .. } = &mut *self.solver;
            let Some(mut trial) = method.attempt(field, &self.start, &self.rate, taken, &allowed) else { break };
            let left = field.left(guard, side, taken, &trial.end);
            if left.abs() <= self.rounding(guard) {
                return (taken, trial);
            }
            let slope = self.slope(found, taken, left, &trial);
            let dt = -left / slope;
            // If Newton's method fails (the guard does not decrease, or the correction is too long), use the root of the dense output.
            if !(slope < 0.0 && taken + dt > 0.0 && dt.abs() <= 0.5 * self.h) {
                break;
            }
            // At this distance two terms of the Taylor series are enough.
            if dt.abs() * self.solver.fastest < LANDING {
                trial.end = moved_on(&trial, dt);
                trial.rate = self.solver.field.rate(taken + dt, &trial.end);
                return (taken + dt, trial);
            }
            taken += dt;
        }
        let end = self.dense.at(x);
        let rate = self.solver.field.rate(t, &end);
        (t, Trial { end, rate, error: 0.0, stiffness: 0.0 })
    }

    /// The rate of the guard [unit of the guard/s] at the end of a trial that took the time `t` \[s\]. `left` is the value of the guard
    /// there. For a phase the rate is the negative speed towards the boundary, otherwise a difference quotient along the motion.
    fn slope(&mut self, found: Found, t: f64, left: f64, trial: &Trial) -> f64 {
        if let Guard::Phase(law) = found.guard {
            return -found.side.sign() * self.now.laws[law].surface.normal.dot(&trial.end.v);
        }
        let dt = LANDING / self.solver.fastest;
        let later = moved_on(trial, dt);
        (self.solver.field.left(found.guard, found.side, t + dt, &later) - left) / dt
    }

    /// The rounding error of a guard.
    fn rounding(&self, guard: Guard) -> f64 {
        match guard {
            Guard::Phase(law) => self.now.laws[law].rounding(),
            Guard::Exit(i, which) => equations::rounding(&self.now.guards.exits[i][which].guard, &self.now.k) / 16.0,
            Guard::Hold(which) => f64::EPSILON * self.now.left_of_hold(which).abs(),
        }
    }
}

/// The motion a short time `dt` \[s\] after the end of a trial, or before it.
fn moved_on(trial: &Trial, dt: f64) -> Flow {
    let (Flow { v, .. }, Flow { v: a, lost, .. }) = (&trial.end, &trial.rate);
    let mut moved = trial.end.clone();
    moved.q.add_times(dt, v);
    moved.q.add_times(0.5 * dt * dt, a);
    moved.v.add_times(dt, a);
    moved.lost += lost * dt;
    moved
}
