//! The eigenvalues of lambda² + lambda G + Omega² with G positive semidefinite, grouped in pairs. Each pair is one mode.
//!
//! A complex eigenvalue forms a pair with its conjugate. Of the real eigenvalues, half are fast and half are slow. For lambda =
//! -inf the matrix lambda² + lambda G + Omega² is positive definite. As lambda rises, it gets one more negative eigenvalue at
//! each fast lambda and loses one at each slow lambda. This is the sign characteristic (I. Gohberg, P. Lancaster & L. Rodman,
//! Matrix Polynomials, 1982). Two eigenvalues of the same kind can pass through one another. A fast and a slow one that meet
//! become defective, and then complex. Therefore each fast one forms a pair with the nearest slow one: if they meet, they do so
//! within one mode, as at critical damping. Damped rigid motions have lambda = 0, which is slow. The nearest one has the smallest
//! difference, not the smallest ratio: during a short flight, 0 and a slow decay are nearly equal too.

use nalgebra::{Complex, DMatrix, DVector, Schur};

use crate::engine::error::Refusal;
use crate::tolerance::modes::{EQUAL_PAIRS, NEARLY_REAL, QR, QR_ITERATIONS};

/// A mode: xi' = X1 a' + X2 a'' with a'' + s a' + b a = const.
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
    /// Index of its cluster. Pairs of one cluster share (s, b), or all have b = 0; they need not be orthogonal to one another.
    pub cluster: usize,
}

impl Pair {
    /// Largest rate of its eigenvalues \[1/s\].
    pub fn rate(&self) -> f64 {
        self.b.sqrt().max(self.s)
    }
}

/// When two pairs count as equal: their distance is below [`EQUAL_PAIRS`] times rate^(1 - w) fastest^w, with this w.
#[derive(Debug, Clone, Copy)]
pub struct Nearness(f64);

impl Nearness {
    /// Relative to the pairs themselves.
    pub const NARROW: Nearness = Nearness(0.0);
    /// Towards a distance relative to the fastest eigenvalue.
    pub const WIDER: [Nearness; 2] = [Nearness(0.5), Nearness(1.0)];
}

/// The pairs (s, b), in clusters of equal pairs, of the modes with the squares `omega2` (rising) and the damping `g`.
///
/// # Errors
/// If the eigenvalues are not found.
pub fn eigenpairs(omega2: &[f64], g: &DMatrix<f64>, nearness: Nearness) -> Result<Vec<Vec<(f64, f64)>>, Refusal> {
    let values = eigenvalues(omega2, g)?;
    let nearly_real = |z: &Complex<f64>| z.im.abs() <= NEARLY_REAL * z.re.abs();
    let mut pairs: Vec<(f64, f64)> =
        values.iter().filter(|z| z.im > 0.0 && !nearly_real(z)).map(|z| (-2.0 * z.re, z.norm_sqr())).collect();
    let mut real: Vec<Complex<f64>> = values.iter().copied().filter(nearly_real).collect();
    real.extend(omega2.iter().filter(|w| **w == 0.0).map(|_| Complex::from(0.0)));
    real.sort_by(|x, y| (x.re, x.im).partial_cmp(&(y.re, y.im)).unwrap_or(std::cmp::Ordering::Equal));
    let mut left: Vec<(Complex<f64>, bool)> = real.iter().copied().zip(kinds(omega2, g, &real)).collect();
    while left.len() > 1 {
        let apart = |i: usize, j: usize| (left[i].0 - left[j].0).norm();
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
    Ok(clusters(pairs, values.iter().map(|z| z.norm()).fold(0.0, f64::max), nearness))
}

/// All eigenvalues except those of damped rigid motions at 0, which are known exactly.
fn eigenvalues(omega2: &[f64], g: &DMatrix<f64>) -> Result<Vec<Complex<f64>>, Refusal> {
    // z = (omega xi, xi'), fast modes first. With this order the QR method keeps the digits of small eigenvalues.
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

/// Whether each of the real eigenvalues, in rising order, is fast.
fn kinds(omega2: &[f64], g: &DMatrix<f64>, real: &[Complex<f64>]) -> Vec<bool> {
    let mut kinds = vec![];
    let (mut first, mut before) = (0, 0);
    for i in 1..=real.len() {
        let apart = i == real.len() || real[i].re - real[i - 1].re > NEARLY_REAL * real[i - 1].re.abs();
        if !apart {
            continue;
        }
        let count = i - first;
        // Above the last one the matrix has no negative eigenvalue, because lambda = 0 is slow.
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

/// Number of negative eigenvalues of lambda² + lambda G + Omega².
fn negative(omega2: &[f64], g: &DMatrix<f64>, lambda: f64) -> usize {
    let n = omega2.len();
    let unit = |i: usize| (lambda * lambda - lambda * g[(i, i)] + omega2[i]).sqrt();
    let pencil = DMatrix::from_fn(n, n, |i, j| {
        let own = if i == j { lambda * lambda + omega2[i] } else { 0.0 };
        (own + lambda * g[(i, j)]) / (unit(i) * unit(j))
    });
    pencil.symmetric_eigenvalues().iter().filter(|x| **x < 0.0).count()
}

fn clusters(mut pairs: Vec<(f64, f64)>, fastest: f64, Nearness(w): Nearness) -> Vec<Vec<(f64, f64)>> {
    let mut clusters: Vec<Vec<(f64, f64)>> = vec![];
    pairs.sort_by(|x, y| y.partial_cmp(x).unwrap_or(std::cmp::Ordering::Equal));
    for (s, b) in pairs {
        let near = |&(t, c): &(f64, f64)| {
            let rate = b.max(c).sqrt().max(s).max(t);
            let near = EQUAL_PAIRS * rate.powf(1.0 - w) * fastest.powf(w);
            (s - t).abs() <= near && (b - c).abs() <= near * b.max(c).sqrt().max(near)
        };
        match clusters.iter_mut().find(|cluster| cluster.iter().any(near)) {
            Some(cluster) => cluster.push((s, b)),
            None => clusters.push(vec![(s, b)]),
        }
    }
    clusters
}
