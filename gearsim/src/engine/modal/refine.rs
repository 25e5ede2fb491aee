//! Newton's method for a pair of eigenvalues and its shapes. It reaches the accuracy of the matrices.
//!
//! The shapes of equal pairs are not unique: the linear system of a step is singular in the directions of the shapes of the other pairs.
//! The solution of least norm has no part in these directions. Shapes that are linearly independent at the start therefore remain so.

use nalgebra::{DMatrix, DVector};

use super::pairs::Pair;
use super::subspace::{image, pencil, quadratic, row_scale};
use crate::tolerance::modes::{NULL_SPACE, UNDAMPED_PAIR};

/// Maximum number of steps. Each doubles the number of correct digits.
const STEPS: usize = 8;

/// The pair near `start`, one of a cluster of `equal` pairs; `start` itself if no step reduces its residual.
pub fn newton(omega2: &[f64], g: &DMatrix<f64>, equal: usize, start: Pair) -> Pair {
    let mut best = start;
    let mut error = residual(omega2, g, &best).amax();
    for _ in 0..STEPS {
        let Some(next) = step(omega2, g, equal, &best) else { break };
        let rest = residual(omega2, g, &next).amax();
        // The condition is also true for NaN.
        if !(rest < 0.5 * error && next.b >= 0.0) {
            break;
        }
        (best, error) = (next, rest);
    }
    if best.b == 0.0 && equal == 1 {
        best = weakly_damped(omega2, g, &best).unwrap_or(best);
    }
    // A pair on whose shapes no damper acts keeps its energy.
    let seen = best.x1.abs().dot(&(g.abs() * best.x1.abs())) / best.x1.norm_squared();
    if best.s.abs() <= UNDAMPED_PAIR * seen {
        best.s = 0.0;
    }
    best
}

/// The residual of the equations of a pair, scaled (2n).
fn residual(omega2: &[f64], g: &DMatrix<f64>, pair: &Pair) -> DVector<f64> {
    let (n, rate) = (omega2.len(), pair.rate());
    let (g1, g2) = (g * &pair.x1 - &pair.x1 * pair.s, g * &pair.x2 - &pair.x2 * pair.s);
    DVector::from_fn(2 * n, |row, _| {
        let (i, scale) = (row % n, row_scale(omega2, g, rate, row % n));
        let stiff = omega2[i] - pair.b;
        if row < n {
            (stiff * pair.x1[i] - pair.b * g2[i]) / scale
        } else {
            (stiff * pair.x2[i] + g1[i] - pair.s * g2[i]) * rate / scale
        }
    })
}

/// One Newton step for (X1, rate X2, s/rate, b/rate²), orthogonal to y and C y: changes along these do not change the pair.
fn step(omega2: &[f64], g: &DMatrix<f64>, equal: usize, pair: &Pair) -> Option<Pair> {
    if pair.b == 0.0 {
        return step_rigid(omega2, g, equal, pair);
    }
    let (n, rate) = (omega2.len(), pair.rate());
    let Pair { s, b, .. } = *pair;
    let g2 = g * &pair.x2 - &pair.x2 * s;
    let y = DVector::from_fn(2 * n, |i, _| if i < n { pair.x1[i] } else { rate * pair.x2[i - n] });
    let image = image(&y, s, b, rate);
    let by = |row: usize| {
        let (i, scale) = (row % n, row_scale(omega2, g, rate, row % n));
        if row < n {
            [b * pair.x2[i] * rate / scale, -(pair.x1[i] + g2[i]) * rate * rate / scale]
        } else {
            let by_s = s * pair.x2[i] - pair.x1[i] - g2[i];
            [by_s * rate * rate / scale, -pair.x2[i] * rate * rate * rate / scale]
        }
    };
    let mut jacobian = DMatrix::zeros(2 * n + 2, 2 * n + 2);
    jacobian.view_mut((0, 0), (2 * n, 2 * n)).copy_from(&pencil(omega2, g, s, b, rate));
    for i in 0..2 * n {
        let [by_s, by_b] = by(i);
        (jacobian[(i, 2 * n)], jacobian[(i, 2 * n + 1)]) = (by_s, by_b);
        (jacobian[(2 * n, i)], jacobian[(2 * n + 1, i)]) = (y[i], image[i]);
    }
    let left = residual(omega2, g, pair).insert_rows(2 * n, 2, 0.0);
    let change = solve(jacobian, &-left, equal)?;
    let x1 = DVector::from_fn(n, |i, _| pair.x1[i] + change[i]);
    let x2 = DVector::from_fn(n, |i, _| pair.x2[i] + change[n + i] / rate);
    let (s, b) = (s + change[2 * n] * rate, b + change[2 * n + 1] * rate * rate);
    Some(Pair { x1, x2, s, b, cluster: pair.cluster })
}

/// The same for a decay beside a rigid motion, whose eigenvalue 0 is exact: one step for (phi, lambda).
fn step_rigid(omega2: &[f64], g: &DMatrix<f64>, equal: usize, pair: &Pair) -> Option<Pair> {
    let (n, s) = (omega2.len(), pair.s);
    let phi = &pair.x1 - &pair.x2 * s;
    let left = (quadratic(omega2, g, s) * &phi).insert_row(n, 0.0);
    let change = solve(bordered(omega2, g, s, &phi), &-left, equal)?;
    let phi = phi + change.rows(0, n);
    let s = s - change[n] * s;
    Some(Pair { x1: pair.x1.clone(), x2: (&pair.x1 - phi) / s, s, b: 0.0, cluster: pair.cluster })
}

/// The pair with X2 from (lambda² + lambda G + Omega²) X2 = (s - G) X1, if phi is nearly X1: their difference over s has few digits if s
/// is small.
fn weakly_damped(omega2: &[f64], g: &DMatrix<f64>, pair: &Pair) -> Option<Pair> {
    let (n, s, x1) = (omega2.len(), pair.s, &pair.x1);
    let phi = &(x1 - &pair.x2 * s);
    if phi.dot(x1) < 0.5 * phi.norm() {
        return None;
    }
    let force = x1 * s - g * x1;
    let force = DVector::from_fn(n, |i, _| force[i] / row_scale(omega2, g, s, i)).insert_row(n, 0.0);
    let x2 = bordered(omega2, g, s, phi).lu().solve(&force)?.rows(0, n).into_owned();
    Some(Pair { x2, ..pair.clone() })
}

/// lambda² + lambda G + Omega² at lambda = -s with scaled rows, bordered by its derivative and by phi: changes along phi are excluded.
fn bordered(omega2: &[f64], g: &DMatrix<f64>, s: f64, phi: &DVector<f64>) -> DMatrix<f64> {
    let n = omega2.len();
    let slope = g * phi - phi * (2.0 * s);
    let mut matrix = quadratic(omega2, g, s).insert_column(n, 0.0).insert_row(n, 0.0);
    for i in 0..n {
        matrix[(i, n)] = slope[i] * s / row_scale(omega2, g, s, i);
        matrix[(n, i)] = phi[i];
    }
    matrix
}

/// The change of a pair in a step: of least norm if other pairs are equal to it.
fn solve(jacobian: DMatrix<f64>, left: &DVector<f64>, equal: usize) -> Option<DVector<f64>> {
    if equal == 1 { jacobian.lu().solve(left) } else { jacobian.svd(true, true).solve(left, NULL_SPACE).ok() }
}
