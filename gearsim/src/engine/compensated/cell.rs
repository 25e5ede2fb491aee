//! A linear cell in double-double precision. The modes of the plain cell are refined.
//!
//! The plain shapes X have an error of 1e-16. Two steps X (1 - E/2 + 3 E²/8), E = XᵀMX - 1, make them orthonormal to 1e-32. XᵀKX
//! is then nearly diagonal, and Jacobi rotations diagonalise it.

use nalgebra::{DMatrix, DVector};
use xprec::Df64;

use crate::engine::cell;
use crate::engine::compensated::mode::Mode;
use crate::engine::equations::Matrices;
use crate::engine::error::Refusal;
use crate::tolerance::modes::{COMPENSATED_COUPLED, COMPENSATED_JACOBI};

/// The modes of one cell.
#[derive(Debug, Clone)]
pub struct Cell {
    /// The modes, in the order of the plain cell.
    pub modes: Vec<Mode>,
    /// Mode shapes X, one per column: q = X xi.
    pub shapes: DMatrix<Df64>,
    /// Xᵀ M: gives the modal speeds from the speeds.
    pub momentum: DMatrix<Df64>,
    /// Xᵀ f: the modal loads.
    pub load: DVector<Df64>,
    /// Upper bound of the rates of its modes [1/s].
    pub rate: f64,
}

/// Maximum number of sweeps. Jacobi's method converges in about two for a nearly diagonal matrix.
const MOST_SWEEPS: usize = 20;

impl Cell {
    /// The cell with the given matrices, refined from the `plain` one.
    ///
    /// # Errors
    /// If damping couples the modes.
    pub fn new(matrices: &Matrices<Df64>, plain: &cell::Cell) -> Result<Self, Refusal> {
        let Matrices { mass, damping, stiffness, load, .. } = matrices;
        let n = mass.nrows();
        let mut x = plain.shapes.map(Df64::from);
        for _ in 0..2 {
            x = orthonormal(mass, &x);
        }
        let omega2 = diagonal(x.transpose() * stiffness * &x, &mut x);
        let modal = x.transpose() * damping * &x;
        let strongest = (0..n).map(|i| modal[(i, i)].hi().abs()).fold(0.0, f64::max);
        let pairs = (0..n).flat_map(|i| (0..i).map(move |j| (i, j)));
        let coupling = pairs.map(|at| modal[at].hi().abs()).fold(0.0, f64::max);
        if plain.coupling.is_some() || coupling > COMPENSATED_COUPLED * strongest {
            return Err(Refusal::CompensatedCoupling);
        }
        let mode = |i: usize| {
            let zero_or = |is_zero: bool, x: Df64| if is_zero { Df64::from(0.0) } else { x };
            Mode::new(
                zero_or(plain.modes[i].sigma == 0.0, modal[(i, i)] * 0.5),
                zero_or(plain.modes[i].omega2 == 0.0, omega2[i]),
            )
        };
        let momentum = x.transpose() * mass;
        let modes = (0..n).map(mode).collect();
        Ok(Cell { modes, rate: plain.rate, load: x.transpose() * load, shapes: x, momentum })
    }
}

/// One step towards XᵀMX = 1. The error of the result is the cube of the error of `x`.
fn orthonormal(mass: &DMatrix<Df64>, x: &DMatrix<Df64>) -> DMatrix<Df64> {
    let n = x.nrows();
    let one = DMatrix::from_diagonal_element(n, n, Df64::from(1.0));
    let e = x.transpose() * mass * x - &one;
    x * (&one - &e * Df64::from(0.5) + &e * &e * Df64::from(0.375))
}

/// The diagonal of a nearly diagonal symmetric matrix after Jacobi rotations. They are applied to the columns of `x` too.
fn diagonal(mut a: DMatrix<Df64>, x: &mut DMatrix<Df64>) -> Vec<Df64> {
    let n = a.nrows();
    let one = Df64::from(1.0);
    for _ in 0..MOST_SWEEPS {
        let mut turned = false;
        for (p, q) in (0..n).flat_map(|p| (p + 1..n).map(move |q| (p, q))) {
            let (app, aqq, apq) = (a[(p, p)], a[(q, q)], (a[(p, q)] + a[(q, p)]) * 0.5);
            if apq.hi().abs() <= COMPENSATED_JACOBI * app.hi().abs().max(aqq.hi().abs()) {
                continue;
            }
            turned = true;
            let theta = (aqq - app) / apq * 0.5;
            let t = one / (theta.abs() + (theta * theta + 1.0).sqrt()) * theta.hi().signum();
            let c = one / (t * t + 1.0).sqrt();
            let s = t * c;
            for i in 0..n {
                (a[(i, p)], a[(i, q)]) = (c * a[(i, p)] - s * a[(i, q)], s * a[(i, p)] + c * a[(i, q)]);
            }
            for i in 0..n {
                (a[(p, i)], a[(q, i)]) = (c * a[(p, i)] - s * a[(q, i)], s * a[(p, i)] + c * a[(q, i)]);
                (x[(i, p)], x[(i, q)]) = (c * x[(i, p)] - s * x[(i, q)], s * x[(i, p)] + c * x[(i, q)]);
            }
        }
        if !turned {
            break;
        }
    }
    (0..n).map(|i| a[(i, i)]).collect()
}
