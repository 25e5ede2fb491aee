//! The equations of a model, as the engine sees them. Written by the `equations!` macro, never by hand.
//!
//! A model with n coordinates and L laws (stiffnesses, transmission errors, friction), for one chosen set of effects:
//! T = q'ᵀM q'/2, V(q; k), D(q'), Q. Terms of effects that the set lacks are not executed.

use nalgebra::{DMatrix, DVector, Scalar};
use xprec::Df64;

use crate::engine::error::Refusal;
use crate::engine::real::Real;
use crate::engine::vector::{Matrix, Vector, dot};
use crate::model::Model;
use crate::scene::Scene;

/// The equations of one model with one set of effects and one set of numbers.
///
/// `q` and `q_dot` are coordinates and speeds (n each). `k` holds the present value of each law [unit of the law] (L), then
/// touch, edge, damp, clip of each dead band (4 B); `dk`, `ddk` are the derivatives of the laws only (L).
///
/// # Panics
/// All functions, where a vector has another length than the model asks for.
pub trait Equations: Send + Sync {
    /// Number n of coordinates.
    fn coordinates(&self) -> usize;

    /// Kinetic energy T [J].
    fn kinetic(&self, q_dot: &[f64]) -> f64;
    /// Strain energy V [J].
    fn potential(&self, q: &[f64], k: &[f64]) -> f64;
    /// Rayleigh's dissipation function D [W]; 2 D is the power lost.
    fn dissipation(&self, q_dot: &[f64], k: &[f64]) -> f64;

    /// Work of external torque `i` over the displacement `dq` [J], as far as it is constant.
    fn torque_work(&self, i: usize, dq: &[f64]) -> f64;
    /// Power of external torque `i` at a state [W], as far as it depends on that.
    fn torque_power(&self, _i: usize, _q: &[f64], _q_dot: &[f64], _k: &[f64]) -> f64 {
        0.0
    }
    /// Whether any torque depends on the state.
    fn has_powers(&self) -> bool {
        false
    }
    /// Net work of all external torques over the displacement `dq` [J], balanced parts cancelled, as far as they are constant.
    fn work(&self, dq: &[f64]) -> f64;

    /// Writes the generalised forces F of M q'' = F [SI] to `force` (n), with the laws' slopes `dk` = dk/ds along their phases.
    fn write_force(&self, q: &[f64], q_dot: &[f64], k: &[f64], dk: &[f64], force: &mut [f64]);
    /// The generalised forces F (n), as [`Equations::write_force`] gives them.
    fn force(&self, q: &[f64], q_dot: &[f64], k: &[f64], dk: &[f64]) -> Vector {
        let mut force = Vector::zeros(q.len());
        self.write_force(q, q_dot, k, dk, &mut force);
        force
    }
    /// Accelerations q'' = M⁻¹F [SI]. Code that needs them often keeps M⁻¹ instead.
    fn acceleration(&self, q: &[f64], q_dot: &[f64], k: &[f64], dk: &[f64]) -> Vector {
        &self.mobility() * &self.force(q, q_dot, k, dk)
    }
    /// Derivatives of the generalised forces by q and by q' (n x n each, row = equation); `ddk` = d²k/ds².
    fn jacobian(&self, q: &[f64], q_dot: &[f64], k: &[f64], dk: &[f64], ddk: &[f64]) -> [Matrix; 2];

    /// Mass matrix M (n x n).
    fn mass(&self) -> Matrix;
    /// Inverse of the mass matrix M⁻¹ (n x n). Where inertias differ by ten decades, M as numbers has lost ten digits of
    /// the smaller; the closed form that small models have in its place has all of them.
    fn mobility(&self) -> Matrix {
        mobility(&self.mass())
    }
    /// Damping matrix C of a cell (n x n): M q'' + C q' + K q = f.
    fn damping(&self, k: &[f64]) -> Matrix;
    /// Stiffness matrix K of a cell (n x n).
    fn stiffness(&self, k: &[f64]) -> Matrix;
    /// Constant load f of a cell (n).
    fn load(&self, k: &[f64]) -> Vector;

