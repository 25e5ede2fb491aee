//! A step as a motion: guards on its dense output, landing by the method itself.

use xprec::Df64;

use crate::engine::crossing::{Cost, SearchError, Side};
use crate::engine::hybrid::Hybrid;
use crate::engine::motion::{End, Guard, Motion, Reached};
use crate::engine::record::State;
use crate::methods::Trial;
use crate::methods::dense::Dense;
use crate::methods::flow::Flow;

use super::work::Work;
use super::{BySteps, Events};

/// A step from the state of `now`.
pub struct Step<'s, 'f> {
    pub solver: &'s mut BySteps<'f>,
    pub now: &'s Hybrid<'s>,
    /// The state at the start of the step, and its rate.
    pub start: Flow,
    pub rate: Flow,
    /// Length of the step \[s\], its trial, and its dense output.
    pub h: f64,
    pub trial: Trial,
    pub dense: Dense,
    /// The event that was found last. It is the earliest so far, because each search ends at the earliest event found before.
    pub found: Option<Found>,
    /// The work of varying torques, and the loss of switches if their forces change within a mode, from the start of the step to the end of
    /// the motion. `None` until it is needed.
    pub work: Option<Work>,
}

/// An event in a step.
#[derive(Debug, Clone, Copy)]
pub struct Found {
    pub guard: Guard,
    pub side: Side,
    /// Fraction of the step, and time \[s\].
    pub x: f64,
    pub t: f64,
}

impl Step<'_, '_> {
    /// The state of the run after the time `t` \[s\]; `y` is the state of the method there. The motion lasts at most the time `length`
    /// \[s\].
    fn reached(&mut self, y: Flow, t: f64, length: f64) -> Reached {
        let mut work = self.work(t, length);
        let by_switches = match self.now.steps_only() {
            true => self.now.lost_by_switches(&(&y.q - &self.start.q)),
            false => work.split_off(self.now.work.len()).into_iter().sum(),
        };
        let dissipated = y.lost + by_switches;
        Reached { state: State { turns: self.now.state.turns.clone(), ..State::new(y.q, y.v) }, dissipated, work }
    }

    /// The work of the varying part of each torque until the time `t` \[J\], then the energy that switches dissipate if their forces change
    /// within a mode. The times `t` and `length` are in \[s\], and `t` is at most `length`.
    fn work(&mut self, t: f64, length: f64) -> Vec<f64> {
        let torques = self.now.work.len();
        let losses = usize::from(!self.now.steps_only() && !self.now.switches.is_empty());
        if torques + losses == 0 {
            return vec![];
        }
        let (h, dense, field) = (self.h, &self.dense, &mut self.solver.field);
        let work = self.work.get_or_insert_with(|| {
            Work::new(length, torques + losses, |t, powers| {
                let (power, lost) = powers.split_at_mut(torques);
                let y = dense.at(t / h);
                field.write_power(t, &y, power);
                lost.iter_mut().for_each(|lost| *lost = field.lost_by_switches(&y));
            })
        });
        work.until(t)
    }
}

impl Motion for Step<'_, '_> {
    fn length(&self) -> f64 {
        self.h
    }

    fn first(&mut self, guard: Guard, until: f64, cost: &mut Cost) -> Result<Option<(f64, Side)>, SearchError> {
        if self.solver.settings.events == Events::AfterStep {
            return Ok(None);
        }
        let mut first = None;
        for (side, x) in self.crossings(guard, cost) {
            let t = x * self.h;
            if t < first.unwrap_or(until) {
                first = Some(t);
                self.found = Some(Found { guard, side, x, t });
            }
        }
        Ok(first.and(self.found.map(|found| (found.t, found.side))))
    }

    fn at(&mut self, t: f64) -> Reached {
        let y = if self.h > 0.0 { self.dense.at((t / self.h).clamp(0.0, 1.0)) } else { self.start.clone() };
        self.reached(y, t, self.h)
    }

    fn arrive(&mut self, t: f64, _: End, cost: &mut Cost) -> (Df64, Reached) {
        let (taken, trial) = match self.found.filter(|found| found.t == t) {
            Some(found) => self.land(found),
            None => (t, self.trial.clone()),
        };
        let end = trial.end;
        self.solver.control.reach(&end);
        self.solver.follow_energy(&end);
        self.solver.last = Some((end.clone(), trial.rate));
        self.solver.watch_stiffness(self.now.clock.now(), self.trial.stiffness);
        self.work = None;
        let reached = self.reached(end, taken, taken);
        cost.evaluations = self.solver.field.evaluations;
        (taken.into(), reached)
    }
}
