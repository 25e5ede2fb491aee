//! The equations of a scene in the form that analyses use: matrices, propagators and the start.

use crate::engine::cell::{self, Cell};
use crate::engine::equations::{DerivedModel, Equations, Switching};
use crate::engine::error::Refusal;
use crate::engine::modal::Matrices;
use crate::engine::start;
use crate::engine::vector::{Matrix, Vector};
use crate::model::Model;
use crate::scene::Scene;

/// The equations of a scene with linear cells. `k` holds the present value of each law; if it holds the stiffnesses alone, which
/// come first, the transmission errors are zero. Every switch is as without its effect: every play is in contact, and its deflection is counted from its edge.
pub struct System {
    equations: Box<dyn Equations>,
    model: &'static Model,
}

impl System {
    /// The system of a scene.
    ///
    /// # Errors
    /// If the model's cells are not linear, or its effects contradict one another.
    pub fn of(derived: &DerivedModel, scene: &Scene) -> Result<System, Refusal> {
        let terms = scene.effects.nonlinear(scene.model);
        if !terms.is_empty() {
            return Err(Refusal::Nonlinear { terms });
        }
        Ok(System { equations: derived.equations(scene)?, model: scene.model })
    }

    /// V at the coordinates `q` (n) [J].
    pub fn potential(&self, q: &[f64], k: &[f64]) -> f64 {
        self.equations.potential(q, &self.values(k))
    }

    /// M, M⁻¹, C, K, f.
    ///
    /// # Errors
    /// If M is not positive definite, or a number overflows.
    pub fn matrices(&self, k: &[f64]) -> Result<Matrices, Refusal> {
        cell::matrices(&*self.equations, &self.values(k))
    }

    /// The propagator: a small disturbance (dq, dq') at t = 0 gives its product with this matrix after the time `t` [s] (2n x
    /// 2n).
    ///
    /// # Errors
    /// Those of the modes of a cell.
    pub fn propagator(&self, k: &[f64], t: f64) -> Result<Matrix, Refusal> {
        let cell = Cell::new(&*self.equations, &self.values(k))?;
        let n = self.equations.coordinates();
        let mut propagator = Matrix::identity(2 * n, 2 * n);
        for column in 0..2 * n {
            let unit = |from: usize| Vector::from_fn(n, |i| f64::from(u8::from(from + i == column)));
            let flight = cell.difference(&unit(0), &unit(n));
            let (dq, dv) = flight.increments(&flight.at(t));
            for i in 0..n {
                propagator[(i, column)] += dq[i];
                propagator[(n + i, column)] += dv[i];
            }
        }
        Ok(propagator)
    }

    /// How law `i` switches with the effects of the scene.
    pub fn switching(&self, law: usize) -> Switching {
        self.equations.switching(law)
    }

    /// Speeds q' of rigid motion `i` of unit size (n).
    pub fn motion(&self, i: usize) -> Vector {
        self.equations.motion(i)
    }

    /// The coordinates at the start of a scene (n), including those in static equilibrium.
    ///
    /// # Errors
    /// If the forces do not determine that equilibrium.
    pub fn start(&self, scene: &Scene) -> Result<Vector, Refusal> {
        Ok(start::begin(&*self.equations, scene)?.absolute())
    }

    fn values(&self, k: &[f64]) -> Vec<f64> {
        self.model.in_contact(k.iter().copied())
    }
}
