//! A linear function of the state whose zero ends a motion, in double-double precision.

use nalgebra::{DMatrix, DVector};
use xprec::Df64;

use super::State;
use crate::engine::equations::Affine;

/// The function: a constant and slopes.
#[derive(Debug, Clone)]
pub struct Guard {
    /// Value where the coordinates, the speeds and the forces that vary are zero.
    pub constant: Df64,
    /// Slopes along the coordinates (n).
    pub on_q: DVector<Df64>,
    /// Slopes along the speeds (n).
    pub on_speed: DVector<Df64>,
    /// Slopes along the generalised forces that vary (n).
    pub on_force: DVector<Df64>,
}

impl Guard {
    /// The function q_i - `boundary` of coordinate i = `phase`, in a model with `n` coordinates.
    pub fn phase(n: usize, phase: usize, boundary: f64) -> Self {
        let zero = Df64::from(0.0);
        let none = DVector::from_element(n, zero);
        let mut on_q = none.clone();
        on_q[phase] = Df64::from(1.0);
        Guard { constant: -Df64::from(boundary), on_q, on_speed: none.clone(), on_force: none }
    }

    /// The guard of an exit at the law values `k`, without the part that depends on the reaction.
    pub fn affine(of: &Affine<Df64>, k: &[Df64]) -> Self {
        let none = DVector::from_element(of.on_q.len(), Df64::from(0.0));
        Guard { constant: of.constant_at(k), on_q: of.on_q.clone(), on_speed: of.on_speed.clone(), on_force: none }
    }

    /// The same function plus `factor` times `w`.F. The generalised forces are F = f - K q - C q', plus those that vary.
    pub fn with_forces(
        mut self,
        factor: Df64,
        w: &DVector<Df64>,
        cell: &crate::engine::equations::Matrices<Df64>,
    ) -> Self {
        self.constant += factor * dot(w, &cell.load);
        self.on_q -= cell.stiffness.transpose() * w * factor;
        self.on_speed -= cell.damping.transpose() * w * factor;
        self.on_force += w * factor;
        self
    }

    /// Its value, without forces that vary.
    pub fn value(&self, state: &State) -> Df64 {
        self.constant + dot(&self.on_q, &state.q) + dot(&self.on_speed, &state.q_dot)
    }
}

/// The product of a matrix and a vector. The product of nalgebra is optimised for large matrices.
#[inline]
pub fn product(a: &DMatrix<Df64>, x: &DVector<Df64>) -> DVector<Df64> {
    let (n, mut y) = (a.nrows(), DVector::from_element(a.nrows(), Df64::from(0.0)));
    for j in 0..a.ncols() {
        for i in 0..n {
            y[i] += a[(i, j)] * x[j];
        }
    }
    y
}

/// The product of a transposed matrix and a vector.
#[inline]
pub fn transposed(a: &DMatrix<Df64>, x: &DVector<Df64>) -> DVector<Df64> {
    let (columns, mut y) = (a.ncols(), DVector::from_element(a.ncols(), Df64::from(0.0)));
    for j in 0..columns {
        for i in 0..a.nrows() {
            y[j] += a[(i, j)] * x[i];
        }
    }
    y
}

/// The scalar product.
#[inline]
pub fn dot(a: &DVector<Df64>, b: &DVector<Df64>) -> Df64 {
    let (a, b) = (a.as_slice(), &b.as_slice()[..a.len()]);
    let mut sum = Df64::from(0.0);
    for i in 0..a.len() {
        sum += a[i] * b[i];
    }
    sum
}
