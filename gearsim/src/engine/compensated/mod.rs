//! The compensated mode: states, times and the constants of cells as double-double numbers, 32 digits.
//!
//! What limits a run in plain numbers is the rounding of its state at each event, amplified from there on, and that of the
//! cells' constants, which makes energy drift. The plain engine goes on deciding which boundary is met first, and on which
//! side; where it is met, the state there and the jump are then worked out anew in twice the digits. The numbers of the
//! scene are taken as they are read: the constants follow from them by the derived equations in the same arithmetic
//! (Dekker, Numer. Math. 18, 1971; Hida, Li & Bailey, ARITH-15, 2001).
//!
//! While a phase is held at a step the run is in plain numbers.

mod cell;
mod flight;
mod mode;

use nalgebra::{DMatrix, DVector};
use xprec::Df64;

use crate::engine::cells::{self, levels};
use crate::engine::crossing::{Cost, SearchError, Side};
use crate::engine::equations::Matrices;
use crate::engine::error::{Refusal, Stop};
use crate::engine::hybrid::Hybrid;
use crate::engine::jump::Passage;
use crate::engine::law;
use crate::engine::motion::{End, Guard, Motion, Reached, Solver};
use crate::engine::record;
use crate::engine::vector::Vector;

use cell::Cell;
use flight::{Flight, State};

/// A solver in plain numbers, whose results it works out anew in twice the digits.
pub struct Compensated<'a> {
    plain: Box<dyn Solver + 'a>,
    cells: Vec<Cell>,
    surfaces: Vec<Surface>,
}

/// One law's steps.
#[derive(Debug, Clone)]
struct Surface {
    /// Coordinate that is its phase.
    phase: usize,
    /// G.
    compliance: Df64,
    /// M⁻¹n / G (N).
    direction: DVector<Df64>,
    /// K per unit of the law.
    stiffness: DMatrix<Df64>,
}

impl<'a> Compensated<'a> {
    /// Continues the cells of the solver `plain` and the state `now` from their digits; `matrices` are those of a cell with
    /// given law values.
    ///
    /// # Errors
    /// If the scene has play or a transmission error, if it has too many cells, or if damping couples the modes.
    pub fn new(
        matrices: &dyn Fn(&[Df64]) -> Matrices<Df64>,
        plain: Box<dyn Solver + 'a>,
        now: &mut Hybrid<'_>,
    ) -> Result<Self, Refusal> {
        let laws = &now.laws;
        let cells = plain.cells().and_then(cells::Cells::all);
        let cells = cells.filter(|_| now.switches.is_empty() && !laws.iter().any(|law| law.is_error));
        let cells = cells.ok_or(Refusal::CompensatedCells)?;
        let rest = &now.k[laws.len()..];
        let wide = |k: Vec<f64>| k.into_iter().map(Df64::from).collect::<Vec<_>>();
        let cell = |i: usize| Cell::new(&matrices(&wide(levels(laws, i, rest))), &cells[i].cell);
        let done = (0..cells.len()).map(cell).collect::<Result<Vec<_>, _>>()?;
        let unit =
            |l: usize| wide((0..laws.len()).map(|i| f64::from(u8::from(i == l))).chain(rest.iter().copied()).collect());
        let none = matrices(&wide([&vec![0.0; laws.len()], rest].concat()));
        let surface = |l: usize| {
            let with = matrices(&unit(l));
            // Column `phase` of M⁻¹ = X Xᵀ: the phase is a coordinate, n its unit vector.
            let phase = laws[l].phase;
            let x = &done[0].shapes;
            let column = DVector::from_fn(x.nrows(), |i, _| x.row(i).dot(&x.row(phase)));
            let compliance = column[phase];
            Surface {
                phase,
                compliance,
                direction: column.map(|w| w / compliance),
                stiffness: with.stiffness - &none.stiffness,
            }
        };
        let surfaces = (0..laws.len()).map(surface).collect();
        now.state.low = Vector::zeros(now.state.q.len());
        Ok(Compensated { plain, cells: done, surfaces })
    }
}

