//! What a cell has more where damping couples its modes: q = q_0 + X da + Y da', shapes that follow the modes' speeds.
//!
//! X and Y are the two shapes of a pair of eigenvalues ([`modal::coupled`](crate::engine::modal::coupled)).

use crate::engine::cell::Flight;
use crate::engine::modal::Coupled;
use crate::engine::vector::{Matrix, Vector};

mod loss;

/// The coupling of one cell.
#[derive(Debug, Clone)]
pub struct Coupling {
    /// Y, a shape a column \[s\].
    pub shapes: Matrix,
    /// Forces of the modes from speeds.
    force: Matrix,
    /// Speeds of the modes from loads, and from coordinates.
    speed: (Vector, Matrix),
    /// Speeds and forces of the modes from generalised forces.
    loading: [Matrix; 2],
    /// What damping takes.
    loss: loss::Loss,
    /// X1 and X2 in undamped modes, and G there: n of each, for n <= N modes.
    modal: [Matrix; 3],
}

impl Coupling {
    /// From the modes of a cell, Y, and how forces follow q', speeds follow f and -q, both follow further forces.
    pub fn new(
        coupled: &Coupled,
        shapes: Matrix,
        force: Matrix,
        speed: (Vector, Matrix),
        loading: [Matrix; 2],
    ) -> Self {
        let modal = [&coupled.by_speed, &coupled.by_acceleration, &coupled.damping].map(Clone::clone);
        Coupling { shapes, force, speed, loading, loss: loss::Loss::new(coupled), modal }
    }

    /// What the forces at `q` add to the speeds of the modes.
    pub fn speed(&self, q: &Vector) -> Vector {
        &self.speed.0 - &(&self.speed.1 * q)
    }

    /// What the speeds `q_dot` add to the forces on the modes.
    pub fn force(&self, q_dot: &Vector) -> Vector {
        &self.force * q_dot
    }

    /// What the generalised forces `f` add to the speeds of the modes, and to the forces on them.
    pub fn push(&self, f: &Vector) -> [Vector; 2] {
        self.loading.each_ref().map(|by| by * f)
    }

    /// Energy lost to damping on a flight of the time `t` \[J\], by integration of the speeds.
    pub fn dissipated(&self, flight: &Flight<'_>, t: f64) -> f64 {
        let begin = flight.begin();
        let rates: Vec<(f64, f64)> = (0..self.modal[0].ncols()).map(|i| flight.rates(i, &begin)).collect();
        self.loss.until(&rates, t)
    }
}
