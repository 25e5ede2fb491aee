//! The shapes of a pair of eigenvalues: the null space of
//! [Omega² - b, -b (G - s); G - s, Omega² - b - s (G - s)] for (X1, X2), of two dimensions for each pair that shares (s, b).

use nalgebra::{DMatrix, DVector};

use super::pairs::Pair;
use crate::engine::error::Refusal;

/// Singular values of the scaled matrix that count as zero, at most: beyond, no two-dimensional space is invariant, and
/// the eigenvalue that the pairs share is defective.
const NULL: f64 = 1e-7;

/// Elements of `all` at `group`.
pub fn pick(all: &[f64], group: &[usize]) -> Vec<f64> {
    group.iter().map(|&i| all[i]).collect()
}

/// Rows and columns of `all` at `group`.
pub fn block(all: &DMatrix<f64>, group: &[usize]) -> DMatrix<f64> {
    DMatrix::from_fn(group.len(), group.len(), |i, j| all[(group[i], group[j])])
}

/// The matrix above, rows and columns scaled: it acts on (X1, rate X2).
pub fn pencil(omega2: &[f64], g: &DMatrix<f64>, s: f64, b: f64, rate: f64) -> DMatrix<f64> {
    let n = omega2.len();
    DMatrix::from_fn(2 * n, 2 * n, |row, column| {
        let (i, j) = (row % n, column % n);
        let scale = row_scale(omega2, g, rate, i);
        let off = g[(i, j)] - if i == j { s } else { 0.0 };
        let on = if i == j { omega2[i] - b } else { 0.0 };
        match (row < n, column < n) {
            (true, true) => on / scale,
            (true, false) => -b * off / (scale * rate),
            (false, true) => off * rate / scale,
            (false, false) => (on - s * off) / scale,
        }
    })
}

/// Size of row i, and of row n + i times the rate.
pub fn row_scale(omega2: &[f64], g: &DMatrix<f64>, rate: f64, i: usize) -> f64 {
    omega2[i] + rate * (rate + g[(i, i)])
}

/// The pairs of a cluster of values (s, b), each with one coordinate j that is its own: X1 = 1, X2 = 0 there, and both 0
/// at those of the others.
///
/// # Errors
/// Where the values are defective.
pub fn of(omega2: &[f64], g: &DMatrix<f64>, values: &[(f64, f64)]) -> Result<Vec<Pair>, Refusal> {
    let (n, size) = (omega2.len(), 2 * values.len());
    let (s, b) = mean(values);
    let rate = b.sqrt().max(s);
    let mut null = null_space(pencil(omega2, g, s, b, rate), size)?;
    let mut own = vec![];
    for k in 0..values.len() {
        // The coordinate in which the space left has the largest determinant.
        let left = null.columns(2 * k, size - 2 * k).into_owned();
        let area = |j: &usize| {
            let (p, q) = (left.row(*j), left.row(n + j));
            p.norm_squared() * q.norm_squared() - p.dot(&q).powi(2)
        };
        let j = largest((0..n).filter(|j| !own.contains(j)), area)?;
        own.push(j);
        eliminate(&mut null, j, 2 * k)?;
        eliminate(&mut null, n + j, 2 * k + 1)?;
    }
    let pair = |k: usize| {
        let x1 = DVector::from_fn(n, |i, _| null[(i, 2 * k)]);
        let x2 = DVector::from_fn(n, |i, _| null[(n + i, 2 * k)] / rate);
        Pair { x1, x2, s, b, own: own[k] }
    };
    Ok((0..values.len()).map(pair).collect())
}

/// The same where b = 0: a decay and the rigid motion that stays. With lambda = -s and (lambda² + lambda G + Omega²) phi = 0,
/// phi_j = 1, it is X1 = e_j, X1 + lambda X2 = phi, for a rigid mode j that is not in `taken`.
///
/// # Errors
/// Where the values are defective.
pub fn of_rigid(
    omega2: &[f64],
    g: &DMatrix<f64>,
    values: &[(f64, f64)],
    taken: &mut Vec<usize>,
) -> Result<Vec<Pair>, Refusal> {
    let n = omega2.len();
    let s = mean(values).0;
    let scaled = DMatrix::from_fn(n, n, |i, j| {
        let own = if i == j { s * s + omega2[i] } else { 0.0 };
        (own - s * g[(i, j)]) / row_scale(omega2, g, s, i)
    });
    let mut null = null_space(scaled, values.len())?;
    let mut own = vec![];
    for k in 0..values.len() {
        let left = null.columns(k, values.len() - k).into_owned();
        let free = (0..n).filter(|j| omega2[*j] == 0.0 && !taken.contains(j));
        let j = largest(free, |j| left.row(*j).norm_squared())?;
        taken.push(j);
        own.push(j);
        eliminate(&mut null, j, k)?;
    }
    let pair = |k: usize| {
        let x1 = DVector::from_fn(n, |i, _| f64::from(u8::from(i == own[k])));
        let x2 = (&x1 - null.column(k)) / s;
        Pair { x1, x2, s, b: 0.0, own: own[k] }
    };
    Ok((0..values.len()).map(pair).collect())
}

fn mean(values: &[(f64, f64)]) -> (f64, f64) {
    let count = values.len() as f64;
    (values.iter().map(|v| v.0).sum::<f64>() / count, values.iter().map(|v| v.1).sum::<f64>() / count)
}

/// A basis of the null space of a matrix that is known to have `size` dimensions of it.
fn null_space(a: DMatrix<f64>, size: usize) -> Result<DMatrix<f64>, Refusal> {
    let svd = a.svd(false, true);
    let v = svd.v_t.ok_or(Refusal::Defective { condition: f64::INFINITY })?;
    let mut order: Vec<usize> = (0..v.nrows()).collect();
    order.sort_by(|&i, &j| svd.singular_values[i].total_cmp(&svd.singular_values[j]));
    let largest = svd.singular_values[order[size - 1]];
    if largest.is_nan() || largest > NULL {
        return Err(Refusal::Defective { condition: 1.0 / largest });
    }
    Ok(DMatrix::from_fn(v.ncols(), size, |i, c| v[(order[c], i)]))
}

/// Which of some coordinates is largest by `size`; refused where that is next to nothing.
fn largest(of: impl Iterator<Item = usize>, size: impl Fn(&usize) -> f64) -> Result<usize, Refusal> {
    let best = of.max_by(|i, j| size(i).total_cmp(&size(j)));
    best.filter(|j| size(j) > 1e-20).ok_or(Refusal::Defective { condition: f64::INFINITY })
}

/// Makes column `at` of a basis 1 in `row`, and the others 0 there, by those from `at` on.
fn eliminate(basis: &mut DMatrix<f64>, row: usize, at: usize) -> Result<(), Refusal> {
    let pivot = largest(at..basis.ncols(), |c| basis[(row, *c)].abs())?;
    basis.swap_columns(at, pivot);
    let column = basis.column(at) / basis[(row, at)];
    basis.set_column(at, &column);
    for c in (0..basis.ncols()).filter(|&c| c != at) {
        let less = basis.column(c) - &column * basis[(row, c)];
        basis.set_column(c, &less);
    }
    Ok(())
}
