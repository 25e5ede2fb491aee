//! The interface between a model and the engine. Its implementations are written by the `equations!` macro, never by hand.
//!
//! A model has n coordinates and L laws (stiffnesses, transmission errors, friction). For one set of effects it is given by T =
//! q'ᵀM(q) q'/2, V(q; k), D(q, q') and Q. In most models M is constant ([`Equations::is_inertia_constant`]); linear cells have constant M.
//! Terms of effects that the set does not contain are not executed.

use nalgebra::{DMatrix, DVector, Scalar};
use smallvec::SmallVec;
use xprec::Df64;

use crate::engine::error::Refusal;
pub use crate::engine::known::Known;
use crate::engine::linear_forces::LinearForces;
use crate::engine::real::Real;
use crate::engine::vector::{Matrix, Vector, dot};
use crate::model::Model;
pub use crate::model::Switching;
use crate::scene::Scene;
use crate::tolerance::events::EDGE_ROUNDING;

/// The equations of one model with one set of effects and given parameter values.
///
/// `q` and `q_dot` are coordinates and speeds (n each). `k` holds the present value of each law [unit of the law] (L), followed
/// by the values of the symbols of each switch. `dk` and `ddk` hold derivatives of the laws (L); what follows them is not read. All laws and
/// symbols of the model have a place, also those of absent effects.
///
/// # Panics
/// All functions, if the length of a vector does not match the model.
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
    /// The values of the outputs `which` at a state, as by [`Equations::output`].
    fn write_outputs(&self, which: &[usize], q: &[f64], q_dot: &[f64], k: &[f64], known: &Known, values: &mut [f64]) {
        which.iter().zip(values).for_each(|(&i, value)| *value = self.output(i, q, q_dot, k, known));
    }
    /// Net work of all external torques over the displacement `dq` \[J\]; only the parts that do not depend on the state. Torques
    /// in balance cancel.
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
    /// The forces that are linear while the values `k` do not change, with their dissipation; `None` if the model evaluates all forces
    /// together faster. The other forces are those of [`Equations::add_other_forces`].
    fn linear_forces(&self, _k: &[f64]) -> Option<LinearForces> {
        None
    }
    /// Adds the forces beside [`Equations::linear_forces`], where there are any.
    fn add_other_forces(&self, _q: &[f64], _q_dot: &[f64], _k: &[f64], _dk: &[f64], _force: &mut [f64]) {}
    /// The part of D beside [`Equations::linear_forces`] \[W\].
    fn other_dissipation(&self, _q: &[f64], _q_dot: &[f64], _k: &[f64]) -> f64 {
        0.0
    }
    /// Derivatives of the generalised forces by q and by q' (n x n each, one row per equation); `ddk` = d²k/ds².
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
    /// ten digits of the smaller ones. Small models override this function with a closed form that loses none.
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

    /// The values of the symbols of switch `i` in a mode; `None` if its effect is not in the set.
    fn mode(&self, i: usize, _mode: usize) -> Option<Vec<f64>> {
        no_such("switch", i)
    }
    /// What can end a mode of switch `i`; `k` has the values of this mode. Where deflections bend, the guards are those of their tangents
    /// at `q`, which are exact there.
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
    /// A named deflection; if it bends, its tangent at `q`.
    fn deflection(&self, i: usize, _q: &[f64], _k: &[f64]) -> Deflection {
        no_such("deflection", i)
    }
    /// Whether a named deflection is not linear in the coordinates in this set of effects.
    fn bends(&self) -> bool {
        false
    }
}

/// A named deflection, x = constant + sum(unit k\[law\]) + normal.q, in numbers of type R.
#[derive(Debug, Clone, PartialEq)]
pub struct Deflection<R: Real = f64> {
    /// Its gradient (n).
    pub normal: R::Row,
    /// Its value where the coordinates and the transmission errors are zero.
    pub constant: R,
    /// The transmission errors that shift it: index of the law, and shift per unit of the law.
    pub errors: Vec<(usize, R)>,
}

