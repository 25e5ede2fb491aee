//! A linear cell: M q'' + C q' + K q = f with constant matrices, taken apart into modes once.
//!
//! K x = omega² M x gives mass-normalised shapes X with Xᵀ M X = 1; q = q_0 + X dxi, and each xi_i moves as a
//! [`Mode`] with sigma_i = (Xᵀ C X)_ii / 2. Rigid-body modes (omega = 0) are exact: K has no part in them.

use nalgebra::{Cholesky, DMatrix, DVector, SMatrix, SVector, SymmetricEigen};

use crate::engine::equations::Equations;
use crate::engine::error::Refusal;
use crate::engine::mode::{Mode, Response};

/// The modes of one cell.
#[derive(Debug, Clone)]
pub struct Cell<const N: usize> {
    /// The modes, by rising frequency.
    pub modes: [Mode; N],
    /// Mode shapes X, one a column: q = X xi.
    pub shapes: SMatrix<f64, N, N>,
    /// Xᵀ M: modal speeds from speeds.
    momentum: SMatrix<f64, N, N>,
    /// Xᵀ K, zero in the rows of rigid modes: modal spring forces from coordinates.
    springs: SMatrix<f64, N, N>,
    /// Xᵀ f: modal loads.
    load: SVector<f64, N>,
    /// Bound on the rates of its modes [1/s].
    rate: f64,
}

/// Frequencies below this fraction of the highest are rigid-body modes blurred by rounding.
const RIGID: f64 = 1e-14;
/// Damping below this fraction of the strongest is rounding.
const UNDAMPED: f64 = 1e-15;
/// Largest damping between two modes, relative to that within them, taken for rounding.
const COUPLED: f64 = 1e-10;

impl<const N: usize> Cell<N> {
    /// The cell of `equations` with law values `k`.
    ///
    /// # Errors
    /// Where M is not positive definite, K is not positive semidefinite, or C couples the modes.
    pub fn new(equations: &dyn Equations<N>, k: &[f64]) -> Result<Self, Refusal> {
        let matrix = |rows: [[f64; N]; N]| DMatrix::<f64>::from_fn(N, N, |i, j| rows[i][j]);
        let (m, c, stiffness) = (matrix(equations.mass()), matrix(equations.damping()), matrix(equations.stiffness(k)));
        let load = DVector::from_fn(N, |i, _| equations.load()[i]);
        if [&m, &c, &stiffness].iter().any(|a| a.iter().any(|x| !x.is_finite())) || load.iter().any(|x| !x.is_finite())
        {
            return Err(Refusal::Overflow);
        }
        if m.diagonal().iter().any(|d| *d <= 0.0) {
            return Err(Refusal::Mass);
        }
        // Scaled to a unit diagonal, so that inertias of any ratio keep their digits.
        let scale = DMatrix::from_diagonal(&m.diagonal().map(|d| 1.0 / d.sqrt()));
        let l = Cholesky::new(&scale * &m * &scale).ok_or(Refusal::Mass)?;
        let inverse = l.l().solve_lower_triangular(&DMatrix::identity(N, N)).ok_or(Refusal::Mass)? * &scale;
        let a = &inverse * &stiffness * inverse.transpose();
        let eigen = SymmetricEigen::new(0.5 * (&a + a.transpose()));
        let highest = eigen.eigenvalues.amax();
        let mut order: Vec<usize> = (0..N).collect();
        order.sort_by(|&i, &j| eigen.eigenvalues[i].total_cmp(&eigen.eigenvalues[j]));

        let shapes = inverse.transpose() * DMatrix::from_fn(N, N, |i, j| eigen.eigenvectors[(i, order[j])]);
        let damping = shapes.transpose() * c * &shapes;
        let strongest = damping.diagonal().amax();
        let mut springs = shapes.transpose() * stiffness;
        let mut modes = [Mode::new(0.0, 0.0); N];
        for i in 0..N {
            let mut omega2 = eigen.eigenvalues[order[i]];
            if omega2.abs() <= RIGID * highest {
                omega2 = 0.0;
                springs.row_mut(i).fill(0.0);
            }
            if omega2 < 0.0 {
                return Err(Refusal::Unstable { omega2 });
            }
            let coupling = (0..N).filter(|&j| j != i).map(|j| damping[(i, j)].abs()).fold(0.0, f64::max);
            if coupling > COUPLED * strongest {
                return Err(Refusal::CoupledDamping { coupling: coupling / strongest });
            }
            // A rounding error's worth of damping is none: an undamped mode must keep its energy.
            let sigma = 0.5 * damping[(i, i)];
            modes[i] = Mode::new(if sigma <= UNDAMPED * strongest { 0.0 } else { sigma }, omega2);
        }
        let (momentum, load) = (shapes.transpose() * m, shapes.transpose() * load);
        let fixed = |a: &DMatrix<f64>| SMatrix::from_fn(|i, j| a[(i, j)]);
        let rate = modes.iter().map(|m| m.rate).fold(0.0, f64::max);
        Ok(Cell {
            modes,
            rate,
            shapes: fixed(&shapes),
            momentum: fixed(&momentum),
            springs: fixed(&springs),
            load: SVector::from_fn(|i, _| load[i]),
        })
    }