impl Solver for Compensated<'_> {
    fn enter(&mut self, now: &mut Hybrid<'_>) -> Result<(), Refusal> {
        self.plain.enter(now)
    }

    fn solve<'s>(&'s mut self, now: &'s Hybrid<'_>, horizon: f64) -> Result<Box<dyn Motion + 's>, Stop> {
        let Compensated { plain, cells, surfaces } = self;
        let plain = plain.solve(now, horizon)?;
        // While a phase is held, the motion is in plain numbers.
        if now.contact.is_some() {
            return Ok(plain);
        }
        let flight = Flight::new(&cells[now.cell()], State::of(&now.state));
        Ok(Box::new(Refined { plain, now, flight, surfaces }))
    }

    fn rate(&self) -> f64 {
        self.plain.rate()
    }

    /// As [`Hybrid::jump`] does.
    fn jump(&self, now: &mut Hybrid<'_>, law: usize, side: Side) -> Passage {
        let State { q, q_dot } = &State::of(&now.state);
        // V is a quadratic form in q between two steps, and linear in the laws.
        let mut dv = Df64::from(0.0);
        for i in law::met(&now.laws, law, side, &now.state) {
            let stiffness = &self.surfaces[i].stiffness;
            let along = |r: usize| (0..q.len()).fold(Df64::from(0.0), |sum, c| sum + stiffness[(r, c)] * q[c]);
            let twice = (0..q.len()).fold(Df64::from(0.0), |sum, r| sum + q[r] * along(r));
            dv += twice * now.laws[i].exact_step(side) * 0.5;
        }
        let Surface { phase, compliance, direction, .. } = &self.surfaces[law];
        let v = q_dot[*phase];
        let lost = *compliance * dv * 2.0;
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
            let speed = q_dot[i] + direction[i] * gained;
            (now.state.q_dot[i], now.state.lost[i]) = (speed.hi(), speed.lo());
        }
        passage
    }
}

/// A plain motion whose end is worked out anew in twice the digits.
struct Refined<'s> {
    plain: Box<dyn Motion + 's>,
    now: &'s Hybrid<'s>,
    flight: Flight<'s>,
    surfaces: &'s [Surface],
}

impl Motion for Refined<'_> {
    fn length(&self) -> f64 {
        self.plain.length()
    }

    fn first(&mut self, guard: Guard, until: f64, cost: &mut Cost) -> Result<Option<(f64, Side)>, SearchError> {
        self.plain.first(guard, until, cost)
    }

    fn at(&mut self, t: f64) -> Reached {
        self.plain.at(t)
    }

    fn arrive(&mut self, t: f64, end: End, cost: &mut Cost) -> (Df64, Reached) {
        let (_, mut reached) = self.plain.arrive(t, end, cost);
        let clock = &self.now.clock;
        let at = |t: Df64| (t, self.flight.at(t));
        let (t, state) = match end {
            End::Step(i, side) => {
                let law = &self.now.laws[i];
                match law.next_switch() {
                    None => self.flight.meet(self.surfaces[i].phase, law.boundary(side), t),
                    Some((switch, _)) => at(clock.exactly_until(switch)),
                }
            }
            End::Run => at(clock.exactly_until(self.now.t_end)),
            End::Open | End::Hold(..) | End::Exit(..) | End::Loose(..) | End::Breakpoint => at(t.into()),
        };
        state.write(&mut reached.state);
        (t, reached)
    }
}

impl State {
    /// A state of a run, with all its digits.
    fn of(state: &record::State) -> State {
        let exact = |x: &[f64], low: &[f64]| {
            DVector::from_iterator(x.len(), x.iter().zip(low).map(|(x, low)| Df64::from(*x) + *low))
        };
        State { q: exact(&state.q, &state.low), q_dot: exact(&state.q_dot, &state.lost) }
    }

    /// Writes it to a state of a run: the rounded numbers, and what these lack.
    fn write(&self, state: &mut record::State) {
        for i in 0..self.q.len() {
            (state.q[i], state.low[i]) = (self.q[i].hi(), self.q[i].lo());
            (state.q_dot[i], state.lost[i]) = (self.q_dot[i].hi(), self.q_dot[i].lo());
        }
    }
}