impl Deflection {
    /// Its value at the coordinates `q` and the law values `k`.
    pub fn value(&self, q: &[f64], k: &[f64]) -> f64 {
        self.constant + shift(&self.errors, k) + self.normal.dot(q)
    }
}

/// How far transmission errors shift a deflection.
fn shift<R: Real>(errors: &[(usize, R)], k: &[R]) -> R {
    errors.iter().fold(R::from(0.0), |sum, &(law, unit)| sum + unit * k[law])
}

/// What ends a mode of a switch, in numbers of type R.
#[derive(Debug, Clone, PartialEq)]
pub struct Exit<R: Real = f64> {
    /// The mode that follows.
    pub beyond: usize,
    /// Whether only a sudden change of the state can violate the guard: in every motion another exit comes first.
    pub sudden: bool,
    /// The mode lasts while this is >= 0.
    pub guard: Affine<R>,
}

/// A linear function of the state: constant + sum(unit k\[law\]) + on_q.q + on_speed.q' + on_reaction R.
#[derive(Debug, Clone, PartialEq)]
pub struct Affine<R: Real = f64> {
    /// Its value at the state zero.
    pub constant: R,
    /// The transmission errors in it: index of the law, and factor.
    pub errors: SmallVec<[(usize, R); 1]>,
    /// Its slopes along the coordinates (n).
    pub on_q: R::Row,
    /// Its slopes along the speeds (n).
    pub on_speed: R::Row,
    /// Its slope along the reaction of a held deflection.
    pub on_reaction: R,
}

impl<R: Real> Affine<R> {
    /// Zero, for `n` coordinates.
    pub fn zero(n: usize) -> Self {
        let zero = R::from(0.0);
        let none: SmallVec<[R; 16]> = SmallVec::from_elem(zero, n);
        let (on_q, on_speed) = (R::row(&none), R::row(&none));
        Affine { constant: zero, errors: SmallVec::new(), on_q, on_speed, on_reaction: zero }
    }

    /// Adds a multiple of a deflection.
    pub fn add(&mut self, factor: R, x: &Deflection<R>) {
        self.constant += factor * x.constant;
        self.errors.extend(x.errors.iter().map(|(law, unit)| (*law, factor * *unit)));
        R::add_times(&mut self.on_q, factor, &x.normal);
    }

    /// Adds a multiple of the rate of a deflection.
    pub fn add_rate(&mut self, factor: R, x: &Deflection<R>) {
        R::add_times(&mut self.on_speed, factor, &x.normal);
    }

    /// Its value at the state zero and the law values `k`.
    pub fn constant_at(&self, k: &[R]) -> R {
        self.constant + shift(&self.errors, k)
    }
}

impl Affine {
    /// Its value without the term of the reaction.
    pub fn value(&self, q: &[f64], q_dot: &[f64], k: &[f64]) -> f64 {
        self.constant_at(k) + self.on_q.dot(q) + self.on_speed.dot(q_dot)
    }

    /// The rounding error of its value near zero.
    pub fn rounding(&self, k: &[f64]) -> f64 {
        EDGE_ROUNDING * (self.constant.abs() + shift(&self.errors, k).abs())
    }
}

/// A derived model: its description, and its equations for any set of effects.
pub trait Derived: Sync {
    /// The description of the model.
    const MODEL: Model;

    /// The equations with the effects of the bit set `effects` (bit i: `MODEL.effects[i]`), the parameter values [SI, order of
    /// `MODEL.parameters`] and the mid value (max + min)/2 of each stiffness; `None` if the effects contradict one another.
    fn equations(effects: u64, parameters: &[f64], mids: &[f64]) -> Option<Box<dyn Equations>>;

    /// The matrices of a cell with law values `k`, in numbers of type R. The other arguments are those of [`Derived::equations`].
    fn matrices<R: Real>(effects: u64, parameters: &[R], mids: &[R], k: &[R]) -> Matrices<R>;

    /// The cells in double-double numbers. The arguments are those of [`Derived::equations`].
    fn exactly(effects: u64, parameters: &[Df64], mids: &[Df64]) -> Box<dyn ExactCells>;
}

