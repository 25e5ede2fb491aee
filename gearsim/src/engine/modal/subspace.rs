//! The shapes of a pair of eigenvalues: the null space of [Omega² - b, -b (G - s); G - s, Omega² - b - s (G - s)] for (X1, X2).
//! It has two dimensions for each pair with these s and b.

use nalgebra::{DMatrix, DVector};

use super::pairs::Pair;
use crate::engine::error::Refusal;
use crate::tolerance::modes::NULL_SPACE;

/// The elements of `all` with the indices `group`.
pub fn pick(all: &[f64], group: &[usize]) -> Vec<f64> {
    group.iter().map(|&i| all[i]).collect()
}

/// The rows and columns of `all` with the indices `group`.
pub fn block(all: &DMatrix<f64>, group: &[usize]) -> DMatrix<f64> {
    DMatrix::from_fn(group.len(), group.len(), |i, j| all[(group[i], group[j])])
}

/// The matrix of this module's documentation with scaled rows and columns. It acts on (X1, rate X2).
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

/// The scale of row i; that of row n + i is this divided by the rate.
pub fn row_scale(omega2: &[f64], g: &DMatrix<f64>, rate: f64, i: usize) -> f64 {
    omega2[i] + rate * (rate + g[(i, i)])
}

/// The pairs of a cluster of values (s, b).
///
/// Each pair is spanned by a vector y = (X1, rate X2) of the null space and its image C y = (-b X2, rate (X1 - s X2)), which
/// belong to a' and a''. Of several candidates y, the one is chosen whose image has the largest part orthogonal to y and to the
/// pairs found before.
///
/// # Errors
/// If the values are defective.
pub fn of(omega2: &[f64], g: &DMatrix<f64>, values: &[(f64, f64)]) -> Result<Vec<Pair>, Refusal> {
    let (n, size) = (omega2.len(), 2 * values.len());
    let (s, b) = mean(values);
    let rate = b.sqrt().max(s);
    let mut left = null_space(pencil(omega2, g, s, b, rate), size)?;
    let mut pairs = vec![];
    while left.len() > 1 {
        let mixed = (0..left.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
        let mixed = mixed.flat_map(|(i, j)| [(&left[i] + &left[j]).normalize(), (&left[i] - &left[j]).normalize()]);
        let candidates: Vec<DVector<f64>> = left.iter().cloned().chain(mixed).collect();
        // Project the image onto the remaining space: it may have parts in the pairs found before.
        let aside = |y: &DVector<f64>| {
            let image = image(y, s, b, rate);
            let within = left.iter().map(|v| v * v.dot(&image)).sum::<DVector<f64>>();
            &within - y * y.dot(&within)
        };
        let best = candidates.into_iter().max_by(|x, y| aside(x).norm().total_cmp(&aside(y).norm()));
        let y = best.ok_or(Refusal::Defective { condition: f64::INFINITY })?;
        let other = aside(&y);
        if other.norm() < NULL_SPACE {
            return Err(Refusal::Defective { condition: 1.0 / other.norm() });
        }
        left = without(&left, &[y.clone(), other.normalize()]);
        pairs.push(Pair { x1: y.rows(0, n).into_owned(), x2: y.rows(n, n) / rate, s, b, cluster: 0 });
    }
    Ok(pairs)
}

/// C y, divided by the rate.
pub fn image(y: &DVector<f64>, s: f64, b: f64, rate: f64) -> DVector<f64> {
    let n = y.len() / 2;
    DVector::from_fn(2 * n, |i, _| if i < n { -b / (rate * rate) * y[n + i] } else { y[i - n] - s / rate * y[i] })
}

/// The same for b = 0: a decay and a rigid motion e_j, with j from `rigid`. With lambda = -s and (lambda² + lambda G + Omega²)
/// phi = 0, X1 = e_j and X1 + lambda X2 = phi. phi and e_j may be orthogonal.
///
/// # Errors
/// If the values are defective.
pub fn of_rigid(
    omega2: &[f64],
    g: &DMatrix<f64>,
    values: &[(f64, f64)],
    rigid: &mut impl Iterator<Item = usize>,
) -> Result<Vec<Pair>, Refusal> {
    let n = omega2.len();
    let s = mean(values).0;
    let null = null_space(quadratic(omega2, g, s), values.len())?;
    let pair = |phi: DVector<f64>| {
        let j = rigid.next().ok_or(Refusal::Defective { condition: f64::INFINITY })?;
        let x1 = DVector::from_fn(n, |i, _| f64::from(u8::from(i == j)));
        let phi = if phi[j] < 0.0 { -phi } else { phi };
        Ok(Pair { x2: (&x1 - phi) / s, x1, s, b: 0.0, cluster: 0 })
    };
    null.into_iter().map(pair).collect()
}

/// lambda² + lambda G + Omega² at lambda = -s, with scaled rows.
pub fn quadratic(omega2: &[f64], g: &DMatrix<f64>, s: f64) -> DMatrix<f64> {
    let n = omega2.len();
    DMatrix::from_fn(n, n, |i, j| {
        let own = if i == j { s * s + omega2[i] } else { 0.0 };
        (own - s * g[(i, j)]) / row_scale(omega2, g, s, i)
    })
}

fn mean(values: &[(f64, f64)]) -> (f64, f64) {
    let count = values.len() as f64;
    (values.iter().map(|v| v.0).sum::<f64>() / count, values.iter().map(|v| v.1).sum::<f64>() / count)
}

/// From this number of rows on, the null space is found by a QR decomposition with pivots. It takes a tenth of the time of the singular
/// values.
const LARGE: usize = 64;

/// An orthonormal basis of the null space of a matrix, which has the known dimension `size`.
fn null_space(a: DMatrix<f64>, size: usize) -> Result<Vec<DVector<f64>>, Refusal> {
    if a.iter().any(|x| !x.is_finite()) {
        return Err(Refusal::Defective { condition: f64::INFINITY });
    }
    if a.nrows() >= LARGE
        && let Some(basis) = by_pivots(&a, size)
    {
        return Ok(basis);
    }
    let svd = a.svd(false, true);
    let v = svd.v_t.ok_or(Refusal::Defective { condition: f64::INFINITY })?;
    let mut order: Vec<usize> = (0..v.nrows()).collect();
    order.sort_by(|&i, &j| svd.singular_values[i].total_cmp(&svd.singular_values[j]));
    let largest = svd.singular_values[order[size - 1]];
    if largest.is_nan() || largest > NULL_SPACE {
        return Err(Refusal::Defective { condition: 1.0 / largest });
    }
    Ok(order[..size].iter().map(|&i| v.row(i).transpose()).collect())
}

/// The same from the QR decomposition with pivots, A P = Q R. With R = [R1, R2; 0, about 0] the null space is P [-R1⁻¹ R2; 1]. `None` if
/// the matrix does not map these vectors to zero.
fn by_pivots(a: &DMatrix<f64>, size: usize) -> Option<Vec<DVector<f64>>> {
    let n = a.nrows();
    let rank = n.checked_sub(size)?;
    let factors = a.clone().col_piv_qr();
    let r = factors.r();
    let r1 = r.view((0, 0), (rank, rank));
    let mut basis = DMatrix::zeros(n, size);
    basis.view_mut((0, 0), (rank, size)).copy_from(&-r1.solve_upper_triangular(&r.view((0, rank), (rank, size)))?);
    basis.view_mut((rank, 0), (size, size)).fill_with_identity();
    factors.p().inv_permute_rows(&mut basis);
    let basis = basis.qr().q();
    // The condition is false for NaN.
    ((a * &basis).norm() <= NULL_SPACE).then(|| basis.column_iter().map(|column| column.into_owned()).collect())
}

/// An orthonormal basis of the complement, within the span of `basis`, of two orthonormal directions.
fn without(basis: &[DVector<f64>], taken: &[DVector<f64>; 2]) -> Vec<DVector<f64>> {
    let mut all = taken.to_vec();
    while all.len() < basis.len() {
        // Take the largest remainder. Orthogonalise it twice, because its rounding errors are too large after once.
        let rest = |v: &DVector<f64>| all.iter().chain(&all).fold(v.clone(), |v, u| &v - u * u.dot(&v));
        let largest = basis.iter().map(rest).max_by(|x, y| x.norm().total_cmp(&y.norm()));
        let Some(largest) = largest else { break };
        all.push(largest.normalize());
    }
    all.split_off(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A matrix with a null space of two dimensions, and elements of very different size: both methods find the same space.
    #[test]
    fn pivots_and_singular_values_find_the_same_null_space() {
        let n = 70;
        let entry = |i: usize, j: usize| ((i * 37 + j * 61 + i * i * j) % 101) as f64 / 101.0 - 0.5;
        let full = DMatrix::from_fn(n, n, entry);
        let (left, right) = (full.clone().qr().q(), full.transpose().qr().q());
        let sizes = DVector::from_fn(n, |i, _| if i < n - 2 { 10f64.powi(-((i % 5) as i32)) } else { 0.0 });
        let a = &left * DMatrix::from_diagonal(&sizes) * right.transpose();
        let found = by_pivots(&a, 2).unwrap();
        let expected = right.columns(n - 2, 2);
        for v in &found {
            assert!((v.norm() - 1.0).abs() < 1e-12 && (&a * v).norm() < 1e-13);
            assert!((v - expected * (expected.transpose() * v)).norm() < 1e-9);
        }
        assert!(found[0].dot(&found[1]).abs() < 1e-12);
        assert!(by_pivots(&a, 3).is_none(), "the null space has no third dimension");
    }
}
