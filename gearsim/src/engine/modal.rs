//! Modal analysis of M q'' + C q' + K q = f, for any ratios of inertias and of stiffnesses.
//!
//! Frequencies and shapes follow from K = L Lᵀ and M⁻¹ as the eigenvalues of LᵀM⁻¹L. They are computed by Jacobi's method, which
//! keeps the relative accuracy of small eigenvalues beside large ones (Demmel & Veselić, SIAM J. Matrix Anal. Appl. 13, 1992).
//! Rigid motions are exact: they are the null space of K, not small eigenvalues.

use nalgebra::{DMatrix, DVector};

use crate::engine::error::Refusal;
use crate::engine::mode::Mode;
use crate::tolerance::modes::{
    COUPLED_MODES, EQUAL_FREQUENCIES, JACOBI, MODAL_DAMPING_ROUNDINGS, RIGID, RIGID_MOMENTUM, UNDAMPED,
};

pub mod coupled;
mod damping;
mod pairs;
mod refine;
mod subspace;

pub use coupled::Coupled;

/// The matrices of a cell (n x n each) and its load (n).
#[derive(Debug, Clone)]
pub struct Matrices {
    /// M.
    pub mass: DMatrix<f64>,
    /// M⁻¹. It is given separately, because a closed form has more digits than the inverse of M.
    pub mobility: DMatrix<f64>,
    /// C.
    pub damping: DMatrix<f64>,
    /// K.
    pub stiffness: DMatrix<f64>,
    /// f.
    pub load: DVector<f64>,
}

/// Modes with mass-normalised shapes X, Xᵀ M X = 1: q = X xi. Rigid modes come first, the others in order of rising frequency.
#[derive(Debug, Clone)]
pub struct Modal {
    /// The modes (n), without the damping between different modes.
    pub modes: Vec<Mode>,
    /// X, one shape per column.
    pub shapes: DMatrix<f64>,
    /// Xᵀ M.
    pub momentum: DMatrix<f64>,
    /// Xᵀ K, zero for rigid modes.
    pub springs: DMatrix<f64>,
    /// Xᵀ f.
    pub load: DVector<f64>,
    /// The modes of the damped system, if damping couples the modes above.
    pub coupled: Option<Coupled>,
}

impl Modal {
    /// The modes of a cell.
    ///
    /// # Errors
    /// If M is not positive definite, K is not positive semidefinite, a number overflows, or the damped modes are defective.
    pub fn of(m: &Matrices) -> Result<Modal, Refusal> {
        Modal::watched(m, &|| {})
    }

