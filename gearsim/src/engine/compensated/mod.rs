//! The compensated mode: states, times and the constants of cells as double-double numbers, 32 digits.
//!
//! Two rounding errors limit a run in plain precision: that of the state at each event, which the motion amplifies, and that of the
//! constants of the cells, which makes the energy drift. The plain engine still decides which guard is met first, and on which side. The
//! state there and the jump are then computed again in double-double precision. The numbers of the scene are taken as they are read, and
//! the derived equations give the constants in the same arithmetic (Dekker, Numer. Math. 18, 1971; Hida, Li & Bailey, ARITH-15, 2001).
//!
//! Cells with uncoupled modes and constant loads are solved in closed form (`mode.rs`), others by power series (`series.rs`). The energy of
//! bounces that the plain engine neglects is neglected here too.

mod cell;
mod cells;
mod flight;
mod forces;
mod guard;
mod held;
mod mode;
mod motion;
mod series;
mod step;

use nalgebra::DVector;
use xprec::Df64;

use crate::engine::crossing::Side;
use crate::engine::equations::ExactCells;
use crate::engine::error::{Refusal, Stop};
use crate::engine::hybrid::Hybrid;
use crate::engine::jump::Passage;
use crate::engine::motion::{Motion, Solver};
use crate::engine::record;
use crate::engine::vector::Vector;

use cells::Cells;
use flight::Flight;
use forces::Forces;
use held::Late;
use motion::Refined;

/// The cells of a scene in double-double numbers.
pub struct Given<'a> {
    /// Their matrices, and the modes of switches.
    pub cells: Box<dyn ExactCells + 'a>,
    /// Generalised forces per unit of each torque that varies, in the order of [`Forcing`](crate::engine::forcing::Forcing) (n each).
    pub loads: Vec<DVector<Df64>>,
}

/// A solver in plain precision, whose results are computed again in double-double precision.
pub struct Compensated<'a> {
    plain: Box<dyn Solver + 'a>,
    given: Given<'a>,
    cells: Cells,
    /// The hold that has just ended, until the motion after it is computed.
    late: Option<Late>,
}

impl<'a> Compensated<'a> {
    /// Compensates the solver `plain`, from the state `now`.
    ///
    /// # Errors
    /// If the modes of a cell cannot be computed.
    pub fn new(given: Given<'a>, plain: Box<dyn Solver + 'a>, now: &mut Hybrid<'_>) -> Result<Self, Refusal> {
        now.state.low = Vector::zeros(now.state.q.len());
        let cells = Cells::new(&*given.cells, now)?;
        let mut solver = Compensated { plain, given, cells, late: None };
        solver.enter(now)?;
        Ok(solver)
    }
}

impl Solver for Compensated<'_> {
    fn enter(&mut self, now: &mut Hybrid<'_>) -> Result<(), Refusal> {
        self.plain.enter(now)?;
        self.cells.meet(&*self.given.cells, now)?;
        if let Some(held) = self.cells.held() {
            State::of(&now.state).at_rest(held).write(&mut now.state);
        }
        // A hold has ended a little earlier. Since then the state has moved in this mode.
        if let Some(Late { state, by }) = self.late.take() {
            let state = match self.cells.held() {
                Some(held) => state.at_rest(held),
                None => state,
            };
            flight(&self.cells, &self.given, now, (state, now.clock.0 - by)).at(by).write(&mut now.state);
        }
        Ok(())
    }

    fn solve<'s>(&'s mut self, now: &'s Hybrid<'_>, horizon: f64) -> Result<Box<dyn Motion + 's>, Stop> {
        let Compensated { plain, given, cells, late } = self;
        let plain = plain.solve(now, horizon)?;
        let flight = flight(cells, given, now, (State::of(&now.state), now.clock.0));
        Ok(Box::new(Refined { plain, now, flight, exact: &*given.cells, cells, late }))
    }

    fn rate(&self) -> f64 {
        self.plain.rate()
    }

    /// The same as [`Hybrid::jump`], in double-double precision.
    fn jump(&mut self, now: &mut Hybrid<'_>, law: usize, side: Side) -> Passage {
        let State { q, q_dot } = &State::of(&now.state);
        let dv = step::barrier(&*self.given.cells, now, law, side, q);
        let surface = self.cells.surface(law);
        let v = q_dot[now.laws[law].phase];
        let lost = surface.compliance * dv * 2.0;
        let square = v * v - lost;
        let (passage, gained) = if square.hi() < 0.0 {
            (Passage::Reflected, v * -2.0)
        } else {
            let after = square.sqrt();
            let moves = after.hi() > 0.0 || v.hi() != 0.0;
            let gained = if moves { -lost * side.sign() / (after + v.abs()) } else { Df64::from(0.0) };
            (Passage::Transmitted, gained)
        };
        for i in 0..q_dot.len() {
            let speed = q_dot[i] + surface.direction[i] * gained;
            (now.state.q_dot[i], now.state.lost[i]) = (speed.hi(), speed.lo());
        }
        passage
    }
}

/// The motion in the present mode of `now` from a state at a time \[s\].
fn flight<'s>(
    cells: &'s Cells,
    given: &'s Given<'_>,
    now: &'s Hybrid<'_>,
    (state, since): (State, Df64),
) -> Flight<'s> {
    let forces = Forces::of(now.forcing.as_deref(), &given.loads);
    let fastest = now.forcing.as_ref().map_or(0.0, |forcing| forcing.fastest());
    let flat = now.forcing.as_ref().is_none_or(|forcing| forcing.is_flat());
    Flight::new(cells.here(), state, since, (forces, fastest, flat))
}

/// A state in double-double precision.
#[derive(Debug, Clone)]
pub struct State {
    /// Coordinates without their whole pitches (n).
    pub q: DVector<Df64>,
    /// Speeds (n).
    pub q_dot: DVector<Df64>,
}

impl State {
    /// The state of a run, from the high and low parts of its numbers.
    pub fn of(state: &record::State) -> State {
        let exact = |x: &[f64], low: &[f64]| {
            let digit = |i: usize| Df64::from(x[i]) + low.get(i).copied().unwrap_or(0.0);
            DVector::from_fn(x.len(), |i, _| digit(i))
        };
        State { q: exact(&state.q, &state.low), q_dot: exact(&state.q_dot, &state.lost) }
    }

    /// The same with the held speeds at rest.
    fn at_rest(mut self, held: &held::Held) -> State {
        held.rest(&mut self);
        self
    }

    /// Writes the state to the state of a run: high and low parts of its numbers.
    fn write(&self, state: &mut record::State) {
        for i in 0..self.q.len() {
            (state.q[i], state.low[i]) = (self.q[i].hi(), self.q[i].lo());
            (state.q_dot[i], state.lost[i]) = (self.q_dot[i].hi(), self.q_dot[i].lo());
        }
    }
}
