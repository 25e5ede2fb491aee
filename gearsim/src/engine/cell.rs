//! A linear cell: M q'' + C q' + K q = f with constant matrices, taken apart into modes once.
//!
//! With mass-normalised shapes X ([`modal`](crate::engine::modal)), q = q_0 + X dxi, and each xi_i moves as a [`Mode`].
//! Rigid-body modes are exact: K has no part in them. Where damping couples the modes, q = q_0 + X dxi + Y dxi'
//! ([`coupling`](crate::engine::coupling)).

use nalgebra::{DMatrix, DVector, SMatrix, SVector};

use crate::engine::conserved::Conserved;
use crate::engine::coupling::Coupling;
use crate::engine::equations::Equations;
use crate::engine::error::Refusal;
use crate::engine::forcing::linear::Linear;
use crate::engine::modal::{Coupled, Matrices, Modal, inverse_root};
use crate::engine::mode::{Mode, Response};

/// The modes of one cell.
#[derive(Debug, Clone)]
pub struct Cell<const N: usize> {
    /// The modes, by rising frequency.
    pub modes: [Mode; N],
    /// Mode shapes X, one a column: q = X xi.
    pub shapes: SMatrix<f64, N, N>,
    /// Xᵀ M: modal speeds from speeds.
    pub momentum: SMatrix<f64, N, N>,
    /// Xᵀ K, zero in the rows of rigid modes: modal spring forces from coordinates.
    pub springs: SMatrix<f64, N, N>,
    /// Xᵀ f: modal loads.
    pub load: SVector<f64, N>,
    /// Bound on the rates of its modes [1/s].
    pub rate: f64,
    /// What is more where damping couples the modes.
    pub coupling: Option<Box<Coupling<N>>>,
    /// Rigid motions whose momentum is not to change by rounding.
    pub conserved: Vec<Conserved<N>>,
}

impl<const N: usize> Cell<N> {
    /// The cell of `equations` with law values `k`.
    ///
    /// # Errors
    /// Those of [`Modal::of`].
    pub fn new(equations: &dyn Equations<N>, k: &[f64]) -> Result<Self, Refusal> {
        let modal = Modal::of(&matrices(equations, k)?)?;
        Ok(Self::from_modal(&modal, &modal.shapes, &modal.momentum, &modal.springs))
    }

    /// The cell in which the speeds along `normals` (N, one a column) are held at zero, and the same for windows.
    ///
    /// # Errors
    /// Those of [`Modal::of`].
    pub fn held(equations: &dyn Equations<N>, k: &[f64], normals: &DMatrix<f64>) -> Result<(Self, Linear<N>), Refusal> {
        let full = matrices(equations, k)?;
        // Z spans the motions that are left, orthonormal: q' = Z u, and M, C, K, f are seen through it.
        let q = normals.clone().insert_columns(normals.ncols(), N, 0.0);
        let q = (q + DMatrix::from_fn(N, normals.ncols() + N, |i, j| f64::from(u8::from(i + normals.ncols() == j))))
            .qr()
            .q();
        let z = q.columns(normals.ncols(), N - normals.ncols()).into_owned();
        let seen = |a: &DMatrix<f64>| z.transpose() * a * &z;
        let mass = seen(&full.mass);
        let inverse = inverse_root(&mass)?;
        let modal = Modal::of(&Matrices {
            mobility: inverse.transpose() * inverse,
            mass,
            damping: seen(&full.damping),
            stiffness: seen(&full.stiffness),
            load: z.transpose() * &full.load,
        })?;
        let shapes = &z * &modal.shapes;
        let (momentum, springs) = (&modal.momentum * z.transpose(), shapes.transpose() * full.stiffness);
        let linear = Linear::seen(&modal, &shapes, &momentum, &springs);
        Ok((Self::from_modal(&modal, &shapes, &momentum, &springs), linear))
    }

