//! The compensated mode: states, times and the constants of cells are double-double numbers with 32 digits.
//!
//! Two kinds of error limit a run in plain numbers. The state is rounded at each event, and the motion amplifies these errors.
//! The constants of the cells are rounded, which makes the energy drift. In the compensated mode the plain engine still decides
//! which boundary is reached first and on which side. The time of the event, the state there and the jump are then computed again
//! in double-double precision. The constants follow from the numbers of the scene by the derived equations in the same arithmetic
//! (Dekker, Numer. Math. 18, 1971; Hida, Li & Bailey, ARITH-15, 2001).
//!
//! While a phase is held at a step, the run is in plain numbers.

mod cell;
mod flight;
mod mode;

use nalgebra::{DMatrix, DVector};
use xprec::Df64;

use crate::engine::cells::{Cells, levels};
use crate::engine::crossing::Side;
use crate::engine::equations::Matrices;
use crate::engine::error::Refusal;
use crate::engine::jump::Passage;
use crate::engine::law::Law;
use crate::engine::record;

use cell::Cell;
use flight::{Flight, State};

/// The cells of a scene and its state, in double-double precision.
#[derive(Debug, Clone)]
pub struct Compensated {
    cells: Vec<Cell>,
    surfaces: Vec<Surface>,
    state: State,
}

/// The geometry of the steps of one law.
#[derive(Debug, Clone)]
struct Surface {
    /// Index of the coordinate that is its phase.
    phase: usize,
    /// G = n.M⁻¹n.
    compliance: Df64,
    /// M⁻¹n / G (N).
    direction: DVector<Df64>,
    /// Derivative of K with respect to the value of the law (N x N).
    stiffness: DMatrix<Df64>,
}

impl Compensated {
    /// Refines the plain `cells`, `laws` and `state`. `matrices` gives the matrices of a cell for given law values; `rest` are
    /// the values that follow those of the laws.
    ///
    /// # Errors
    /// If damping couples the modes.
    pub fn new(
        matrices: &dyn Fn(&[Df64]) -> Matrices<Df64>,
        cells: &Cells,
        (laws, rest): (&[Law], &[f64]),
        state: &record::State,
    ) -> Result<Self, Refusal> {
        let cells = cells.all().ok_or(Refusal::CompensatedCells)?;
        let wide = |k: Vec<f64>| k.into_iter().map(Df64::from).collect::<Vec<_>>();
        let cell = |i: usize| Cell::new(&matrices(&wide(levels(laws, i, rest))), &cells[i].cell);
        let done = (0..cells.len()).map(cell).collect::<Result<Vec<_>, _>>()?;
        let unit =
            |l: usize| wide((0..laws.len()).map(|i| f64::from(u8::from(i == l))).chain(rest.iter().copied()).collect());
        let none = matrices(&wide([&vec![0.0; laws.len()], rest].concat()));
        let surface = |l: usize| {
            let with = matrices(&unit(l));
            // M⁻¹ = X Xᵀ. The phase is a coordinate, so n is a unit vector and M⁻¹n is a column of M⁻¹.
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
        Ok(Compensated { cells: done, surfaces, state: State::of(state) })
    }

    /// Replaces the state by one in plain numbers.
    pub fn set(&mut self, state: &record::State) {
        self.state = State::of(state);
    }

    /// Sets the phase of a law to exactly its value in the plain state.
    pub fn place(&mut self, law: usize, state: &record::State) {
        let phase = self.surfaces[law].phase;
        self.state.q[phase] = Df64::from(state.q[phase]);
    }

    /// Rounds the state to plain numbers.
    pub fn round(&self, state: &mut record::State) {
        state.q.iter_mut().zip(&self.state.q).for_each(|(q, exact)| *q = exact.hi());
        state.q_dot.iter_mut().zip(&self.state.q_dot).for_each(|(v, exact)| *v = exact.hi());
    }

    /// Moves the state by the time `t` [s] in a cell; returns `t`.
    pub fn go(&mut self, cell: usize, t: Df64) -> Df64 {
        self.state = Flight::new(&self.cells[cell], self.state.clone()).at(t);
        t
    }

    /// Moves the state in a cell until the phase of a law reaches `boundary`, near the time `t` [s]; returns the exact time.
    pub fn meet(&mut self, cell: usize, law: usize, boundary: f64, t: f64) -> Df64 {
        let flight = Flight::new(&self.cells[cell], self.state.clone());
        let (t, state) = flight.meet(self.surfaces[law].phase, boundary, t);
        self.state = state;
        t
    }

    /// Changes the speeds at the step of `law` towards `side`, as [`crate::engine::jump::Surface::pass`] does. `steps` are the
    /// indices of the laws that step there, and the sizes of their steps.
    pub fn pass(&mut self, law: usize, side: Side, steps: impl Iterator<Item = (usize, Df64)>) -> Passage {
        let Surface { phase, compliance, direction, .. } = &self.surfaces[law];
        let q = &self.state.q;
        // Between two steps V is a quadratic form in q and linear in the laws.
        let dv = steps.fold(Df64::from(0.0), |sum, (l, dk)| sum + q.dot(&(&self.surfaces[l].stiffness * q)) * dk * 0.5);
        let v = self.state.q_dot[*phase];
        // v² - v+².
        let drop = *compliance * dv * 2.0;
        let square = v * v - drop;
        if square.hi() < 0.0 {
            self.state.q_dot += direction * (v * -2.0);
            return Passage::Reflected;
        }
        let after = square.sqrt();
        if after.hi() > 0.0 || v.hi() != 0.0 {
            self.state.q_dot += direction * (-drop * side.sign() / (after + v.abs()));
        }
        Passage::Transmitted
    }
}

impl State {
    fn of(state: &record::State) -> State {
        let exact = |x: &[f64]| DVector::from_iterator(x.len(), x.iter().copied().map(Df64::from));
        State { q: exact(&state.q), q_dot: exact(&state.q_dot) }
    }
}