    /// The motion from the state (q, q') on, for as long as the cell lasts.
    #[inline]
    pub fn flight(&self, q: &SVector<f64, N>, q_dot: &SVector<f64, N>) -> Flight<'_, N> {
        let speed = self.momentum * q_dot;
        let force = self.load - self.springs * q;
        Flight { cell: self, speed, force }
    }

    /// How the phase n.q follows the modes: n.X (N).
    pub fn participation(&self, normal: &SVector<f64, N>) -> SVector<f64, N> {
        self.shapes.transpose() * normal
    }
}

/// The motion in a cell from a given state on.
#[derive(Debug, Clone)]
pub struct Flight<'a, const N: usize> {
    cell: &'a Cell<N>,
    /// Modal speeds at the start.
    speed: SVector<f64, N>,
    /// Modal forces g - omega² xi at the start.
    force: SVector<f64, N>,
}

/// Where a flight has got to.
#[derive(Debug, Clone, Copy)]
pub struct Point<const N: usize> {
    /// Time from its start [s].
    pub t: f64,
    /// What each mode answers to a unit speed and a unit force.
    responses: [Response; N],
    /// xi(t) - xi(0).
    pub moved: SVector<f64, N>,
    /// xi'(t) - xi'(0).
    pub gained: SVector<f64, N>,
}

impl<'a, const N: usize> Flight<'a, N> {
    /// The modes that carry it.
    pub fn modes(&self) -> &'a [Mode; N] {
        &self.cell.modes
    }

    /// Modal speed and acceleration of mode `i` at the start.
    #[inline]
    pub fn rates_at_start(&self, i: usize) -> (f64, f64) {
        let v = self.speed[i];
        (v, self.force[i] - 2.0 * self.cell.modes[i].sigma * v)
    }

    /// Modal speed and acceleration of mode `i` at a `point` of the flight.
    #[inline]
    pub fn rates(&self, i: usize, point: &Point<N>) -> (f64, f64) {
        let mode = &self.cell.modes[i];
        let v = self.speed[i] + point.gained[i];
        (v, self.force[i] - mode.omega2 * point.moved[i] - 2.0 * mode.sigma * v)
    }

    /// Where it begins.
    #[inline]
    pub fn begin(&self) -> Point<N> {
        let still = Response { s1: 0.0, s2: 0.0, decay: 0.0 };
        Point { t: 0.0, responses: [still; N], moved: SVector::zeros(), gained: SVector::zeros() }
    }

    /// Where it is after the time `t` [s].
    pub fn at(&self, t: f64) -> Point<N> {
        let mut point = self.begin();
        self.go(&mut point, t);
        point
    }

    /// Sets `point` to where it is after the time `t` [s]. In place: a point is too large to be handed about.
    #[inline]
    pub fn go(&self, point: &mut Point<N>, t: f64) {
        point.t = t;
        for i in 0..N {
            point.responses[i] = self.cell.modes[i].response(t);
            self.place(point, i);
        }
    }

    /// Moves `point` a short time `dt` on, or back: |`dt`| * rate <= [`NEAR`](crate::engine::mode::NEAR).
    #[inline]
    pub fn shift(&self, point: &mut Point<N>, dt: f64) {
        point.t += dt;
        for i in 0..N {
            point.responses[i] = self.cell.modes[i].shifted(&point.responses[i], dt);
            self.place(point, i);
        }
    }

    #[inline(always)]
    fn place(&self, point: &mut Point<N>, i: usize) {
        let Mode { sigma, omega2, .. } = self.cell.modes[i];
        let Response { s1, s2, .. } = point.responses[i];
        let (v, f) = (self.speed[i], self.force[i]);
        point.moved[i] = v * s1 + f * s2;
        point.gained[i] = (f - 2.0 * sigma * v) * s1 - omega2 * v * s2;
    }

    /// Bound on the rates of its modes [1/s].
    #[inline]
    pub fn rate(&self) -> f64 {
        self.cell.rate
    }

    /// Increments of q and q' at a point.
    #[inline]
    pub fn increments(&self, point: &Point<N>) -> (SVector<f64, N>, SVector<f64, N>) {
        (self.cell.shapes * point.moved, self.cell.shapes * point.gained)
    }

    /// Energy lost to damping until a point [J], by integration of the speeds.
    #[inline]
    pub fn dissipated(&self, point: &Point<N>) -> f64 {
        let mut lost = 0.0;
        for i in 0..N {
            let mode = &self.cell.modes[i];
            if mode.sigma > 0.0 {
                let (v, a) = self.rates_at_start(i);
                lost += 2.0 * mode.sigma * mode.speed_squared(v, a, point.t, &point.responses[i]);
            }
        }
        lost
    }
}