    /// With N modes; those that are not there are at rest for ever. `shapes` and the like are those of the undamped modes.
    fn from_modal(modal: &Modal, shapes: &DMatrix<f64>, momentum: &DMatrix<f64>, springs: &DMatrix<f64>) -> Self {
        let rows = |a: &DMatrix<f64>| SMatrix::from_fn(|i, j| if i < a.nrows() { a[(i, j)] } else { 0.0 });
        Cell {
            modes: std::array::from_fn(|i| modal.modes.get(i).copied().unwrap_or(Mode::new(0.0, 0.0))),
            rate: modal.modes.iter().map(|m| m.rate).fold(0.0, f64::max),
            shapes: SMatrix::from_fn(|i, j| if j < shapes.ncols() { shapes[(i, j)] } else { 0.0 }),
            momentum: rows(momentum),
            springs: rows(springs),
            load: SVector::from_fn(|i, _| modal.load.get(i).copied().unwrap_or(0.0)),
            coupling: None,
            conserved: vec![],
        }
        .coupled_by(modal.coupled.as_ref())
    }

    /// The cell in the modes that move by themselves, instead of those of the undamped system.
    fn coupled_by(self, coupled: Option<&Coupled>) -> Self {
        let Some(coupled) = coupled else { return self };
        let whole = |a: &DMatrix<f64>| {
            SMatrix::<f64, N, N>::from_fn(|i, j| if i < a.nrows() && j < a.ncols() { a[(i, j)] } else { 0.0 })
        };
        let ([speed, speed_by_force], [force_by_speed, force]) =
            (coupled.speed.each_ref().map(whole), coupled.force.each_ref().map(whole));
        let coupling = Coupling::new(
            coupled,
            self.shapes * whole(&coupled.by_acceleration),
            force_by_speed * self.momentum,
            (speed_by_force * self.load, speed_by_force * self.springs),
            [speed_by_force, force].map(|by| by * self.shapes.transpose()),
        );
        Cell {
            modes: std::array::from_fn(|i| coupled.modes.get(i).copied().unwrap_or(Mode::new(0.0, 0.0))),
            shapes: self.shapes * whole(&coupled.by_speed),
            momentum: speed * self.momentum,
            springs: force * self.springs,
            load: force * self.load,
            rate: coupled.modes.iter().map(|m| m.rate).fold(0.0, f64::max),
            coupling: Some(Box::new(coupling)),
            conserved: vec![],
        }
    }

    /// The same cell, of `equations` with law values `k`, in which as many of their rigid `motions` keep their momentum to twice
    /// the digits.
    pub fn conserving(mut self, equations: &dyn Equations<N>, k: &[f64], motions: usize) -> Self {
        let matrix = |rows: [[f64; N]; N]| SMatrix::from_fn(|i, j| rows[i][j]);
        let of_cell = [equations.mass(), equations.damping(k), equations.stiffness(k)].map(matrix);
        let motions = (0..motions).map(|i| SVector::from(equations.motion(i)));
        self.conserved = motions.filter_map(|z| Conserved::of(z, &self, of_cell.each_ref())).collect();
        self
    }

