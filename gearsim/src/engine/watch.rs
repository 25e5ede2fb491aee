//! A linear function of the state whose first zero ends a motion, as a function of the modes of a cell.

use crate::engine::cell::{Cell, Flight, Point};
use crate::engine::crossing::{Cost, Search, SearchError, Side};
use crate::engine::forcing::window::{TERMS, Window};
use crate::engine::root;
use crate::engine::signal::Signal;
use crate::engine::vector::Vector;
use crate::tolerance::events::GRAZE_DEPTH;

/// The function, by its slopes.
#[derive(Debug, Clone)]
pub struct Watch {
    /// Along the coordinates (n).
    on_q: Vector,
    /// Along the speeds (n).
    on_speed: Vector,
    /// Along the generalised forces of torques that vary (n).
    on_load: Vector,
    /// Along the displacements of the modes of a cell, and along the changes of their speeds (one per mode).
    modal: (Vector, Option<Vector>),
}

impl Watch {
    /// The function with slopes along coordinates and speeds, for motions in `cell`.
    pub fn new(cell: &Cell, [on_q, on_speed]: [Vector; 2]) -> Self {
        let none = Vector::zeros(on_q.len());
        Self::loaded(cell, [on_q, on_speed, none])
    }

    /// The function with slopes along coordinates, speeds and forces, for motions in `cell`.
    pub fn loaded(cell: &Cell, [on_q, on_speed, on_load]: [Vector; 3]) -> Self {
        let moves = on_speed.iter().any(|x| *x != 0.0);
        let modal = cell.follow(&on_q, moves.then_some(&on_speed));
        Watch { on_q, on_speed, on_load, modal }
    }

    /// The side on which the function, which has `value` at the start of the flight, becomes zero before the horizon; `None` if it does
    /// not. `point` is moved to the zero. On entry `point` must be at the start.
    ///
    /// # Errors
    /// If the search does not end, or a number overflows.
    pub fn first_zero(
        &self,
        value: f64,
        flight: &Flight<'_>,
        horizon: f64,
        point: &mut Point,
        cost: &mut Cost,
    ) -> Result<Option<Side>, SearchError> {
        let (down, up) = if value >= 0.0 { (value, f64::INFINITY) } else { (f64::INFINITY, -value) };
        let signal = Signal { flight, on_moved: &self.modal.0, on_speed: self.modal.1.as_deref() };
        let search = Search { signal, rate: signal.derivatives(point)[1], down, up, horizon };
        search.first(point, cost)
    }

    /// The same over a window. Returns the fraction of the window at which the function becomes zero.
    pub fn first_zero_in(&self, value: f64, window: &Window<'_>, cost: &mut Cost) -> Option<f64> {
        let course = window.course(&self.on_q, &self.on_speed, &self.on_load);
        let sign = if value >= 0.0 { 1.0 } else { -1.0 };
        let gap: [f64; TERMS] = std::array::from_fn(|n| sign * if n == 0 { value } else { course[n] });
        let found = root::first_of::<TERMS>(&gap, GRAZE_DEPTH * value.abs());
        cost.steps += found.steps;
        found.root
    }
}
