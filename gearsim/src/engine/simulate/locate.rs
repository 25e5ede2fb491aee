//! How a flight ends: the first boundary that a law, a dead band or a held contact meets.

use crate::engine::cell::{Flight, Point};
use crate::engine::cells::Prepared;
use crate::engine::crossing::{Cost, Lateness, Lost, Search};
use crate::engine::equations::Switching;
use crate::engine::error::Stop;
use crate::engine::signal::Signal;
use crate::engine::watch::Watch;

use super::{End, Simulation};

/// Events of flanks at one time that are more than contacts and grips that change together.
const RATTLES: u32 = 16;

impl Simulation<'_> {
    /// The cell of the pitch, and how late the phase was when it was last there.
    #[inline]
    pub(super) fn expected(&self) -> (usize, Lateness) {
        match &self.laws[..] {
            [law] => (law.cell, self.lateness[law.cell]),
            _ => (0, Lateness::default()),
        }
    }

    /// How the flight ends; `point` is moved to where.
    #[inline]
    pub(super) fn locate(
        &self,
        here: &Prepared,
        flight: &Flight<'_>,
        lateness: &mut Lateness,
        point: &mut Point,
        cost: &mut Cost,
    ) -> Result<End, Stop> {
        let lost = |lost| self.lost(lost);
        let (mut end, mut horizon) = (End::Run, self.clock.until_about(self.t_end));
        if let Some(forcing) = &self.forcing {
            (end, horizon) = forcing.horizon(&self.clock, horizon);
        }
        for (i, law) in self.laws.iter().enumerate() {
            if law.switching == Switching::Never || self.contact.as_ref().is_some_and(|c| c.holds(i)) {
                continue;
            }
            if let Some((t, side)) = law.next_switch() {
                let t = self.clock.until(t).max(0.0);
                if t < horizon {
                    (*point, end, horizon) = (flight.at(t), End::Step(i, side), t);
                }
                continue;
            }
            let (lower, upper) = law.bounds();
            let s = self.state.q[law.phase];
            let signal = Signal { flight, on_moved: &here.participation[i], on_speed: here.on_speed[i].as_deref() };
            let rate = law.surface.normal.dot(&self.state.q_dot);
            let search = Search { signal, rate, down: s - lower, up: upper - s, horizon };
            // The first law's search moves the point itself: mostly there is no other.
            if i == 0 {
                if let Some(side) = search.first_near(lateness, point, cost).map_err(lost)? {
                    (end, horizon) = (End::Step(i, side), point.t);
                }
                continue;
            }
            let mut trial = flight.begin();
            if let Some(side) = search.first(&mut trial, cost).map_err(lost)? {
                (end, horizon) = (End::Step(i, side), trial.t);
                *point = trial;
            }
        }
        if !here.bands.is_empty() || self.contact.is_some() {
            end = self.leave(here, flight, (end, horizon), point, cost).map_err(lost)?;
        }
        if matches!(end, End::Run | End::Break) {
            cost.evaluations += 1;
            flight.go(point, horizon);
        }
        Ok(end)
    }

    /// How the flight ends, which would end as `end` at the `horizon`, were there no dead bands and nothing held.
    #[inline(never)]
    fn leave(
        &self,
        here: &Prepared,
        flight: &Flight<'_>,
        (mut end, mut horizon): (End, f64),
        point: &mut Point,
        cost: &mut Cost,
    ) -> Result<End, Lost> {
        for (i, banded) in here.bands.iter().enumerate() {
            for (beyond, watch) in &banded.exits {
                let mut trial = flight.begin();
                let value = self.left_to(watch);
                if watch.first_zero(value, flight, horizon, &mut trial, cost)? {
                    (horizon, end) = (trial.t, End::Flank(i, *beyond));
                    *point = trial;
                }
            }
        }
        if let Some(contact) = &self.contact {
            let ending = contact.first_ending(flight, &self.state, horizon, point, cost)?;
            end = ending.map_or(end, |(law, ending)| End::Hold(law, ending));
        }
        Ok(end)
    }

    /// What is left of a watch. Less than nothing is rounding: the value is not negative until the exit.
    ///
    /// A train that starts from rest moves at first by less than the roundings of its state. Where these have flanks meet
    /// and part again and again without passing time, they do so only once they are beyond by more than that.
    pub(super) fn left_to(&self, watch: &Watch) -> f64 {
        let slack = if self.rattle.1 >= RATTLES { watch.slack } else { 0.0 };
        watch.value(&self.state).max(0.0) + slack
    }

    /// Why a search without an answer ends the run.
    #[cold]
    pub(super) fn lost(&self, lost: Lost) -> Stop {
        let (t, state, cell) = (self.clock.now(), self.state.describe(), self.cell());
        match lost {
            Lost::Stuck(steps) => Stop::Search { t, steps: steps as usize, state, cell },
            Lost::Overflow => Stop::NotFinite { t, state, cell },
        }
    }
}