    /// The motion from the state (q, q') on, for as long as the cell lasts.
    #[inline]
    pub fn flight(&self, q: &SVector<f64, N>, q_dot: &SVector<f64, N>) -> Flight<'_, N> {
        let mut speed = self.momentum * q_dot;
        let mut force = self.load - self.springs * q;
        if let Some(coupling) = &self.coupling {
            speed += coupling.speed(q);
            force += coupling.force(q_dot);
        }
        Flight { cell: self, speed, force }
    }

    /// The same under the generalised forces `f` beside its load.
    #[cold]
    pub fn pushed(&self, flight: Flight<'_, N>, f: &SVector<f64, N>) -> Flight<'_, N> {
        let [speed, force] = match &self.coupling {
            Some(coupling) => coupling.push(f),
            None => [SVector::zeros(), self.shapes.tr_mul(f)],
        };
        Flight { cell: self, speed: flight.speed + speed, force: flight.force + force }
    }

    /// The motion of the difference (dq, dq') of two motions: no load acts on it.
    pub fn difference(&self, dq: &SVector<f64, N>, dq_dot: &SVector<f64, N>) -> Flight<'_, N> {
        let Flight { speed, force, .. } = self.flight(dq, dq_dot);
        let loaded = self.flight(&SVector::zeros(), &SVector::zeros());
        Flight { cell: self, speed: speed - loaded.speed, force: force - loaded.force }
    }

    /// How c.q + d.q' follows the modes: by what they move, and by what speed they gain, if that counts (N each).
    pub fn follow(
        &self,
        c: &SVector<f64, N>,
        d: Option<&SVector<f64, N>>,
    ) -> (SVector<f64, N>, Option<SVector<f64, N>>) {
        match (&self.coupling, d) {
            (None, d) => (self.shapes.tr_mul(c), d.map(|d| self.shapes.tr_mul(d))),
            (Some(coupling), d) => {
                let (mut on_moved, mut on_speed) = (self.shapes.tr_mul(c), coupling.shapes.tr_mul(c));
                if let Some(d) = d {
                    let (by_speed, by_acceleration) = (self.shapes.tr_mul(d), coupling.shapes.tr_mul(d));
                    for (i, mode) in self.modes.iter().enumerate() {
                        on_moved[i] -= mode.omega2 * by_acceleration[i];
                        on_speed[i] += by_speed[i] - 2.0 * mode.sigma * by_acceleration[i];
                    }
                }
                (on_moved, Some(on_speed))
            }
        }
    }

    /// How the phase n.q follows what the modes move: n.X (N).
    pub fn participation(&self, normal: &SVector<f64, N>) -> SVector<f64, N> {
        self.shapes.transpose() * normal
    }
}

/// M, M⁻¹, C, K, f of `equations` with law values `k`.
///
/// # Errors
/// Where M is not positive definite, or a number overflows.
pub fn matrices<const N: usize>(equations: &dyn Equations<N>, k: &[f64]) -> Result<Matrices, Refusal> {
    let matrix = |rows: [[f64; N]; N]| DMatrix::<f64>::from_fn(N, N, |i, j| rows[i][j]);
    let mass = matrix(equations.mass());
    if mass.iter().any(|x| !x.is_finite()) {
        return Err(Refusal::Overflow);
    }
    inverse_root(&mass)?; // refuses what is not positive definite
    Ok(Matrices {
        mobility: matrix(equations.mobility()),
        mass,
        damping: matrix(equations.damping(k)),
        stiffness: matrix(equations.stiffness(k)),
        load: DVector::from_row_slice(&equations.load(k)),
    })
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
        point.gained[i] = (f - 2.0 * sigma * v) * s1 - omega2 * s2 * v;
    }

    /// Bound on the rates of its modes [1/s].
    #[inline]
    pub fn rate(&self) -> f64 {
        self.cell.rate
    }

    /// Increments of q and q' at a point.
    #[inline]
    pub fn increments(&self, point: &Point<N>) -> (SVector<f64, N>, SVector<f64, N>) {
        let (shapes, Point { moved, gained, .. }) = (&self.cell.shapes, point);
        let mut dv = shapes * gained;
        for Conserved { motion, on_gained, .. } in &self.cell.conserved {
            dv -= motion * on_gained.dot(gained);
        }
        let Some(coupling) = &self.cell.coupling else { return (shapes * moved, dv) };
        let further = SVector::from_fn(|i, _| self.cell.modes[i].next(moved[i], gained[i]));
        for Conserved { motion, on_further, .. } in &self.cell.conserved {
            dv -= motion * on_further.map_or(0.0, |on_further| on_further.dot(&further));
        }
        (shapes * moved + coupling.shapes * gained, dv + coupling.shapes * further)
    }

    /// Energy lost to damping until a point [J], by integration of the speeds.
    #[inline]
    pub fn dissipated(&self, point: &Point<N>) -> f64 {
        if let Some(coupling) = &self.cell.coupling {
            return coupling.dissipated(self, point.t);
        }
        let mut lost = 0.0;
        for i in 0..N {
            let mode = &self.cell.modes[i];
            if mode.sigma > 0.0 {
                let (v, a) = self.rates_at_start(i);
                lost += mode.lost(v, a, point.t, &point.responses[i]);
            }
        }
        lost
    }
}
