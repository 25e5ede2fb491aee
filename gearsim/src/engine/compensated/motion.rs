//! A plain motion whose end is computed again in double-double precision.

use xprec::Df64;

use super::State;
use super::cells::{self, Cells};
use super::flight::Flight;
use super::guard::Guard;
use super::held::Late;
use crate::engine::crossing::{Cost, SearchError, Side};
use crate::engine::equations::ExactCells;
use crate::engine::hybrid::Hybrid;
use crate::engine::motion::{self, End, Motion, Reached};

/// The motion.
pub struct Refined<'s> {
    /// The motion in plain precision.
    pub plain: Box<dyn Motion + 's>,
    /// The state from which it begins.
    pub now: &'s Hybrid<'s>,
    /// The motion in double-double precision.
    pub flight: Flight<'s>,
    /// The guards and the modes of switches in double-double precision.
    pub exact: &'s dyn ExactCells,
    /// The present cell.
    pub cells: &'s Cells,
    /// Set if a hold ends with this motion: its end, which is earlier than the plain solver noticed.
    pub late: &'s mut Option<Late>,
}

impl Motion for Refined<'_> {
    fn length(&self) -> f64 {
        self.plain.length()
    }

    fn first(&mut self, guard: motion::Guard, until: f64, cost: &mut Cost) -> Result<Option<(f64, Side)>, SearchError> {
        self.plain.first(guard, until, cost)
    }

    fn at(&mut self, t: f64) -> Reached {
        self.plain.at(t)
    }

    fn arrive(&mut self, t: f64, end: End, cost: &mut Cost) -> (Df64, Reached) {
        let (_, mut reached) = self.plain.arrive(t, end, cost);
        let clock = &self.now.clock;
        let due = match end {
            End::Run => Some(clock.exactly_until(self.now.t_end)),
            End::Breakpoint => self.now.forcing.as_ref().map(|forcing| clock.exactly_until(forcing.next())),
            End::Step(i, _) => self.now.laws[i].next_switch().map(|(switch, _)| clock.exactly_until(switch)),
            _ => None,
        };
        let met = match (due, end) {
            (Some(due), _) => Some((due, self.flight.at(due))),
            (None, End::Step(..) | End::Exit(..)) => {
                self.guard(end, &reached).and_then(|guard| self.flight.meet(&guard, t))
            }
            (None, End::Hold(..) | End::Loose(..)) => {
                let ended = self.guard(end, &reached).and_then(|guard| self.flight.meet(&guard, t));
                // The plain solver ends a hold late if it has a margin; without a margin it may be early by a rounding error.
                let is_late =
                    ended.as_ref().is_some_and(|(ended, _)| ended.hi() >= 0.0 && (Df64::from(t) - *ended).hi() > 0.0);
                match ended {
                    Some((ended, state)) if is_late => {
                        *self.late = Some(Late { state, by: Df64::from(t) - ended });
                        None
                    }
                    ended => ended.filter(|(ended, _)| ended.hi() >= 0.0),
                }
            }
            (None, End::Open | End::Run | End::Breakpoint) => None,
        };
        let (t, state) = met.unwrap_or_else(|| (t.into(), self.flight.at(t.into())));
        state.write(&mut reached.state);
        (t, reached)
    }
}

impl Refined<'_> {
    /// The function whose zero is the given end of the motion, near the state `reached`; `None` if there is none.
    fn guard(&self, end: End, reached: &Reached) -> Option<Guard> {
        let now = self.now;
        let k = || cells::values(self.exact, &now.switches, &now.k);
        match end {
            End::Step(i, side) => {
                let law = &now.laws[i];
                Some(Guard::phase(now.state.q.len(), law.phase, law.boundary(side)))
            }
            End::Exit(i, which) => {
                let (switch, plain) = (&now.switches[i], &now.guards.exits[i][which]);
                let place = switch.exits(now.equations, &now.state.q, &now.k).iter().position(|exit| exit == plain)?;
                let (k, number) = (k(), switch.index);
                self.exact.exits(number, switch.mode, &k).get(place).map(|exit| Guard::affine(&exit.guard, &k))
            }
            _ => self.cells.held()?.guard(self.exact, now, &k(), (end, &State::of(&reached.state))),
        }
    }
}
