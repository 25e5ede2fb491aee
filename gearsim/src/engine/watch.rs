//! A linear function of the state whose first zero ends a motion, as a function of the modes of a cell.

use crate::engine::cell::{Cell, Flight, Point};
use crate::engine::crossing::{Cost, Search, SearchError, Side};
use crate::engine::signal::Signal;
use crate::engine::vector::Vector;

/// The function, by its slopes.
#[derive(Debug, Clone)]
pub struct Watch {
    /// Along the generalised forces that vary (n); `None` if it does not depend on them.
    on_load: Option<Vector>,
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
        let on_speed = moves.then_some(&on_speed);
        let of_cell = cell.follow_force(&on_q, on_speed);
        let on_load = of_cell.map_or(on_load.clone(), |of_cell| of_cell + &on_load);
        Watch { on_load: (on_load.amax() > 0.0).then_some(on_load), modal: cell.follow(&on_q, on_speed) }
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
        let direct = flight.driven().and_then(|driven| Some(driven.force.along(self.on_load.as_ref()?)));
        let (on_moved, on_speed) = (&self.modal.0, self.modal.1.as_deref());
        let signal = Signal { flight, on_moved, on_speed, direct: direct.as_ref() };
        let search = Search { signal, rate: signal.derivatives(point)[1], down, up, horizon };
        search.first(point, cost)
    }
}