    /// Speeds q' of rigid motion `i` of unit size (n).
    fn motion(&self, i: usize) -> Vector;

    /// How law `i` switches with the effects in force.
    fn switching(&self, law: usize) -> Switching;
    /// Gradient n of the phase of law `i` (n).
    fn normal(&self, law: usize) -> Vector;
    /// G = nᵀM⁻¹n of law `i`.
    fn compliance(&self, law: usize) -> f64 {
        compliance(&self.mass(), &self.normal(law))
    }
    /// M⁻¹n / G of law `i` (n): the change of speeds per unit change of the normal speed.
    fn direction(&self, law: usize) -> Vector {
        direction(&self.mass(), &self.normal(law))
    }
    /// dV = V(far side) - V(near side) at the same q, for a step `dk` of law `i` [J].
    fn step(&self, law: usize, q: &[f64], k: &[f64], dk: f64) -> f64;

    /// Dead band `i`; `None` without its effect.
    fn dead_band(&self, i: usize) -> Option<DeadBand>;
}

/// Play of a deflection.
#[derive(Debug, Clone, PartialEq)]
pub struct DeadBand {
    /// Gradient of the deflection (n).
    pub normal: Vector,
    /// Half its width [unit of the deflection].
    pub half: f64,
    /// The transmission errors that move the deflection: the law, and by how much a unit of it does.
    pub errors: Vec<(usize, f64)>,
}

/// How a stiffness law switches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Switching {
    /// It does not: the law is constant at its mid value.
    Never,
    /// Where the phase passes a step, with the impulse that conserves energy.
    WithJump,
    /// Where the phase passes a step, without the impulse (rigid kinematics).
    WithoutJump,
    /// When Omega0 t passes a step, whatever the phase does.
    ByTime,
}

/// A derived model: what it is, and its equations for any set of effects it offers.
pub trait Derived: Sync {
    /// What scenes and people read.
    const MODEL: Model;

    /// The equations with the effects of the bit set `effects` (bit i: `MODEL.effects[i]`), parameter values
    /// [SI, order of `MODEL.parameters`] and the mid value (max + min)/2 of each stiffness; `None` where the effects
    /// contradict one another.
    fn equations(effects: u64, parameters: &[f64], mids: &[f64]) -> Option<Box<dyn Equations>>;

    /// The matrices of a cell with law values `k`, in numbers of the kind R; the rest as in [`Derived::equations`].
    fn matrices<R: Real>(effects: u64, parameters: &[R], mids: &[R], k: &[R]) -> Matrices<R>;
}

/// A linear cell, M q'' + C q' + K q = f, in numbers of the kind R.
#[derive(Debug, Clone)]
pub struct Matrices<R> {
    /// M (n x n).
    pub mass: DMatrix<R>,
    /// M⁻¹ (n x n), where it is known in closed form.
    pub mobility: Option<DMatrix<R>>,
    /// C (n x n).
    pub damping: DMatrix<R>,
    /// K (n x n).
    pub stiffness: DMatrix<R>,
    /// f (n).
    pub load: DVector<R>,
}

/// [`Derived::equations`] of a model.
pub type EquationsOf = fn(u64, &[f64], &[f64]) -> Option<Box<dyn Equations>>;
/// [`Derived::matrices`] of a model, in numbers of type R.
pub type MatricesOf<R> = fn(u64, &[R], &[R], &[R]) -> Matrices<R>;

/// A derived model as a value: the engine is compiled once, and calls the functions of any model by pointer.
#[derive(Debug, Clone, Copy)]
pub struct DerivedModel {
    /// What scenes and people read.
    pub model: &'static Model,
    /// [`Derived::equations`].
    pub equations: EquationsOf,
    /// [`Derived::matrices`] in double-double numbers.
    pub exactly: MatricesOf<Df64>,
}

impl DerivedModel {
    /// Those of model `D`.
    pub const fn of<D: Derived>() -> DerivedModel {
        DerivedModel { model: &D::MODEL, equations: D::equations, exactly: D::matrices::<Df64> }
    }

