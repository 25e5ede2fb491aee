//! The equations of a scene as analyses see them: matrices of any size, whatever the number of coordinates.

use nalgebra::{DMatrix, SVector};

use crate::engine::cell::{self, Cell};
use crate::engine::equations::{self, Derived, Equations, Switching};
use crate::engine::error::Refusal;
use crate::engine::modal::Matrices;
use crate::engine::start;
use crate::model::Model;
use crate::scene::Scene;

/// Equations that are linear between two steps; `k` holds the present value of each law, or of
/// the stiffnesses alone, which come first: then no flank is in error. Play is taken up: every
/// dead band is in contact, its deflection counted from its edge.
pub trait System: Send + Sync {
    /// V at the coordinates `q` (n) [J].
    fn potential(&self, q: &[f64], k: &[f64]) -> f64;

    /// M, M⁻¹, C, K, f.
    ///
    /// # Errors
    /// Where the numbers make no system.
    fn matrices(&self, k: &[f64]) -> Result<Matrices, Refusal>;

    /// What a small disturbance (dq, dq') becomes after the time `t` [s] (2n x 2n), by the modes that the engine has.
    ///
    /// # Errors
    /// Those of the modes of a cell.
    fn propagator(&self, k: &[f64], t: f64) -> Result<DMatrix<f64>, Refusal>;

    /// How law `i` switches with the effects in force.
    fn switching(&self, law: usize) -> Switching;

    /// Speeds q' of rigid motion `i` of unit size (n).
    fn motion(&self, i: usize) -> Vec<f64>;

    /// The coordinates with which a scene of these equations starts (n), those in static equilibrium included.
    ///
    /// # Errors
    /// Where that equilibrium is not determined.
    fn start(&self, scene: &Scene) -> Result<Vec<f64>, Refusal>;
}

/// The system of a scene of model `D`.
///
/// # Errors
/// Where the model's cells are not linear, or its effects contradict one another.
pub fn of<D: Derived<N>, const N: usize>(scene: &Scene) -> Result<Box<dyn System>, Refusal> {
    let terms = scene.effects.nonlinear(&D::MODEL);
    if !terms.is_empty() {
        return Err(Refusal::Nonlinear { terms });
    }
    Ok(Box::new(Of(equations::of::<D, N>(scene)?, &D::MODEL)))
}

struct Of<const N: usize>(Box<dyn Equations<N>>, &'static Model);

impl<const N: usize> System for Of<N> {
    fn potential(&self, q: &[f64], k: &[f64]) -> f64 {
        let k = self.1.in_contact(k.iter().copied());
        self.0.potential(&std::array::from_fn(|i| q[i]), &k)
    }

    fn matrices(&self, k: &[f64]) -> Result<Matrices, Refusal> {
        cell::matrices(&*self.0, &self.1.in_contact(k.iter().copied()))
    }

    fn propagator(&self, k: &[f64], t: f64) -> Result<DMatrix<f64>, Refusal> {
        let cell = Cell::new(&*self.0, &self.1.in_contact(k.iter().copied()))?;
        let mut propagator = DMatrix::identity(2 * N, 2 * N);
        for column in 0..2 * N {
            let unit = |from: usize| SVector::<f64, N>::from_fn(|i, _| f64::from(u8::from(from + i == column)));
            let flight = cell.difference(&unit(0), &unit(N));
            let (dq, dv) = flight.increments(&flight.at(t));
            for i in 0..N {
                propagator[(i, column)] += dq[i];
                propagator[(N + i, column)] += dv[i];
            }
        }
        Ok(propagator)
    }

    fn switching(&self, law: usize) -> Switching {
        self.0.switching(law)
    }

    fn motion(&self, i: usize) -> Vec<f64> {
        self.0.motion(i).to_vec()
    }

    fn start(&self, scene: &Scene) -> Result<Vec<f64>, Refusal> {
        Ok(start::begin(&*self.0, scene)?.absolute().to_vec())
    }
}
