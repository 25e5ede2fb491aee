//! The eigenvalues of lambda² + lambda G + Omega², G positive semidefinite, in pairs that make up a mode each.
//!
//! Complex ones go with their conjugates. Of the real ones half are of the fast kind and half of the slow kind: from
//! lambda = -inf on, where lambda² + lambda G + Omega² is positive definite, a fast one adds a negative direction to it
//! and a slow one takes one away, like brackets: the sign characteristic (I. Gohberg, P. Lancaster & L. Rodman, Matrix
//! Polynomials, 1982). Two of one kind pass through one another; a fast and a slow one that meet become defective, and
//! then complex. So a fast one goes with the nearest slow one, and where they meet they do so within one mode, as at
//! critical damping. Rigid motions that are damped have lambda = 0, slow.

use nalgebra::{Complex, DMatrix, DVector, Schur};

use crate::engine::error::Refusal;
use crate::tolerance::modes::{EQUAL_PAIRS, NEARLY_REAL, QR, QR_ITERATIONS};

/// A mode: xi' = X1 a' + X2 a'', a'' + s a' + b a = const.
#[derive(Debug, Clone)]
pub struct Pair {
    /// X1 (n).
    pub x1: DVector<f64>,
    /// X2 \[s\] (n).
    pub x2: DVector<f64>,
    /// s = 2 sigma = -(lambda1 + lambda2) \[1/s\].
    pub s: f64,
    /// b = omega² = lambda1 lambda2 \[1/s²\].
    pub b: f64,
    /// Pairs of one cluster share (s, b), or all b = 0, and need not be orthogonal to one another.
    pub cluster: usize,
}

impl Pair {
    /// Size of its eigenvalues \[1/s\].
    pub fn rate(&self) -> f64 {
        self.b.sqrt().max(self.s)
    }
}

/// Clusters of pairs (s, b) that cannot be told apart; of the modes with `omega2`, rising, and the damping `g`.
///
/// # Errors
/// Where the eigenvalues are not found.
pub fn eigenpairs(omega2: &[f64], g: &DMatrix<f64>) -> Result<Vec<Vec<(f64, f64)>>, Refusal> {
    let values = eigenvalues(omega2, g)?;
    let nearly_real = |z: &Complex<f64>| z.im.abs() <= NEARLY_REAL * z.re.abs();
    let mut pairs: Vec<(f64, f64)> =
        values.iter().filter(|z| z.im > 0.0 && !nearly_real(z)).map(|z| (-2.0 * z.re, z.norm_sqr())).collect();
    let mut real: Vec<Complex<f64>> = values.iter().copied().filter(nearly_real).collect();
    real.extend(omega2.iter().filter(|w| **w == 0.0).map(|_| Complex::from(0.0)));
    real.sort_by(|x, y| (x.re, x.im).partial_cmp(&(y.re, y.im)).unwrap_or(std::cmp::Ordering::Equal));
    let mut left: Vec<(Complex<f64>, bool)> = real.iter().copied().zip(kinds(omega2, g, &real)).collect();
    while left.len() > 1 {
        let apart = |i: usize, j: usize| (left[i].0 - left[j].0).norm() / left[i].0.norm().max(left[j].0.norm());
        let opposite =
            (0..left.len()).flat_map(|j| (0..j).map(move |i| (i, j))).filter(|&(i, j)| left[i].1 != left[j].1);
        let nearest = opposite.min_by(|x, y| apart(x.0, x.1).total_cmp(&apart(y.0, y.1)));
        let Some((i, j)) = nearest else { break };
        let (second, first) = (left.remove(j).0, left.remove(i).0);
        pairs.push((-(first + second).re, (first * second).re.max(0.0)));
    }
    if pairs.len() != omega2.len() {
        return Err(Refusal::Defective { condition: f64::INFINITY });
    }
    Ok(clusters(pairs, values.iter().map(|z| z.norm()).fold(0.0, f64::max)))
}

/// All eigenvalues but those of damped rigid motions at 0, which are left out exactly.
fn eigenvalues(omega2: &[f64], g: &DMatrix<f64>) -> Result<Vec<Complex<f64>>, Refusal> {
    // z = (omega xi, xi'), fast modes first: the QR method keeps the digits of small eigenvalues better so.
    let mut place = vec![];
    for i in (0..omega2.len()).rev() {
        if omega2[i] > 0.0 {
            place.push((i, true));
        }
        place.push((i, false));
    }
    let a = DMatrix::from_fn(place.len(), place.len(), |row, column| match (place[row], place[column]) {
        ((i, true), (j, false)) if i == j => omega2[i].sqrt(),
        ((i, false), (j, true)) if i == j => -omega2[i].sqrt(),
        ((i, false), (j, false)) => -g[(i, j)],
        _ => 0.0,
    });
    let size = a.amax();
    let schur = Schur::try_new(a / size, QR, QR_ITERATIONS).ok_or(Refusal::Defective { condition: f64::INFINITY })?;
    Ok(schur.complex_eigenvalues().iter().map(|z| z * size).collect())
}

/// Whether each of the real eigenvalues, rising, is of the fast kind.
fn kinds(omega2: &[f64], g: &DMatrix<f64>, real: &[Complex<f64>]) -> Vec<bool> {
    let mut kinds = vec![];
    let (mut first, mut before) = (0, 0);
    for i in 1..=real.len() {
        let apart = i == real.len() || real[i].re - real[i - 1].re > NEARLY_REAL * real[i - 1].re.abs();
        if !apart {
            continue;
        }
        let count = i - first;
        // Beyond the last one nothing is negative, for lambda = 0 is of the slow kind.
        let after = if i == real.len() {
            0
        } else {
            negative(omega2, g, -(real[i].re * real[i - 1].re).sqrt().max(0.5 * -real[i - 1].re))
        };
        let fast = ((count + after) as i64 - before as i64).clamp(0, 2 * count as i64) as usize / 2;
        kinds.extend((0..count).map(|k| k < fast));
        (first, before) = (i, after);
    }
    kinds
}

/// Number of negative directions of lambda² + lambda G + Omega².
fn negative(omega2: &[f64], g: &DMatrix<f64>, lambda: f64) -> usize {
    let n = omega2.len();
    let unit = |i: usize| (lambda * lambda - lambda * g[(i, i)] + omega2[i]).sqrt();
    let pencil = DMatrix::from_fn(n, n, |i, j| {
        let own = if i == j { lambda * lambda + omega2[i] } else { 0.0 };
        (own + lambda * g[(i, j)]) / (unit(i) * unit(j))
    });
    pencil.symmetric_eigenvalues().iter().filter(|x| **x < 0.0).count()
}

fn clusters(mut pairs: Vec<(f64, f64)>, fastest: f64) -> Vec<Vec<(f64, f64)>> {
    let mut clusters: Vec<Vec<(f64, f64)>> = vec![];
    pairs.sort_by(|x, y| y.partial_cmp(x).unwrap_or(std::cmp::Ordering::Equal));
    for (s, b) in pairs {
        let near = |&(t, c): &(f64, f64)| {
            let near = EQUAL_PAIRS * fastest;
            (s - t).abs() <= near && (b - c).abs() <= near * b.max(c).sqrt().max(near)
        };
        match clusters.iter_mut().find(|cluster| cluster.iter().any(near)) {
            Some(cluster) => cluster.push((s, b)),
            None => clusters.push(vec![(s, b)]),
        }
    }
    clusters
}