    /// The same; `watch` is called for each pair of modes that damping couples.
    ///
    /// # Errors
    /// As [`Modal::of`].
    pub fn watched(m: &Matrices, watch: &dyn Fn()) -> Result<Modal, Refusal> {
        let n = m.load.len();
        let matrices = [&m.mass, &m.mobility, &m.damping, &m.stiffness];
        if matrices.iter().any(|a| a.iter().any(|x| !x.is_finite())) || m.load.iter().any(|x| !x.is_finite()) {
            return Err(Refusal::Overflow);
        }
        // K = D U diag(k) Uᵀ D, where D has the square roots of the diagonal of K.
        let d = m.stiffness.diagonal().map(|x| if x > 0.0 { x.sqrt() } else { 1.0 });
        let scaled = DMatrix::from_fn(n, n, |i, j| m.stiffness[(i, j)] / (d[i] * d[j]));
        let (k, u) = eigen(scaled);
        if let Some(worst) = k.iter().copied().filter(|k| *k < -RIGID).reduce(f64::min) {
            return Err(Refusal::Unstable { omega2: worst * d.amax().powi(2) * m.mobility.diagonal().amax() });
        }
        let column = |i: usize| DVector::from_fn(n, |row, _| u[(row, i)]);
        let (elastic, rigid): (Vec<usize>, Vec<usize>) = (0..n).partition(|&i| k[i] > RIGID);

        let (mut shapes, mut momentum) = (DMatrix::zeros(n, n), DMatrix::zeros(n, n));
        let mut omega2 = vec![0.0; n];
        if !rigid.is_empty() {
            let z = DMatrix::from_columns(&rigid.iter().map(|&i| column(i).component_div(&d)).collect::<Vec<_>>());
            let inverse = inverse_root(&(z.transpose() * &m.mass * &z))?;
            let x = z * inverse.transpose();
            // Entries that cancel to rounding errors are set to zero, so that a rigid motion at rest is not excited by the other motions.
            let (rows, sizes) = (x.transpose() * &m.mass, x.abs().transpose() * m.mass.abs());
            let rows = rows.zip_map(&sizes, |x, size| if x.abs() <= RIGID_MOMENTUM * size { 0.0 } else { x });
            momentum.rows_mut(0, rigid.len()).copy_from(&rows);
            shapes.columns_mut(0, rigid.len()).copy_from(&x);
        }
        if !elastic.is_empty() {
            let l = DMatrix::from_columns(
                &elastic.iter().map(|&i| column(i).component_mul(&d) * k[i].sqrt()).collect::<Vec<_>>(),
            );
            let (squares, y) = eigen(l.transpose() * &m.mobility * &l);
            if squares.iter().any(|w| *w <= 0.0) {
                return Err(Refusal::Mass);
            }
            let y = y * DMatrix::from_diagonal(&squares.map(|w| 1.0 / w.sqrt()));
            momentum.rows_mut(rigid.len(), elastic.len()).copy_from(&(y.transpose() * l.transpose()));
            shapes.columns_mut(rigid.len(), elastic.len()).copy_from(&(&m.mobility * l * y));
            omega2[rigid.len()..].copy_from_slice(squares.as_slice());
        }
        rotate_coincident(&omega2, &m.damping, &mut shapes, &mut momentum);

        let damping = shapes.transpose() * &m.damping * &shapes;
        let rounding =
            MODAL_DAMPING_ROUNDINGS * f64::EPSILON * (shapes.abs().transpose() * m.damping.abs() * shapes.abs());
        let mut errors = DMatrix::zeros(n, n);
        for i in 0..rigid.len() {
            errors.set_column(i, &error_of_rigid(&shapes.column(i).into_owned(), m, (&d, &k, &u)));
        }
        let own = (errors.transpose() * m.damping.abs() * &errors).diagonal();
        let hardly = damping::from_rates(&m.damping, &shapes, &errors);
        let significant = significant(&omega2, [&damping, &hardly], &rounding, own.as_slice());
        let modes = damped(&omega2, &significant)?;
        let coupled = if couples(&significant) { Some(Coupled::of(&omega2, &significant, watch)?) } else { None };
        // Xᵀ K = omega² Xᵀ M.
        let springs = DMatrix::from_fn(n, n, |i, j| omega2[i] * momentum[(i, j)]);
        let load = shapes.transpose() * &m.load;
        Ok(Modal { modes, shapes, momentum, springs, load, coupled })
    }
}

/// Rotates the modes of equal frequencies so that damping does not couple them.
fn rotate_coincident(omega2: &[f64], damping: &DMatrix<f64>, shapes: &mut DMatrix<f64>, momentum: &mut DMatrix<f64>) {
    let mut first = 0;
    for i in 1..=omega2.len() {
        if i < omega2.len() && omega2[i] <= omega2[first] * (1.0 + EQUAL_FREQUENCIES) {
            continue;
        }
        let size = i - first;
        if size > 1 {
            let x = shapes.columns(first, size).into_owned();
            let (_, turn) = eigen(x.transpose() * damping * &x);
            shapes.columns_mut(first, size).copy_from(&(x * &turn));
            let rows = turn.transpose() * momentum.rows(first, size);
            momentum.rows_mut(first, size).copy_from(&rows);
        }
        first = i;
    }
}