/// A linear cell, M q'' + C q' + K q = f, in numbers of type R.
#[derive(Debug, Clone)]
pub struct Matrices<R> {
    /// M (n x n), which is constant in a linear cell.
    pub mass: DMatrix<R>,
    /// M⁻¹ (n x n), if a closed form is known.
    pub mobility: Option<DMatrix<R>>,
    /// C (n x n).
    pub damping: DMatrix<R>,
    /// K (n x n).
    pub stiffness: DMatrix<R>,
    /// f (n).
    pub load: DVector<R>,
    /// V where all coordinates are zero.
    pub at_zero: R,
}

/// [`Derived::equations`] of a model.
pub type EquationsOf = fn(u64, &[f64], &[f64]) -> Option<Box<dyn Equations>>;

/// [`Derived::exactly`] of a model.
pub type ExactlyOf = fn(u64, &[Df64], &[Df64]) -> Box<dyn ExactCells>;

/// The functions of a derived model as values. The engine is compiled once and calls the functions of each model by pointer.
#[derive(Debug, Clone, Copy)]
pub struct Functions {
    /// [`Derived::equations`].
    pub equations: EquationsOf,
    /// [`Derived::exactly`].
    pub exactly: ExactlyOf,
}

impl Functions {
    /// The functions of model `D`.
    pub const fn of<D: Derived>() -> Functions {
        Functions { equations: D::equations, exactly: D::exactly }
    }
}

/// The linear cells of a scene in double-double numbers; `k` are the values of laws and switches.
pub trait ExactCells {
    /// The matrices of a cell.
    fn matrices(&self, k: &[Df64]) -> Matrices<Df64>;
    /// [`Equations::potential`].
    fn potential(&self, q: &[Df64], k: &[Df64]) -> Df64;
    /// [`Equations::step`].
    fn step(&self, law: usize, q: &[Df64], k: &[Df64], dk: Df64) -> Df64;
    /// [`Equations::mode`].
    fn mode(&self, i: usize, _mode: usize) -> Option<Vec<Df64>> {
        no_such("switch", i)
    }
    /// [`Equations::exits`].
    fn exits(&self, i: usize, _mode: usize, _k: &[Df64]) -> Vec<Exit<Df64>> {
        no_such("switch", i)
    }
    /// The deflection of switch `i`.
    fn switched(&self, i: usize, _k: &[Df64]) -> Deflection<Df64> {
        no_such("switch", i)
    }
}

/// Where the equations of a scene come from: a derived model, or parts that are put together ([`train`](crate::engine::train)).
pub trait Source: Sync {
    /// The equations of a scene with these values of its parameters [SI] and mid values of its laws; `None` if its effects contradict one
    /// another.
    fn equations(&self, scene: &Scene, parameters: &[f64], mids: &[f64]) -> Option<Box<dyn Equations>>;
    /// The cells of a scene in double-double numbers.
    fn exactly<'a>(&'a self, scene: &'a Scene, parameters: Vec<Df64>, mids: Vec<Df64>) -> Box<dyn ExactCells + 'a>;
}

impl Source for Functions {
    fn equations(&self, scene: &Scene, parameters: &[f64], mids: &[f64]) -> Option<Box<dyn Equations>> {
        (self.equations)(scene.effects.0, parameters, mids)
    }

    fn exactly<'a>(&'a self, scene: &'a Scene, parameters: Vec<Df64>, mids: Vec<Df64>) -> Box<dyn ExactCells + 'a> {
        (self.exactly)(scene.effects.0, &parameters, &mids)
    }
}

/// A model as the engine knows it: its description, and the source of its equations.
#[derive(Clone, Copy)]
pub struct DerivedModel {
    /// The description of the model; of a train without its parts, which the description of a scene has.
    pub model: &'static Model,
    /// Where its equations come from.
    pub source: &'static dyn Source,
}

impl DerivedModel {
    /// The functions of model `D`.
    pub const fn of<D: Derived>() -> DerivedModel {
        DerivedModel { model: &D::MODEL, source: const { &Functions::of::<D>() } }
    }

