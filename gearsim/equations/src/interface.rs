//! The interface between a model and the engine. Its implementations are written by the `equations!` macro, never by hand.
//!
//! A model has n coordinates and L laws (stiffnesses, transmission errors, friction). For one set of effects it is given by the kinetic
//! energy T = q'ᵀM(q) q'/2, the strain energy V(q; k), Rayleigh's dissipation function D(q, q') and the external forces Q. In most models M
//! is constant ([`Equations::is_inertia_constant`]); linear cells have constant M. Terms of effects that the set does not contain are not
//! executed.

mod arrays;
mod assembly;
mod derived;
mod exits;
mod guard;
mod inertia;
mod numbers;

pub use arrays::{array, array_mut, matrix, no_such, values, vector};
pub use assembly::{add_force, add_product, add_square, add_through};
pub use derived::{Derived, ExactCells, Functions, Matrices};
pub use exits::{On, exits, gradient, mode};
pub use guard::{Affine, Deflection, Exit};
pub use inertia::{accelerated, compliance, direction, mobility};
pub use numbers::numbers;

use crate::known::Known;
use crate::linear_forces::LinearForces;
pub use crate::model::Switching;
use crate::vector::{Matrix, Vector};

/// The equations of one model with one set of effects and given parameter values.
///
/// `q` and `q_dot` are coordinates and speeds (n each). `k` holds the present value of each law [unit of the law] (L), followed
/// by the values of the symbols of each switch. `dk` and `ddk` hold the first and second derivatives of the laws along their phases (L);
/// further entries are not read. All laws and symbols of the model have a place in `k`, also those of absent effects.
///
/// # Panics
/// Each function panics if the length of a vector does not match the model.
pub trait Equations: Send + Sync {
    /// Number n of coordinates.
    fn coordinates(&self) -> usize;

    /// Kinetic energy T \[J\].
    fn kinetic(&self, q: &[f64], q_dot: &[f64]) -> f64;
    /// Strain energy V \[J\].
    fn potential(&self, q: &[f64], k: &[f64]) -> f64;
    /// Rayleigh's dissipation function D \[W\]; the dissipated power is 2 D.
    fn dissipation(&self, q: &[f64], q_dot: &[f64], k: &[f64]) -> f64;

    /// Work of external torque `i` over the displacement `dq` \[J\]; only the part of the torque that does not depend on the state.
    fn torque_work(&self, i: usize, dq: &[f64]) -> f64;
    /// Power of external torque `i` at a state \[W\]; only the part of the torque that depends on the state.
    fn torque_power(&self, _i: usize, _q: &[f64], _q_dot: &[f64], _k: &[f64]) -> f64 {
        0.0
    }
    /// Whether external torque `i` has a part that depends on the state.
    fn has_power(&self, _i: usize) -> bool {
        false
    }
    /// Output `i` at a state [unit of the output]; `q` are the unwrapped coordinates.
    fn output(&self, i: usize, _q: &[f64], _q_dot: &[f64], _k: &[f64], _known: &Known) -> f64 {
        no_such("output", i)
    }
    /// Writes the values of the outputs `which` at a state to `values`, as [`Equations::output`] returns them.
    fn write_outputs(&self, which: &[usize], q: &[f64], q_dot: &[f64], k: &[f64], known: &Known, values: &mut [f64]) {
        which.iter().zip(values).for_each(|(&i, value)| *value = self.output(i, q, q_dot, k, known));
    }
    /// Net work of all external torques over the displacement `dq` \[J\]; only the parts that do not depend on the state. Balanced torques
    /// cancel.
    fn work(&self, dq: &[f64]) -> f64;

    /// Writes the generalised forces F of M q'' = F \[SI\] to `force` (n), with the centrifugal and gyroscopic forces of an M that depends
    /// on q. `dk` = dk/ds are the slopes of the laws along their phases.
    fn write_force(&self, q: &[f64], q_dot: &[f64], k: &[f64], dk: &[f64], force: &mut [f64]);
    /// The generalised forces F (n), see [`Equations::write_force`].
    fn force(&self, q: &[f64], q_dot: &[f64], k: &[f64], dk: &[f64]) -> Vector {
        let mut force = Vector::zeros(q.len());
        self.write_force(q, q_dot, k, dk, &mut force);
        force
    }
    /// Accelerations q'' = M⁻¹F \[SI\] (n). Code that needs them often should keep a constant M⁻¹ instead.
    fn acceleration(&self, q: &[f64], q_dot: &[f64], k: &[f64], dk: &[f64]) -> Vector {
        &self.mobility(q) * &self.force(q, q_dot, k, dk)
    }
    /// The forces that are linear while the values `k` do not change, with their dissipation. All other forces are those of
    /// [`Equations::add_other_forces`]. `None` if it is faster to evaluate all forces of the model together.
    fn linear_forces(&self, _k: &[f64]) -> Option<LinearForces> {
        None
    }
    /// Adds to `force` the forces that [`Equations::linear_forces`] does not contain.
    fn add_other_forces(&self, _q: &[f64], _q_dot: &[f64], _k: &[f64], _dk: &[f64], _force: &mut [f64]) {}
    /// The part of D that [`Equations::linear_forces`] does not contain \[W\].
    fn other_dissipation(&self, _q: &[f64], _q_dot: &[f64], _k: &[f64]) -> f64 {
        0.0
    }
    /// The derivatives of the generalised forces by q, and those by q' (n x n each, one row for each force). `ddk` = d²k/ds².
    fn jacobian(&self, q: &[f64], q_dot: &[f64], k: &[f64], dk: &[f64], ddk: &[f64]) -> [Matrix; 2];

