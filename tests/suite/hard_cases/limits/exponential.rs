//! M q'' + C q' + K q = f by the matrix exponential, in 50 digits: Taylor's series of e^{A t/2^s}, squared s times.

use gearsim_tests::precise::number::{Real, Scalar};

use crate::linear::Linear;

type Digits = Real<192>;
/// (q, q', 1)' = A (q, q', 1): six rows of the cell, and one for its load.
type Matrix = [[Digits; 7]; 7];

fn real(x: f64) -> Digits {
    Digits::exact(x)
}

fn matrix(of: impl Fn(usize, usize) -> Digits) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| of(i, j)))
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    matrix(|i, j| (0..7).fold(real(0.0), |sum, k| sum + a[i][k].clone() * b[k][j].clone()))
}

/// M⁻¹ times the columns of (-K, -C, f), by elimination; M is positive definite.
fn accelerations(system: &Linear<3>) -> [[Digits; 7]; 3] {
    let mut m = system.mass.map(|row| row.map(real));
    let mut right: [[Digits; 7]; 3] = std::array::from_fn(|i| {
        std::array::from_fn(|j| match j {
            0..3 => real(-system.stiffness[i][j]),
            3..6 => real(-system.damping[i][j - 3]),
            _ => real(system.load[i]),
        })
    });
    for pivot in 0..3 {
        for row in (0..3).filter(|&row| row != pivot) {
            let by = m[row][pivot].clone() / m[pivot][pivot].clone();
            m[row] = std::array::from_fn(|j| m[row][j].clone() - by.clone() * m[pivot][j].clone());
            right[row] = std::array::from_fn(|j| right[row][j].clone() - by.clone() * right[pivot][j].clone());
        }
    }
    std::array::from_fn(|i| right[i].clone().map(|x| x / m[i][i].clone()))
}

/// q and q' after the time `t` \[s\].
pub fn propagate(system: &Linear<3>, q: [f64; 3], v: [f64; 3], t: f64) -> ([f64; 3], [f64; 3]) {
    let rows = accelerations(system);
    let halvings = 12;
    let short = real(t).scaled(-halvings);
    let a = matrix(|i, j| match i {
        0..3 => real(f64::from(u8::from(j == i + 3))) * short.clone(),
        3..6 => rows[i - 3][j].clone() * short.clone(),
        _ => real(0.0),
    });
    let mut sum = matrix(|i, j| real(f64::from(u8::from(i == j))));
    let mut term = sum.clone();
    for n in 1..40 {
        term = product(&term, &a).map(|row| row.map(|x| x.over(n)));
        sum = matrix(|i, j| sum[i][j].clone() + term[i][j].clone());
    }
    for _ in 0..halvings {
        sum = product(&sum, &sum);
    }
    let start: [f64; 7] = std::array::from_fn(|i| {
        if i < 3 {
            q[i]
        } else if i < 6 {
            v[i - 3]
        } else {
            1.0
        }
    });
    let end = |i: usize| (0..7).fold(real(0.0), |x, j| x + sum[i][j].clone() * real(start[j])).approx();
    (std::array::from_fn(end), std::array::from_fn(|i| end(i + 3)))
}