/// Whether damping couples two modes by more than the rounding errors.
fn couples(damping: &DMatrix<f64>) -> bool {
    let n = damping.nrows();
    (0..n).flat_map(|i| (0..i).map(move |j| (i, j))).any(|(i, j)| {
        let within = (damping[(i, i)] * damping[(j, j)]).abs().sqrt();
        damping[(i, j)].abs() > COUPLED_MODES * within
    })
}

/// The error of a rigid shape x (n). The scaled stiffness matrix, with the square roots `d` of the diagonal of K as scales, has the eigenvalues
/// `k` and the eigenvectors `u`. Its rounding errors mix a part of each elastic eigenvector into the rigid shape, which is large if this
/// eigenvalue is small.
fn error_of_rigid(
    x: &DVector<f64>,
    m: &Matrices,
    (d, k, u): (&DVector<f64>, &DVector<f64>, &DMatrix<f64>),
) -> DVector<f64> {
    let stiff = (0..x.len()).filter(|&i| m.stiffness[(i, i)] > 0.0);
    let eps = x.len() as f64 * f64::EPSILON * stiff.map(|i| (d[i] * x[i]).abs()).fold(0.0, f64::max);
    let mut mixed = DVector::zeros(x.len());
    for j in (0..k.len()).filter(|&j| k[j] > RIGID) {
        mixed += u.column(j).abs() * (eps * k.amax() / k[j]);
    }
    mixed.component_div(d)
}

/// The modal damping without its rounding errors, exactly symmetric. `own` is the damping of each mode that the errors of its shape can
/// cause. The damping is given as XᵀCX, and from the rates of the dampers ([`damping`]). The second is taken for vibrations whose damping
/// is a rounding error in the first.
///
/// The rounding errors of C, transformed with X, are known for each entry: `rounding`. The rounding errors of X mix the shapes. A
/// mode on which no damper acts gets a part eps of the most strongly damped shape; this gives it a damping of eps² and couplings
/// of eps. Modes of equal frequencies were rotated until damping does not couple them, and their dampings have an error of eps
/// times the largest among them.
fn significant(
    omega2: &[f64],
    [damping, hardly]: [&DMatrix<f64>; 2],
    rounding: &DMatrix<f64>,
    own: &[f64],
) -> DMatrix<f64> {
    let n = damping.nrows();
    let mixed = (n as f64 * f64::EPSILON).powi(2) * damping.diagonal().amax();
    let turned = |i: usize| {
        let same = |j: &usize| (omega2[*j] - omega2[i]).abs() <= EQUAL_FREQUENCIES * omega2[i];
        n as f64 * f64::EPSILON * (0..n).filter(|j| *j != i).filter(same).map(|j| damping[(j, j)]).fold(0.0, f64::max)
    };
    let is_rounding = |i: usize| damping[(i, i)] <= rounding[(i, i)].max(mixed).max(turned(i)).max(own[i]);
    // The strongest damper acts on shape i because of the error of this shape, and on shape j.
    let between = |i: usize, j: usize| (mixed * damping[(i, i)].max(damping[(j, j)])).sqrt();
    DMatrix::from_fn(n, n, |i, j| {
        if is_rounding(i) || is_rounding(j) {
            // A rigid motion that dampers hardly reach is free: its rates are errors of its shape.
            let vibrates = omega2[i] > 0.0 && omega2[j] > 0.0;
            return if vibrates { 0.5 * (hardly[(i, j)] + hardly[(j, i)]) } else { 0.0 };
        }
        let mean = 0.5 * (damping[(i, j)] + damping[(j, i)]);
        let error = if i == j { rounding[(i, i)] } else { rounding[(i, j)].max(between(i, j)) };
        if mean.abs() <= error { 0.0 } else { mean }
    })
}

