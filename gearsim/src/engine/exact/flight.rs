//! The motion in closed form, in a linear cell.

use xprec::Df64;

use crate::engine::cell::{Flight, Gains, Point};
use crate::engine::cells::Prepared;
use crate::engine::crossing::{Cost, Delay, Search, SearchError, Side};
use crate::engine::forcing::Onward;
use crate::engine::hybrid::Hybrid;
use crate::engine::motion::{End, Guard, Motion, Reached};
use crate::engine::record::State;
use crate::engine::signal::Signal;
use crate::engine::vector::Vector;
use crate::engine::watch::Watch;

/// A flight from the state of `now`.
pub struct InFlight<'s> {
    now: &'s Hybrid<'s>,
    here: &'s Prepared,
    /// The functions that end the holds.
    held: &'s [Watch],
    flight: Flight<'s>,
    /// The delay of the phase at its last passage of this cell, if there is a single law.
    lateness: Option<&'s mut Delay>,
    /// The event that was found last.
    found: Option<Point>,
    /// The torques that vary.
    onward: Vec<Onward<'s>>,
    /// The energy account under torques that vary.
    gains: Option<Gains>,
}

impl<'s> InFlight<'s> {
    #[inline]
    pub fn new(
        now: &'s Hybrid<'s>,
        here: &'s Prepared,
        held: &'s [Watch],
        flight: Flight<'s>,
        lateness: Option<&'s mut Delay>,
        (onward, horizon): (Vec<Onward<'s>>, f64),
    ) -> Self {
        let gains = flight.driven().map(|driven| Gains::new(&flight, driven, &onward, horizon));
        InFlight { now, here, held, flight, lateness, found: None, onward, gains }
    }

    fn reached(&self, point: &Point, state: impl FnOnce(&State, &Vector, &Vector) -> State) -> Reached {
        let (dq, dv) = self.flight.increments(point);
        let (lost, work) = match (&self.gains, self.flight.driven()) {
            (Some(gains), Some(driven)) => gains.until(&self.flight, driven, point),
            _ => (self.flight.dissipated(point), Onward::work(&self.onward, &dq)),
        };
        let dissipated = lost + self.now.lost_by_switches(&dq);
        Reached { state: state(&self.now.state, &dq, &dv), dissipated, work }
    }
}

impl Motion for InFlight<'_> {
    fn length(&self) -> f64 {
        f64::INFINITY
    }

    #[inline]
    fn first(&mut self, guard: Guard, until: f64, cost: &mut Cost) -> Result<Option<(f64, Side)>, SearchError> {
        let InFlight { now, here, flight, .. } = self;
        let mut point = flight.begin();
        let side = match guard {
            Guard::Phase(i) => {
                let law = &now.laws[i];
                let (lower, upper) = law.bounds();
                let s = now.state.q[law.phase];
                let direct = flight.driven().and_then(|driven| {
                    let on_force = here.cell.follow_force(&law.surface.normal, None)?;
                    Some(driven.force.along(&on_force))
                });
                let (on_moved, on_speed) = (&here.participation[i], here.on_speed[i].as_deref());
                let signal = Signal { flight, on_moved, on_speed, direct: direct.as_ref() };
                let rate = law.surface.normal.dot(&now.state.q_dot);
                let search = Search { signal, rate, down: s - lower, up: upper - s, horizon: until };
                match &mut self.lateness {
                    Some(lateness) => search.first_near(lateness, &mut point, cost)?,
                    None => search.first(&mut point, cost)?,
                }
            }
            Guard::Exit(switch, which) => {
                let value = now.left_to(&now.guards.exits[switch][which]);
                here.exits[switch][which].first_zero(value, flight, until, &mut point, cost)?
            }
            Guard::Hold(which) => {
                let value = now.left_of_hold(which);
                self.held[which].first_zero(value, flight, until, &mut point, cost)?
            }
        };
        let Some(side) = side else { return Ok(None) };
        let t = point.t;
        self.found = Some(point);
        Ok(Some((t, side)))
    }

    fn at(&mut self, t: f64) -> Reached {
        self.reached(&self.flight.at(t), State::moved)
    }

    #[inline]
    fn arrive(&mut self, t: f64, _: End, cost: &mut Cost) -> (Df64, Reached) {
        let point = match self.found.take().filter(|point| point.t == t) {
            Some(point) => point,
            None => {
                cost.evaluations += 1;
                self.flight.at(t)
            }
        };
        (t.into(), self.reached(&point, State::advanced))
    }
}
