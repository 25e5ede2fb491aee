//! The additional matrices of a cell whose modes are coupled by damping: q = q_0 + X da + Y da'. The shapes Y multiply the modes'
//! speeds.
//!
//! X and Y are the two shapes of a pair of eigenvalues ([`modal::coupled`](crate::engine::modal::coupled)).

use crate::engine::cell::{Driven, Speed};
use crate::engine::modal::Coupled;
use crate::engine::vector::{Matrix, Vector};

use exponentials::Exponentials;

mod exponentials;

/// The coupling of one cell.
#[derive(Debug, Clone)]
pub struct Coupling {
    /// Y, one shape per column \[s\].
    pub shapes: Matrix,
    /// Matrix that gives forces on the modes from the speeds.
    force: Matrix,
    /// Speeds of the modes from the load, and the matrix that gives them from the coordinates.
    speed: (Vector, Matrix),
    /// Matrices that give speeds of the modes and forces on them from generalised forces.
    loading: [Matrix; 2],
    /// The dissipated energy; `None` if the two eigenvalues of a mode coincide.
    exponentials: Option<Exponentials>,
    /// X1, X2 and G in the undamped modes (m x m each, for m modes).
    modal: [Matrix; 3],
    /// Condition number of the modes [1]: a mode can be this much larger than the motion.
    pub condition: f64,
}

impl Coupling {
    /// The coupling of a cell with the modes `coupled` and the shapes Y. `force` gives forces on the modes from q'. `speed` has the speeds
    /// of the modes from the load, and the matrix that gives them from -q. `loading` gives speeds of the modes and forces on them from
    /// additional generalised forces.
    pub fn new(
        coupled: &Coupled,
        shapes: Matrix,
        force: Matrix,
        speed: (Vector, Matrix),
        loading: [Matrix; 2],
    ) -> Self {
        let modal = [&coupled.by_speed, &coupled.by_acceleration, &coupled.damping].map(Clone::clone);
        Coupling {
            shapes,
            force,
            speed,
            loading,
            exponentials: Exponentials::new(coupled),
            modal,
            condition: coupled.condition,
        }
    }

    /// Contribution of the forces at `q` to the speeds of the modes.
    pub fn speed(&self, q: &Vector) -> Vector {
        &self.speed.0 - &(&self.speed.1 * q)
    }

    /// Contribution of the speeds `q_dot` to the forces on the modes.
    pub fn force(&self, q_dot: &Vector) -> Vector {
        &self.force * q_dot
    }

    /// Contributions of the generalised forces `f` to the speeds of the modes and to the forces on them.
    pub fn push(&self, f: &Vector) -> [Vector; 2] {
        self.loading.each_ref().map(|by| by * f)
    }

    /// The matrices that give them.
    pub fn loading(&self) -> &[Matrix; 2] {
        &self.loading
    }

    /// Energy dissipated on a flight of the duration `t` \[s\] with these speeds of the modes \[J\]; `None` if the two eigenvalues of a mode
    /// coincide.
    pub fn lost(&self, speeds: &[Speed], driven: Option<&Driven>, t: f64) -> Option<f64> {
        Some(self.exponentials.as_ref()?.lost(&self.modal, speeds, driven, t))
    }

    /// Power that damping takes, from the speeds and accelerations of the modes \[W\].
    pub fn power(&self, v: &[f64], a: &[f64]) -> f64 {
        let [by_speed, by_acceleration, damping] = &self.modal;
        let u = by_speed * &Vector::from(v) + &(by_acceleration * &Vector::from(a));
        u.dot(&(damping * &u))
    }
}
