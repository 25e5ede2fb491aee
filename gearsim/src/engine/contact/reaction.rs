//! Reactions and the motion that remains, from M⁻¹ and the gradients N of held motions.

use nalgebra::linalg::Cholesky;
use nalgebra::{DMatrix, DVector, Dyn};

use crate::engine::vector::{Matrix, Vector};
use crate::tolerance::events::{HELD_ROUNDING, INDEPENDENT};

/// The vector N (NᵀM⁻¹N)⁻¹ d. `mobility` is M⁻¹, and `normals` is N. The result is NaN if NᵀM⁻¹N is not positive definite.
pub fn centripetal(mobility: &Matrix, normals: &DMatrix<f64>, d: &DVector<f64>) -> Vector {
    let compliance = (normals.transpose() * (mobility * normals)).cholesky();
    let force = compliance.map(|compliance| normals * compliance.solve(d));
    force.map_or_else(|| Vector::from_fn(normals.nrows(), |_| f64::NAN), |force| Vector::from(&force))
}

/// `q_dot` without the numerical errors of the held speeds Nᵀq'. `mobility` is M⁻¹, and `normals` is N.
pub fn still(mobility: &Matrix, normals: &DMatrix<f64>, q_dot: &Vector) -> Vector {
    let held = normals.transpose() * DVector::from(q_dot);
    q_dot - &(mobility * &centripetal(mobility, normals, &held))
}

/// P, and the matrix that gives the reactions from the forces (one row per hold). `mobility` is M⁻¹, and `normals` is N. The result is NaN
/// if NᵀM⁻¹N is not positive definite.
pub fn held(mobility: &Matrix, normals: &DMatrix<f64>) -> (Matrix, DMatrix<f64>) {
    let response = mobility * normals;
    let unknown = || DMatrix::repeat(normals.ncols(), normals.nrows(), f64::NAN);
    let compliance = (normals.transpose() * &response).cholesky();
    let to_reactions = compliance.map_or_else(unknown, |compliance| compliance.solve(&response.transpose()));
    (left(mobility, &response, &to_reactions), to_reactions)
}

/// The mobility of the motion that remains with holds: `mobility` - `response` `to_reactions`, where `response` is M⁻¹N. It is zero if
/// there are as many holds as coordinates. Entries that are only rounding errors are set to zero; otherwise forces would move what is held.
pub fn left(mobility: &Matrix, response: &DMatrix<f64>, to_reactions: &DMatrix<f64>) -> Matrix {
    let n = mobility.nrows();
    if response.ncols() == n {
        return Matrix::zeros(n, n);
    }
    let taken: Matrix = response * to_reactions;
    Matrix::from_fn(n, n, |i, j| {
        let left = mobility[(i, j)] - taken[(i, j)];
        let scale = (mobility[(i, i)] * mobility[(j, j)]).sqrt();
        if left.abs() <= HELD_ROUNDING * n as f64 * scale { 0.0 } else { left }
    })
}

/// Whether the last of several motions is possible while those before it are held. Each motion is given by its gradient (n).
pub fn is_free(mass: &Cholesky<f64, Dyn>, columns: &[DVector<f64>]) -> bool {
    let Some((last, before)) = columns.split_last() else { return true };
    let response = mass.solve(last);
    let alone = last.dot(&response);
    if before.is_empty() {
        return alone > 0.0;
    }
    let before = DMatrix::from_columns(before);
    let coupling = before.transpose() * &response;
    let compliance = (before.transpose() * mass.solve(&before)).cholesky();
    let rest = compliance.map(|compliance| alone - coupling.dot(&compliance.solve(&coupling)));
    rest.is_some_and(|rest| rest > INDEPENDENT * alone)
}
