//! A linear cell in double-double precision. The modes of the plain cell are refined.
//!
//! The plain shapes X have an error of 1e-16. Two steps X (1 - E/2 + 3 E²/8), E = XᵀMX - 1, make them orthonormal to 1e-32. XᵀKX
//! is then nearly diagonal, and Jacobi rotations diagonalise it. Where motions are held, M, C, K and f are projected onto the
//! remaining motions, q' = Z u, as for the plain cell.

use nalgebra::{DMatrix, DVector};
use xprec::Df64;

use crate::engine::cell::remaining;
use crate::engine::compensated::mode::Mode;
use crate::engine::equations::Matrices;
use crate::engine::modal::Modal;
use crate::engine::vector::Matrix;
use crate::tolerance::modes::{COMPENSATED_COUPLED, COMPENSATED_JACOBI, COMPENSATED_UNDAMPED};

/// The modes of one cell.
#[derive(Debug, Clone)]
pub struct Cell {
    /// The matrices of the cell without holds.
    pub matrices: Matrices<Df64>,
    /// Mode shapes X, one per column: q = X xi.
    pub shapes: DMatrix<Df64>,
    /// Xᵀ M: gives the modal speeds from the speeds.
    pub momentum: DMatrix<Df64>,
    /// Xᵀ K, zero in the rows of rigid modes: gives the modal spring forces from the coordinates.
    pub springs: DMatrix<Df64>,
    /// Xᵀ f: the modal loads.
    pub load: DVector<Df64>,
    /// omega² of each mode \[1/s²\].
    pub omega2: Vec<Df64>,
    /// XᵀCX \[1/s\].
    pub damping: DMatrix<Df64>,
    /// The modes; `None` if damping couples them.
    pub modes: Option<Vec<Mode>>,
    /// Upper bound of the rates of its modes [1/s].
    pub rate: f64,
}

/// Maximum number of sweeps. Jacobi's method converges in about two for a nearly diagonal matrix.
const MOST_SWEEPS: usize = 20;

impl Cell {
    /// The cell with the given matrices, refined from its plain modes and their shapes. The motions along `held` (one column of n numbers per
    /// motion) are held.
    pub fn new(
        matrices: Matrices<Df64>,
        (plain, plain_shapes): (&Modal, &Matrix),
        held: Option<&DMatrix<Df64>>,
    ) -> Self {
        let Matrices { mass, damping, stiffness, load, .. } = &matrices;
        let z = held.map(remaining);
        let seen = |a: &DMatrix<Df64>| z.as_ref().map_or_else(|| a.clone(), |(z, _)| z.transpose() * a * z);
        let plain_shapes = plain_shapes.map(Df64::from);
        let mut x = z.as_ref().map_or_else(|| plain_shapes.clone(), |(_, free)| plain_shapes.select_rows(free));
        for _ in 0..2 {
            x = orthonormal(&seen(mass), &x);
        }
        let is_rigid = |i: usize| plain.modes[i].omega2 == 0.0;
        let omega2 = diagonal(x.transpose() * seen(stiffness) * &x, &mut x, is_rigid);
        let shapes = z.as_ref().map_or_else(|| x.clone(), |(z, _)| z * &x);
        let modal = shapes.transpose() * damping * &shapes;
        let zero = Df64::from(0.0);
        let n = omega2.len();
        let strongest = (0..n).map(|i| modal[(i, i)].hi()).fold(0.0, f64::max);
        let is_damped = |i: usize| modal[(i, i)].hi() > COMPENSATED_UNDAMPED * strongest;
        let damping = DMatrix::from_fn(n, n, |i, j| if is_damped(i) && is_damped(j) { modal[(i, j)] } else { zero });
        let omega2: Vec<Df64> = (0..n).map(|i| if is_rigid(i) { zero } else { omega2[i] }).collect();
        let springs = shapes.transpose() * stiffness;
        let springs = DMatrix::from_fn(n, springs.ncols(), |i, j| if is_rigid(i) { zero } else { springs[(i, j)] });
        let modes = (plain.coupled.is_none() && !are_coupled(&damping))
            .then(|| (0..n).map(|i| Mode::new(damping[(i, i)] * 0.5, omega2[i])).collect());
        let (momentum, load) = (shapes.transpose() * mass, shapes.transpose() * load);
        Cell { rate: rate(plain), matrices, shapes, momentum, springs, load, omega2, damping, modes }
    }

    /// X Xᵀ: M⁻¹, or the mobility of the remaining motions if motions are held.
    pub fn mobility(&self) -> DMatrix<Df64> {
        &self.shapes * self.shapes.transpose()
    }
}

/// Bound on the rates of the modes, with any damping between them \[1/s\].
fn rate(plain: &Modal) -> f64 {
    let strongest = match &plain.coupled {
        // The largest sum of absolute values in a row is an upper bound of the eigenvalues of a symmetric matrix.
        Some(coupled) => coupled.damping.row_iter().map(|row| row.abs().sum()).fold(0.0, f64::max),
        None => plain.modes.iter().map(|mode| 2.0 * mode.sigma).fold(0.0, f64::max),
    };
    plain.modes.iter().map(|mode| mode.omega2.sqrt()).fold(0.0, f64::max) + strongest
}

/// Whether the modal damping couples modes.
fn are_coupled(damping: &DMatrix<Df64>) -> bool {
    let n = damping.nrows();
    let strongest = (0..n).map(|i| damping[(i, i)].hi().abs()).fold(0.0, f64::max);
    let pairs = (0..n).flat_map(|i| (0..i).map(move |j| (i, j)));
    let coupling = pairs.map(|at| damping[at].hi().abs()).fold(0.0, f64::max);
    coupling > COMPENSATED_COUPLED * strongest
}

/// One step towards XᵀMX = 1. The error of the result is the cube of the error of `x`.
fn orthonormal(mass: &DMatrix<Df64>, x: &DMatrix<Df64>) -> DMatrix<Df64> {
    let n = x.nrows();
    let one = DMatrix::from_diagonal_element(n, n, Df64::from(1.0));
    let e = x.transpose() * mass * x - &one;
    x * (&one - &e * Df64::from(0.5) + &e * &e * Df64::from(0.375))
}

/// The diagonal of a nearly diagonal symmetric matrix after Jacobi rotations. They are applied to the columns of `x` too. Rigid modes are
/// not rotated among one another: between them the matrix is zero except for rounding errors.
fn diagonal(mut a: DMatrix<Df64>, x: &mut DMatrix<Df64>, is_rigid: impl Fn(usize) -> bool) -> Vec<Df64> {
    let n = a.nrows();
    let one = Df64::from(1.0);
    for _ in 0..MOST_SWEEPS {
        let mut turned = false;
        for (p, q) in (0..n).flat_map(|p| (p + 1..n).map(move |q| (p, q))) {
            let (app, aqq, apq) = (a[(p, p)], a[(q, q)], (a[(p, q)] + a[(q, p)]) * 0.5);
            let is_small = apq.hi().abs() <= COMPENSATED_JACOBI * app.hi().abs().max(aqq.hi().abs());
            if is_small || is_rigid(p) && is_rigid(q) {
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
