//! The matrices of a cell.

use nalgebra::DVector;

use crate::engine::equations::Equations;
use crate::engine::error::Refusal;
use crate::engine::modal::{Matrices, inverse_root};
use crate::engine::switch::Switch;
use crate::engine::vector::{Matrix, Vector};
use crate::tolerance::modes::CANCELLED_STIFFNESS;

/// M. In a linear cell it is the same at every q.
fn constant_mass(equations: &dyn Equations) -> Matrix {
    equations.mass(&Vector::zeros(equations.coordinates()))
}

/// M, M⁻¹, C, K and f of `equations` at the law values `k`, which include the values of the present modes of `switches`.
///
/// # Errors
/// If M is not positive definite, or a number overflows.
pub fn matrices(equations: &dyn Equations, switches: &[Switch], k: &[f64]) -> Result<Matrices, Refusal> {
    let mass = constant_mass(equations);
    if mass.iter().any(|x| !x.is_finite()) {
        return Err(Refusal::Overflow);
    }
    inverse_root(&mass)?; // an error if M is not positive definite
    Ok(Matrices {
        mobility: equations.mobility(&Vector::zeros(mass.nrows())),
        mass,
        damping: equations.damping(k),
        stiffness: without_roundings(equations.stiffness(k), equations, switches, k),
        load: DVector::from(&equations.load(k)),
    })
}

/// K with zeros where forces of switches cancel those of springs up to rounding errors. With these errors, a coordinate without a spring
/// would have a very soft spring, and its mode shape would be a rounding error.
fn without_roundings(mut stiffness: Matrix, equations: &dyn Equations, switches: &[Switch], k: &[f64]) -> Matrix {
    let cancelling: Vec<(f64, &Vector)> = switches
        .iter()
        .map(|switch| (equations.lost(switch.index, k)[1].abs(), &switch.normal))
        .filter(|(slope, _)| *slope > 0.0)
        .collect();
    if !cancelling.is_empty() {
        let size = |i: usize, j: usize| cancelling.iter().map(|(slope, n)| slope * (n[i] * n[j]).abs()).sum::<f64>();
        let (rows, columns) = stiffness.shape();
        for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
            if stiffness[(i, j)].abs() <= CANCELLED_STIFFNESS * size(i, j) {
                stiffness[(i, j)] = 0.0;
            }
        }
    }
    stiffness
}
