//! The damping of modes that dampers hardly reach.
//!
//! From XᵀCX the damping of a mode has an error of roundings of |X|ᵀ|C||X|. If the rate y of a damper along the mode is 1e-8 of its terms,
//! the damping y² is below this error, but the couplings with other modes, in proportion to y, are not. With C = Bᵀ S B, where each row of B
//! is the gradient of a damper, times the root of its strength, and S has its sign, the rates Y = B X have errors of roundings of |B||X|, and
//! the damping is Yᵀ S Y.

use nalgebra::{DMatrix, DVector};

use super::eigen;
use crate::tolerance::modes::{DAMPER, RATE_ROUNDINGS};

/// XᵀCX for the shapes X, from rates whose rounding errors are set to zero. `errors` are errors of X beyond its roundings (n x n).
///
/// The rate of a damper along a mode has the roundings of its terms. The rounding errors of X also mix the shapes: a mode that a damper does
/// not reach gets a part eps of the shape that it damps most strongly. Couplings by several dampers can cancel to the errors of the rates.
pub fn from_rates(c: &DMatrix<f64>, shapes: &DMatrix<f64>, errors: &DMatrix<f64>) -> DMatrix<f64> {
    let n = shapes.ncols();
    let (gradients, signs) = dampers(c);
    let mut rates = &gradients * shapes;
    let mut rounding = gradients.abs() * (shapes.abs() * (RATE_ROUNDINGS * f64::EPSILON) + errors);
    for k in 0..rates.nrows() {
        let mixed = n as f64 * f64::EPSILON * rates.row(k).amax();
        for i in 0..n {
            rounding[(k, i)] = rounding[(k, i)].max(mixed);
            if rates[(k, i)].abs() <= rounding[(k, i)] {
                rates[(k, i)] = 0.0;
            }
        }
    }
    let damping = rates.transpose() * DMatrix::from_diagonal(&signs) * &rates;
    let one_way = rates.abs().transpose() * rounding;
    DMatrix::from_fn(n, n, |i, j| {
        let cancels = i != j && damping[(i, j)].abs() <= one_way[(i, j)] + one_way[(j, i)];
        if cancels { 0.0 } else { damping[(i, j)] }
    })
}

/// B, one row for each damper, and the diagonal of S: 1, or -1 for a damper that adds energy.
fn dampers(c: &DMatrix<f64>) -> (DMatrix<f64>, DVector<f64>) {
    let n = c.nrows();
    let d = c.diagonal().map(|x| if x == 0.0 { 1.0 } else { x.abs().sqrt() });
    let (strengths, u) = eigen(DMatrix::from_fn(n, n, |i, j| c[(i, j)] / (d[i] * d[j])));
    let rounding = DAMPER * strengths.amax();
    let kept: Vec<usize> = (0..n).filter(|&k| strengths[k].abs() > rounding).collect();
    let gradients = DMatrix::from_fn(kept.len(), n, |k, i| strengths[kept[k]].abs().sqrt() * u[(i, kept[k])] * d[i]);
    (gradients, DVector::from_fn(kept.len(), |k, _| strengths[kept[k]].signum()))
}