    /// Whether M does not depend on q in this set of effects.
    fn is_inertia_constant(&self) -> bool {
        true
    }
    /// Mass matrix M at the coordinates `q` (n x n).
    fn mass(&self, q: &[f64]) -> Matrix;
    /// Derivatives of the inertia forces M q'' (rows) by q (columns), at the accelerations `q_ddot` (n x n). They are needed for the
    /// derivatives of the accelerations: M dq''/dq = dF/dq - d(M q'')/dq.
    fn inertia(&self, q: &[f64], _q_ddot: &[f64]) -> Matrix {
        Matrix::zeros(q.len(), q.len())
    }
    /// Inverse of the mass matrix M⁻¹ at the coordinates `q` (n x n). If inertias differ by a factor of 1e10, the entries of M have lost
    /// ten digits of the smaller inertias. Small models override this function with a closed form that loses no digits.
    fn mobility(&self, q: &[f64]) -> Matrix {
        mobility(&self.mass(q))
    }
    /// Damping matrix C of a cell (n x n): M q'' + C q' + K q = f.
    fn damping(&self, k: &[f64]) -> Matrix;
    /// Stiffness matrix K of a cell (n x n).
    fn stiffness(&self, k: &[f64]) -> Matrix;
    /// Constant load f of a cell (n).
    fn load(&self, k: &[f64]) -> Vector;

    /// Speeds q' of rigid motion `i` of unit size (n).
    fn motion(&self, i: usize) -> Vector;

    /// How law `i` switches in this set of effects.
    fn switching(&self, law: usize) -> Switching;
    /// Gradient n of the phase of law `i` (n).
    fn normal(&self, law: usize) -> Vector;
    /// G = nᵀM⁻¹n of law `i` at the coordinates `q`.
    fn compliance(&self, law: usize, q: &[f64]) -> f64 {
        compliance(&self.mass(q), &self.normal(law))
    }
    /// M⁻¹n / G of law `i` at the coordinates `q` (n): the change of speeds per unit change of the normal speed.
    fn direction(&self, law: usize, q: &[f64]) -> Vector {
        direction(&self.mass(q), &self.normal(law))
    }
    /// dV = V(far side) - V(near side) at the same q, for a step `dk` of law `i` \[J\].
    fn step(&self, law: usize, q: &[f64], k: &[f64], dk: f64) -> f64;

    /// The values that the symbols of switch `i` have in a mode; `None` if the scene does not have the effect of the switch.
    fn mode(&self, i: usize, _mode: usize) -> Option<Vec<f64>> {
        no_such("switch", i)
    }
    /// The exits of a mode of switch `i`; `k` has the values of this mode. If a deflection is a nonlinear function of the coordinates, its
    /// guards are those of its tangent at `q`, which are exact at `q`.
    fn exits(&self, i: usize, _mode: usize, _q: &[f64], _k: &[f64]) -> Vec<Exit> {
        no_such("switch", i)
    }
    /// The dissipative force of switch `i` against its deflection x, f = a + b x: \[a, b\].
    fn lost(&self, i: usize, _k: &[f64]) -> [f64; 2] {
        no_such("switch", i)
    }
    /// Index of the deflection of switch `i`.
    fn switched(&self, i: usize) -> usize {
        no_such("switch", i)
    }
    /// A named deflection; if it is a nonlinear function of the coordinates, its tangent at `q`.
    fn deflection(&self, i: usize, _q: &[f64], _k: &[f64]) -> Deflection {
        no_such("deflection", i)
    }
    /// Whether, with these effects, a named deflection is a nonlinear function of the coordinates.
    fn bends(&self) -> bool {
        false
    }
}
