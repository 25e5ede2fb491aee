//! The equations of a model, as the engine sees them. Written by the `equations!` macro, never by hand.
//!
//! A model with N coordinates and L laws (stiffnesses, transmission errors, friction), for one chosen set of effects: T = q'ᵀM q'/2, V(q; k), D(q'), Q.
//! What the set of effects lacks is absent from the code behind these functions, not switched off in it.

use nalgebra::{SMatrix, SVector};

use crate::engine::error::Refusal;
use crate::engine::real::Real;
use crate::model::Model;
use crate::scene::Scene;

/// The equations of one model with one set of effects and one set of numbers.
///
/// `k` holds the present value of each law [unit of the law] (L), then touch, edge, damp, clip of each dead band (4 B);
/// `dk`, `ddk` those of the laws only (L).
pub trait Equations<const N: usize>: Send + Sync {
    /// Kinetic energy T [J].
    fn kinetic(&self, q_dot: &[f64; N]) -> f64;
    /// Strain energy V [J].
    fn potential(&self, q: &[f64; N], k: &[f64]) -> f64;
    /// Rayleigh's dissipation function D [W]; 2 D is the power lost.
    fn dissipation(&self, q_dot: &[f64; N], k: &[f64]) -> f64;

    /// Work of external torque `i` over the displacement `dq` [J], as far as it is constant.
    fn torque_work(&self, i: usize, dq: &[f64; N]) -> f64;
    /// Power of external torque `i` at a state [W], as far as it depends on that.
    fn torque_power(&self, _i: usize, _q: &[f64; N], _q_dot: &[f64; N], _k: &[f64]) -> f64 {
        0.0
    }
    /// Whether any torque depends on the state.
    fn has_powers(&self) -> bool {
        false
    }
    /// Net work of all external torques over the displacement `dq` [J], balanced parts cancelled, as far as they are constant.
    fn work(&self, dq: &[f64; N]) -> f64;

    /// Generalised forces F of M q'' = F [SI], with the laws' slopes `dk` = dk/ds along their phases.
    fn force(&self, q: &[f64; N], q_dot: &[f64; N], k: &[f64], dk: &[f64]) -> [f64; N];
    /// Accelerations q'' = M⁻¹F [SI]; what asks for them again and again has M⁻¹ by itself, and [`product`].
    fn acceleration(&self, q: &[f64; N], q_dot: &[f64; N], k: &[f64], dk: &[f64]) -> [f64; N] {
        product(&self.mobility(), &self.force(q, q_dot, k, dk))
    }
    /// Derivatives of the generalised forces by q and by q' (N x N each, row = equation); `ddk` = d²k/ds².
    fn jacobian(&self, q: &[f64; N], q_dot: &[f64; N], k: &[f64], dk: &[f64], ddk: &[f64]) -> [[[f64; N]; N]; 2];

    /// Mass matrix M (N x N).
    fn mass(&self) -> [[f64; N]; N];
    /// Inverse of the mass matrix M⁻¹ (N x N). Where inertias differ by ten decades, M as numbers has lost ten digits of
    /// the smaller; the closed form that small models have in its place has all of them.
    fn mobility(&self) -> [[f64; N]; N] {
        mobility(&self.mass())
    }
    /// Damping matrix C of a cell (N x N): M q'' + C q' + K q = f.
    fn damping(&self, k: &[f64]) -> [[f64; N]; N];
    /// Stiffness matrix K of a cell (N x N).
    fn stiffness(&self, k: &[f64]) -> [[f64; N]; N];
    /// Constant load f of a cell (N).
    fn load(&self, k: &[f64]) -> [f64; N];

    /// Speeds q' of rigid motion `i` of unit size (N).
    fn motion(&self, i: usize) -> [f64; N];

    /// How law `i` switches with the effects in force.
    fn switching(&self, law: usize) -> Switching;
    /// Gradient n of the phase of law `i` (N).
    fn normal(&self, law: usize) -> [f64; N];
    /// G = nᵀM⁻¹n of law `i`.
    fn compliance(&self, law: usize) -> f64 {
        compliance(&self.mass(), &self.normal(law))
    }
    /// M⁻¹n / G of law `i` (N): the change of speeds per unit change of the normal speed.
    fn direction(&self, law: usize) -> [f64; N] {
        direction(&self.mass(), &self.normal(law))
    }
    /// dV = V(far side) - V(near side) at the same q, for a step `dk` of law `i` [J].
    fn step(&self, law: usize, q: &[f64; N], k: &[f64], dk: f64) -> f64;

    /// Dead band `i`; `None` without its effect.
    fn dead_band(&self, i: usize) -> Option<DeadBand<N>>;
}