    /// The equations of a scene.
    ///
    /// # Errors
    /// If its effects contradict one another.
    pub fn equations(&self, scene: &Scene) -> Result<Box<dyn Equations>, Refusal> {
        let mids: Vec<f64> = scene.laws.iter().map(|l| l.mid()).collect();
        let which = || scene.effects.contradictions(scene.model);
        self.source.equations(scene, &scene.parameters, &mids).ok_or_else(|| Refusal::Effects { which: which() })
    }
}

/// Derivatives of the accelerations: M⁻¹ times the derivatives of the forces, [`Equations::jacobian`].
pub fn accelerated(mobility: &Matrix, of_force: [Matrix; 2]) -> [Matrix; 2] {
    of_force.map(|by| mobility * by)
}

/// M⁻¹ (n x n), for models too large for a symbolic inverse. If M is not positive definite, the entries are NaN;
/// [`Cell::new`](crate::engine::cell::Cell::new) then refuses the scene.
pub fn mobility(mass: &Matrix) -> Matrix {
    // Scale M to a unit diagonal, so that no product overflows or underflows.
    let n = mass.nrows();
    let unit: Vec<f64> = (0..n).map(|i| mass[(i, i)].sqrt()).collect();
    let scaled = Matrix::from_fn(n, n, |i, j| mass[(i, j)] / unit[i] / unit[j]);
    let inverse = scaled.cholesky().map_or(Matrix::repeat(n, n, f64::NAN), |cholesky| cholesky.inverse());
    // The inverse must be exactly symmetric: use its lower triangle for both halves.
    let lower = |i: usize, j: usize| inverse[(i, j)] / unit[i] / unit[j];
    Matrix::from_fn(n, n, |i, j| lower(i.max(j), i.min(j)))
}

/// G = nᵀM⁻¹n; NaN if M is not positive definite.
pub fn compliance(mass: &Matrix, n: &Vector) -> f64 {
    dot(n, &solve(mass, n))
}

/// M⁻¹n / G (n); NaN if M is not positive definite.
pub fn direction(mass: &Matrix, n: &Vector) -> Vector {
    let v = solve(mass, n);
    let g = dot(n, &v);
    v.map(|x| x / g)
}

/// M⁻¹f; NaN if M is not positive definite.
fn solve(mass: &Matrix, f: &Vector) -> Vector {
    match mass.clone().cholesky() {
        Some(cholesky) => (&cholesky.solve(&DVector::from(f))).into(),
        None => f.map(|_| f64::NAN),
    }
}

/// A vector as an array of N numbers, for code compiled for a known N.
///
/// # Panics
/// If its length is not N.
#[inline]
pub fn array<R, const N: usize>(numbers: &[R]) -> &[R; N] {
    numbers.try_into().unwrap_or_else(|_| wrong_length(N, numbers.len()))
}

/// The values of the laws and symbols of a model, or the slopes of its laws, for code that knows how many there are.
///
/// # Panics
/// If there are too few.
#[inline]
pub fn values<R, const L: usize>(values: &[R]) -> &[R; L] {
    values.first_chunk().unwrap_or_else(|| too_few_values(L, values.len()))
}

#[cold]
fn too_few_values(l: usize, given: usize) -> ! {
    panic!("{l} values of laws and switches are needed, {given} are given")
}

/// [`array`], mutable.
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

/// A vector with the given entries.
pub fn vector<R: Scalar, const N: usize>(numbers: &[R; N]) -> DVector<R> {
    DVector::from_column_slice(numbers)
}

/// A matrix with the given rows.
pub fn matrix<R: Scalar, const N: usize>(rows: &[[R; N]; N]) -> DMatrix<R> {
    DMatrix::from_fn(N, N, |i, j| rows[i][j].clone())
}

/// Panics because the model has no `what` number `i`.
///
/// # Panics
/// Always.
#[cold]
pub fn no_such(what: &str, i: usize) -> ! {
    panic!("the model has no {what} number {i}")
}

mod assembly;
mod exits;
mod numbers;
pub use assembly::{add_force, add_product, add_square, add_through};
pub use exits::{On, exits, gradient, mode};
pub use numbers::numbers;

#[cfg(test)]
mod tests;