    /// The equations of a scene.
    ///
    /// # Errors
    /// Where its effects contradict one another.
    pub fn equations(&self, scene: &Scene) -> Result<Box<dyn Equations>, Refusal> {
        let mids: Vec<f64> = scene.laws.iter().map(|l| l.mid()).collect();
        let which = || scene.effects.contradictions(self.model);
        (self.equations)(scene.effects.0, &scene.parameters, &mids).ok_or_else(|| Refusal::Effects { which: which() })
    }
}

/// Derivatives of accelerations from those of the forces, [`Equations::jacobian`]: M⁻¹ times each.
pub fn accelerated(mobility: &Matrix, of_force: [Matrix; 2]) -> [Matrix; 2] {
    of_force.map(|by| mobility * by)
}

/// M⁻¹ (n x n), for equations too large to be inverted symbolically; not a number where M is not positive definite, which
/// [`Cell::new`](crate::engine::cell::Cell::new) refuses by name.
pub fn mobility(mass: &Matrix) -> Matrix {
    // In units in which the diagonal is one, inertias of any size neither overflow nor underflow in the products.
    let n = mass.nrows();
    let unit: Vec<f64> = (0..n).map(|i| mass[(i, i)].sqrt()).collect();
    let scaled = Matrix::from_fn(n, n, |i, j| mass[(i, j)] / unit[i] / unit[j]);
    let inverse = scaled.cholesky().map_or(Matrix::repeat(n, n, f64::NAN), |cholesky| cholesky.inverse());
    // Rounding must not make it asymmetric: the lower triangle stands for both.
    let lower = |i: usize, j: usize| inverse[(i, j)] / unit[i] / unit[j];
    Matrix::from_fn(n, n, |i, j| lower(i.max(j), i.min(j)))
}

/// G = nᵀM⁻¹n.
///
/// # Panics
/// Where M is not positive definite, which no kinetic energy allows.
pub fn compliance(mass: &Matrix, n: &Vector) -> f64 {
    dot(n, &solve(mass, n))
}

/// M⁻¹n / G (n).
///
/// # Panics
/// Those of [`compliance`].
pub fn direction(mass: &Matrix, n: &Vector) -> Vector {
    let v = solve(mass, n);
    let g = dot(n, &v);
    v.map(|x| x / g)
}

/// M⁻¹f.
fn solve(mass: &Matrix, f: &Vector) -> Vector {
    let cholesky = mass.clone().cholesky().expect("the mass matrix is positive definite");
    (&cholesky.solve(&DVector::from(f))).into()
}

/// The n numbers of a vector, for code that knows n.
///
/// # Panics
/// Where there are more or fewer.
#[inline]
pub fn array<const N: usize>(numbers: &[f64]) -> &[f64; N] {
    numbers.try_into().unwrap_or_else(|_| wrong_length(N, numbers.len()))
}

/// The same, to be written to.
///
/// # Panics
/// Those of [`array`].
#[inline]
pub fn array_mut<const N: usize>(numbers: &mut [f64]) -> &mut [f64; N] {
    let given = numbers.len();
    numbers.try_into().unwrap_or_else(|_| wrong_length(N, given))
}

#[cold]
fn wrong_length(n: usize, given: usize) -> ! {
    panic!("the model has {n} coordinates, not {given}")
}

/// A vector of its numbers.
pub fn vector<R: Scalar, const N: usize>(numbers: &[R; N]) -> DVector<R> {
    DVector::from_column_slice(numbers)
}

/// A matrix by its rows.
pub fn matrix<R: Scalar, const N: usize>(rows: &[[R; N]; N]) -> DMatrix<R> {
    DMatrix::from_fn(N, N, |i, j| rows[i][j].clone())
}

/// Refuses an index beyond what the model has: `what` number `i`.
///
/// # Panics
/// Always.
#[cold]
pub fn no_such(what: &str, i: usize) -> ! {
    panic!("the model has no {what} number {i}")
}

#[cfg(test)]
mod tests;