fn damped(omega2: &[f64], damping: &DMatrix<f64>) -> Result<Vec<Mode>, Refusal> {
    let (strongest, n) = (damping.diagonal().amax(), omega2.len());
    // An undamped mode must keep its energy, so rounding errors must not damp it.
    let sigma = |i: usize| if damping[(i, i)] <= UNDAMPED * strongest { 0.0 } else { 0.5 * damping[(i, i)] };
    let modes: Vec<Mode> = (0..n).map(|i| Mode::new(sigma(i), omega2[i])).collect();
    if modes.iter().any(|m| !(m.rate * m.rate * m.rate).is_finite()) {
        return Err(Refusal::Overflow);
    }
    Ok(modes)
}

/// L⁻¹ of A = L Lᵀ. A is scaled to a unit diagonal first, so that entries of any ratio keep their digits.
///
/// # Errors
/// If A is not positive definite.
pub fn inverse_root(a: &DMatrix<f64>) -> Result<DMatrix<f64>, Refusal> {
    if a.diagonal().iter().any(|d| *d <= 0.0) {
        return Err(Refusal::Mass);
    }
    let d = a.diagonal().map(f64::sqrt);
    let scaled = DMatrix::from_fn(a.nrows(), a.ncols(), |i, j| a[(i, j)] / (d[i] * d[j]));
    let l = scaled.cholesky().ok_or(Refusal::Mass)?.l();
    let inverse = l.solve_lower_triangular(&DMatrix::identity(a.nrows(), a.ncols())).ok_or(Refusal::Mass)?;
    Ok(inverse * DMatrix::from_diagonal(&d.map(|d| 1.0 / d)))
}

/// Eigenvalues, in rising order, and eigenvectors of a symmetric matrix by Jacobi's cyclic method.
fn eigen(mut a: DMatrix<f64>) -> (DVector<f64>, DMatrix<f64>) {
    let n = a.nrows();
    let mut v = DMatrix::identity(n, n);
    for _ in 0..MOST_SWEEPS {
        let mut turned = false;
        for p in 0..n {
            for q in p + 1..n {
                let (app, aqq, apq) = (a[(p, p)], a[(q, q)], 0.5 * (a[(p, q)] + a[(q, p)]));
                // Compare with both diagonal entries, not with the largest one: small eigenvalues keep their digits.
                if apq.abs() <= JACOBI * (app * aqq).abs().sqrt() {
                    continue;
                }
                turned = true;
                let theta = 0.5 * (aqq - app) / apq;
                let t = theta.signum() / (theta.abs() + theta.hypot(1.0));
                let c = 1.0 / t.hypot(1.0);
                let s = t * c;
                for i in 0..n {
                    let (x, y) = (a[(i, p)], a[(i, q)]);
                    (a[(i, p)], a[(i, q)]) = (c * x - s * y, s * x + c * y);
                }
                for i in 0..n {
                    let (x, y) = (a[(p, i)], a[(q, i)]);
                    (a[(p, i)], a[(q, i)]) = (c * x - s * y, s * x + c * y);
                    let (x, y) = (v[(i, p)], v[(i, q)]);
                    (v[(i, p)], v[(i, q)]) = (c * x - s * y, s * x + c * y);
                }
                // Their exact values are known: overwrite the rounding errors.
                (a[(p, q)], a[(q, p)]) = (0.0, 0.0);
                (a[(p, p)], a[(q, q)]) = (app - t * apq, aqq + t * apq);
            }
        }
        if !turned {
            break;
        }
    }
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&i, &j| a[(i, i)].total_cmp(&a[(j, j)]));
    let values = DVector::from_fn(n, |i, _| a[(order[i], order[i])]);
    (values, DMatrix::from_fn(n, n, |i, j| v[(i, order[j])]))
}

/// Maximum number of sweeps. Jacobi's method converges quadratically, within ten sweeps.
const MOST_SWEEPS: usize = 60;