/// Play of a deflection.
#[derive(Debug, Clone, PartialEq)]
pub struct DeadBand<const N: usize> {
    /// Gradient of the deflection (N).
    pub normal: [f64; N],
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

/// A derived model with N coordinates: what it is, and its equations for any set of effects it offers.
pub trait Derived<const N: usize>: Sync {
    /// What scenes and people read.
    const MODEL: Model;

    /// The equations with the effects of the bit set `effects` (bit i: `MODEL.effects[i]`), parameter values
    /// [SI, order of `MODEL.parameters`] and the mid value (max + min)/2 of each stiffness; `None` where the effects
    /// contradict one another.
    fn equations(effects: u32, parameters: &[f64], mids: &[f64]) -> Option<Box<dyn Equations<N>>>;

    /// The matrices of a cell with law values `k`, in numbers of the kind R; the rest as in [`Derived::equations`].
    fn matrices<R: Real>(effects: u32, parameters: &[R], mids: &[R], k: &[R]) -> Matrices<N, R>;
}

/// A linear cell, M q'' + C q' + K q = f, in numbers of the kind R.
#[derive(Debug, Clone)]
pub struct Matrices<const N: usize, R> {
    /// M (N x N).
    pub mass: [[R; N]; N],
    /// M⁻¹ (N x N), where it is known in closed form.
    pub mobility: Option<[[R; N]; N]>,
    /// C (N x N).
    pub damping: [[R; N]; N],
    /// K (N x N).
    pub stiffness: [[R; N]; N],
    /// f (N).
    pub load: [R; N],
}

/// The equations of a scene.
///
/// # Errors
/// Where its effects contradict one another.
pub fn of<D: Derived<N>, const N: usize>(scene: &Scene) -> Result<Box<dyn Equations<N>>, Refusal> {
    let mids: Vec<f64> = scene.laws.iter().map(|l| l.mid()).collect();
    let which = || scene.effects.contradictions(&D::MODEL);
    D::equations(scene.effects.0, &scene.parameters, &mids).ok_or_else(|| Refusal::Effects { which: which() })
}

/// M⁻¹F (N) of a symmetric M⁻¹.
#[inline]
pub fn product<const N: usize>(mobility: &[[f64; N]; N], force: &[f64; N]) -> [f64; N] {
    // Column by column, which vectors can hold; what is added to -0.0 is itself, at no cost.
    let mut a = [-0.0; N];
    for (column, f) in mobility.iter().zip(force) {
        for (a, w) in a.iter_mut().zip(column) {
            *a += w * f;
        }
    }
    a
}

/// Derivatives of accelerations from those of the forces, [`Equations::jacobian`]: M⁻¹ times each.
pub fn accelerated<const N: usize>(mobility: &[[f64; N]; N], of_force: &[[[f64; N]; N]; 2]) -> [[[f64; N]; N]; 2] {
    of_force.map(|by| {
        let entry = |i: usize, j: usize| (0..N).map(|l| mobility[i][l] * by[l][j]).sum();
        std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
    })
}

/// M⁻¹f, for equations too large to be solved symbolically.
///
/// # Panics
/// Where M is not positive definite, which no kinetic energy allows.
pub fn solve<const N: usize>(mass: &[[f64; N]; N], f: &[f64; N]) -> [f64; N] {
    let m = SMatrix::<f64, N, N>::from_fn(|i, j| mass[i][j]);
    let cholesky = m.cholesky().expect("the mass matrix is positive definite");
    cholesky.solve(&SVector::from(*f)).into()
}

/// M⁻¹ (N x N), for equations too large to be inverted symbolically; not a number where M is not positive definite, which
/// [`Cell::new`](crate::engine::cell::Cell::new) refuses by name.
pub fn mobility<const N: usize>(mass: &[[f64; N]; N]) -> [[f64; N]; N] {
    // In units in which the diagonal is one, inertias of any size neither overflow nor underflow in the products.
    let unit: [f64; N] = std::array::from_fn(|i| mass[i][i].sqrt());
    let m = SMatrix::<f64, N, N>::from_fn(|i, j| mass[i][j] / unit[i] / unit[j]);
    let inverse = m.cholesky().map_or(SMatrix::repeat(f64::NAN), |cholesky| cholesky.inverse());
    // Rounding must not make it asymmetric: the lower triangle stands for both.
    let lower = |i: usize, j: usize| inverse[(i, j)] / unit[i] / unit[j];
    std::array::from_fn(|i| std::array::from_fn(|j| lower(i.max(j), i.min(j))))
}

/// G = nᵀM⁻¹n.
pub fn compliance<const N: usize>(mass: &[[f64; N]; N], n: &[f64; N]) -> f64 {
    dot(n, &solve(mass, n))
}

/// M⁻¹n / G (N).
pub fn direction<const N: usize>(mass: &[[f64; N]; N], n: &[f64; N]) -> [f64; N] {
    let v = solve(mass, n);
    let g = dot(n, &v);
    v.map(|x| x / g)
}

fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
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
