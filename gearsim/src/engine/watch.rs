//! A linear function of the state whose first zero ends a flight: the reaction of a held contact, the play left to a flank.

use crate::engine::cell::{Cell, Flight, Point};
use crate::engine::crossing::{Cost, Lost, Search};
use crate::engine::forcing::window::{TERMS, Window};
use crate::engine::record::State;
use crate::engine::root;
use crate::engine::signal::Signal;
use crate::engine::vector::Vector;

/// constant + on_q.q + on_speed.q'.
#[derive(Debug, Clone)]
pub struct Watch {
    /// Its slopes along the coordinates (N).
    pub on_q: Vector,
    /// Its slopes along the speeds (N).
    pub on_speed: Vector,
    /// Its value at rest where all coordinates are zero.
    pub constant: f64,
    /// What it may be below zero where rounding decides.
    pub slack: f64,
    /// The slopes along what the modes of a cell move, and along what speed they gain (N each).
    modal: (Vector, Option<Vector>),
}

impl Watch {
    /// A watch of motions in `cell`.
    pub fn new(cell: &Cell, constant: f64, on_q: Vector, on_speed: Vector) -> Self {
        let moves = on_speed.iter().any(|x| *x != 0.0);
        let modal = cell.follow(&on_q, moves.then_some(&on_speed));
        Watch { on_q, on_speed, constant, slack: 0.0, modal }
    }

    /// Its value in a state.
    pub fn value(&self, state: &State) -> f64 {
        self.constant + self.on_q.dot(&state.q) + self.on_speed.dot(&state.q_dot)
    }

    /// Whether its value, `value` at the start of the flight, comes to zero before the horizon; `point`, which is to be at
    /// the start, is then moved there.
    ///
    /// # Errors
    /// Where the search does not end, or leaves the numbers.
    pub fn first_zero(
        &self,
        value: f64,
        flight: &Flight<'_>,
        horizon: f64,
        point: &mut Point,
        cost: &mut Cost,
    ) -> Result<bool, Lost> {
        let (down, up) = if value >= 0.0 { (value, f64::INFINITY) } else { (f64::INFINITY, -value) };
        let signal = Signal { flight, on_moved: &self.modal.0, on_speed: self.modal.1.as_deref() };
        let search = Search { signal, rate: signal.derivatives(point)[1], down, up, horizon };
        Ok(search.first(point, cost)?.is_some())
    }

    /// The same over a window, in which its value changes with the load by `on_load`: the part of the window where it comes
    /// to zero.
    pub fn first_zero_in(&self, value: f64, on_load: &Vector, window: &Window<'_>, cost: &mut Cost) -> Option<f64> {
        let course = window.course(&self.on_q, &self.on_speed, on_load);
        let sign = if value >= 0.0 { 1.0 } else { -1.0 };
        let gap: [f64; TERMS] = std::array::from_fn(|n| sign * if n == 0 { value } else { course[n] });
        let found = root::first_of::<TERMS>(&gap, 4.0 * f64::EPSILON * value.abs());
        cost.steps += found.steps;
        found.root
    }
}
