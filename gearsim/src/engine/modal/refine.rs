//! A pair of eigenvalues and its shapes, polished by Newton's method to the digits of the matrices.

use nalgebra::{DMatrix, DVector};

use super::pairs::Pair;
use super::subspace::{pencil, row_scale};

/// Newton's method doubles the digits; more steps than this do not help.
const STEPS: usize = 8;
/// Damping below this part of what makes it up is rounding.
const UNDAMPED: f64 = 1e-14;

/// The pair near `start`, with (X1, X2) = (1, 0) kept in its own coordinate; as it was where no step makes it better.
pub fn newton(omega2: &[f64], g: &DMatrix<f64>, start: Pair) -> Pair {
    let mut best = start;
    let mut error = residual(omega2, g, &best).amax();
    for _ in 0..STEPS {
        let Some(next) = step(omega2, g, &best) else { break };
        let rest = residual(omega2, g, &next).amax();
        // Written so that NaN ends it.
        if !(rest < 0.5 * error && next.b >= 0.0) {
            break;
        }
        (best, error) = (next, rest);
    }
    // A pair whose shapes no damper sees keeps its energy.
    let seen = best.x1.abs().dot(&(g.abs() * best.x1.abs())) / best.x1.norm_squared();
    if best.s.abs() <= UNDAMPED * seen {
        best.s = 0.0;
    }
    best
}

/// What the equations of a pair leave, scaled (2n).
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

/// One step for (X1, rate X2, s/rate, b/rate²); X1 and b stay where b = 0: a rigid motion is exact.
fn step(omega2: &[f64], g: &DMatrix<f64>, pair: &Pair) -> Option<Pair> {
    let (n, rate) = (omega2.len(), pair.rate());
    let Pair { s, b, own, .. } = *pair;
    let rigid = b == 0.0;
    let matrix = pencil(omega2, g, s, b, rate);
    let g2 = g * &pair.x2 - &pair.x2 * s;
    let by_s = |row: usize| match (row < n, row % n) {
        (true, i) => b * pair.x2[i],
        (false, i) => -(pair.x1[i] - s * pair.x2[i]) - g2[i],
    };
    let by_b = |row: usize| match (row < n, row % n) {
        (true, i) => -pair.x1[i] - g2[i],
        (false, i) => -pair.x2[i],
    };
    let scaled = |row: usize, by: &dyn Fn(usize) -> f64| {
        by(row) * if row < n { 1.0 } else { rate } / row_scale(omega2, g, rate, row % n)
    };
    // The unknowns: X1 and X2 but for its own coordinate, s, b.
    let moving = |column: usize| column % n != own && !(rigid && column < n);
    let columns: Vec<usize> = (0..2 * n).filter(|&c| moving(c)).collect();
    let rows: Vec<usize> = (0..2 * n).filter(|&r| !(rigid && r < n)).collect();
    let jacobian = DMatrix::from_fn(rows.len(), rows.len(), |r, c| match columns.get(c) {
        Some(&column) => matrix[(rows[r], column)],
        None if c == columns.len() => scaled(rows[r], &by_s) * rate,
        None => scaled(rows[r], &by_b) * rate * rate,
    });
    let left = residual(omega2, g, pair);
    let change = jacobian.lu().solve(&DVector::from_fn(rows.len(), |r, _| -left[rows[r]]))?;
    let mut next = pair.clone();
    for (&column, by) in columns.iter().zip(change.iter()) {
        if column < n { next.x1[column] += by } else { next.x2[column - n] += by / rate }
    }
    next.s += change[columns.len()] * rate;
    if !rigid {
        next.b += change[columns.len() + 1] * rate * rate;
    }
    Some(next)
}
