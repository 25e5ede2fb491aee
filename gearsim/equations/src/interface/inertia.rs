//! The inverse of the mass matrix and its products, for models without a closed form of this inverse.

use nalgebra::DVector;

use crate::vector::{Matrix, Vector, dot};

/// Derivatives of the accelerations (n x n each): M⁻¹ times the derivatives of the forces
/// ([`Equations::jacobian`](super::Equations::jacobian)).
pub fn accelerated(mobility: &Matrix, of_force: [Matrix; 2]) -> [Matrix; 2] {
    of_force.map(|by| mobility * by)
}

/// M⁻¹ (n x n), for models too large for a symbolic inverse. If M is not positive definite, the entries are NaN;
/// the engine then refuses the scene.
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
