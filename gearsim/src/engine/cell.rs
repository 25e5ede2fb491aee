//! A linear cell: M q'' + C q' + K q = f with constant matrices, decomposed into modes once.
//!
//! With the mass-normalised mode shapes X ([`modal`](crate::engine::modal)), q = q_0 + X dxi, and each modal coordinate xi_i
//! moves as a [`Mode`]. Rigid-body modes are exact: K does not contribute to them. If damping couples the modes, q = q_0 + X dxi
//! + Y dxi' ([`coupling`](crate::engine::coupling)).

use nalgebra::{DMatrix, DVector};
use smallvec::SmallVec;

use crate::engine::conserved::Conserved;
use crate::engine::coupling::Coupling;
use crate::engine::equations::Equations;
use crate::engine::error::Refusal;
use crate::engine::forcing::linear::Linear;
use crate::engine::modal::{Coupled, Matrices, Modal, inverse_root};
use crate::engine::mode::{Mode, Response};
use crate::engine::real::Sized64;
use crate::engine::switch::Switch;
use crate::engine::vector::{Matrix, Vector, transposed};
use crate::tolerance::modes::CANCELLED_STIFFNESS;

/// The modes of one cell.
#[derive(Debug, Clone)]
pub struct Cell {
    /// The modes, in order of rising frequency.
    pub modes: Vec<Mode>,
    /// Mode shapes X, one per column: q = X xi.
    pub shapes: Matrix,
    /// Xᵀ M: gives the modal speeds from the speeds.
    pub momentum: Matrix,
    /// Xᵀ K, zero in the rows of rigid modes: gives the modal spring forces from the coordinates.
    pub springs: Matrix,
    /// Xᵀ f: the modal loads.
    pub load: Vector,
    /// Upper bound of the rates of its modes [1/s].
    pub rate: f64,
    /// The additional matrices of a cell whose modes are coupled by damping.
    pub coupling: Option<Box<Coupling>>,
    /// Rigid motions whose momentum is corrected for rounding errors.
    pub conserved: Vec<Conserved>,
}

impl Cell {
    /// The cell of `equations` without switches, with law values `k`.
    ///
    /// # Errors
    /// Those of [`Modal::of`].
    pub fn new(equations: &dyn Equations, k: &[f64]) -> Result<Self, Refusal> {
        Self::with(equations, &[], k)
    }

    /// The same with `switches` in the modes whose values are among `k`.
    ///
    /// # Errors
    /// Those of [`Modal::of`].
    pub fn with(equations: &dyn Equations, switches: &[Switch], k: &[f64]) -> Result<Self, Refusal> {
        let modal = Modal::of(&matrices(equations, switches, k)?)?;
        Ok(Self::from_modal(&modal, &modal.shapes, &modal.momentum, &modal.springs))
    }

    /// The cell in which the speeds along `normals` (n, one per column) are held at zero, and its equations for time-dependent
    /// loads.
    ///
    /// # Errors
    /// Those of [`Modal::of`].
    pub fn held(
        equations: &dyn Equations,
        (switches, k): (&[Switch], &[f64]),
        normals: &DMatrix<f64>,
    ) -> Result<(Self, Linear), Refusal> {
        let full = matrices(equations, switches, k)?;
        // Z is a basis of the remaining motions: q' = Z u, where u are the speeds of some of the coordinates. M, C, K and f are
        // projected onto it.
        let (z, free) = remaining(normals);
        let select = DMatrix::from_fn(free.len(), z.nrows(), |c, i| f64::from(u8::from(free[c] == i)));
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
        let (momentum, springs) = (&modal.momentum * select, shapes.transpose() * full.stiffness);
        let linear = Linear::seen(&modal, &shapes, &momentum, &springs);
        Ok((Self::from_modal(&modal, &shapes, &momentum, &springs), linear))
    }

    /// Assembles the cell; `shapes`, `momentum` and `springs` are those of the undamped modes.
    fn from_modal(modal: &Modal, shapes: &Matrix, momentum: &Matrix, springs: &Matrix) -> Self {
        Cell {
            modes: modal.modes.clone(),
            rate: modal.modes.iter().map(|m| m.rate).fold(0.0, f64::max),
            shapes: shapes.clone(),
            momentum: momentum.clone(),
            springs: springs.clone(),
            load: (&modal.load).into(),
            coupling: None,
            conserved: vec![],
        }
        .coupled_by(modal.coupled.as_ref())
    }

    /// The cell in the modes that damping leaves independent, instead of the modes of the undamped system.
    fn coupled_by(self, coupled: Option<&Coupled>) -> Self {
        let Some(coupled) = coupled else { return self };
        let ([speed, speed_by_force], [force_by_speed, force]) = (&coupled.speed, &coupled.force);
        let coupling = Coupling::new(
            coupled,
            &self.shapes * &coupled.by_acceleration,
            force_by_speed * &self.momentum,
            (speed_by_force * &self.load, speed_by_force * &self.springs),
            [speed_by_force, force].map(|by| by * self.shapes.transpose()),
        );
        Cell {
            modes: coupled.modes.clone(),
            shapes: &self.shapes * &coupled.by_speed,
            momentum: speed * &self.momentum,
            springs: force * &self.springs,
            load: force * &self.load,
            rate: coupled.modes.iter().map(|m| m.rate).fold(0.0, f64::max),
            coupling: Some(Box::new(coupling)),
            conserved: vec![],
        }
    }

    /// The same cell of `equations` with law values `k`. The momentum of the first `motions` rigid motions is corrected with
    /// double-double precision.
    pub fn conserving(mut self, equations: &dyn Equations, k: &[f64], motions: usize) -> Self {
        let of_cell = [constant_mass(equations), equations.damping(k), equations.stiffness(k)];
        let motions = (0..motions).map(|i| equations.motion(i));
        self.conserved = motions.filter_map(|z| Conserved::of(z, &self, of_cell.each_ref())).collect();
        self
    }

    /// The motion from the state (q, q') on, within this cell.
    #[inline]
    pub fn flight(&self, q: &Vector, q_dot: &Vector) -> Flight<'_> {
        let mut speed = &self.momentum * q_dot;
        let mut force = &self.load - &(&self.springs * q);
        if let Some(coupling) = &self.coupling {
            speed += &coupling.speed(q);
            force += &coupling.force(q_dot);
        }
        Flight { cell: self, speed, force }
    }

    /// The same motion, where the generalised forces at `q` are known: `f`, without those of speeds (n). Those on the vibrations
    /// follow from them. Model forces are zero where flanks just touch, since the deflection beyond the edge is one difference; load and spring
    /// forces of the modes cancel only to their rounding errors, which would part the flanks.
    pub fn flight_under(&self, q: &Vector, q_dot: &Vector, f: &Vector) -> Flight<'_> {
        let mut flight = self.flight(q, q_dot);
        let (speed, force) = match &self.coupling {
            None => (None, transposed(&self.shapes, f)),
            Some(coupling) => {
                let [speed, force] = coupling.push(f);
                (Some(&self.momentum * q_dot + &speed), coupling.force(q_dot) + &force)
            }
        };
        for (i, _) in self.modes.iter().enumerate().filter(|(_, mode)| mode.omega2 > 0.0) {
            flight.force[i] = force[i];
            if let Some(speed) = &speed {
                flight.speed[i] = speed[i];
            }
        }
        flight
    }

    /// The same motion with the generalised forces `f` in addition to the load (n).
    #[cold]
    pub fn pushed(&self, flight: Flight<'_>, f: &Vector) -> Flight<'_> {
        let [speed, force] = match &self.coupling {
            Some(coupling) => coupling.push(f),
            None => [Vector::zeros(self.modes.len()), transposed(&self.shapes, f)],
        };
        Flight { cell: self, speed: flight.speed + &speed, force: flight.force + &force }
    }

    /// The motion of the difference (dq, dq') of two motions. No load acts on it.
    pub fn difference(&self, dq: &Vector, dq_dot: &Vector) -> Flight<'_> {
        let Flight { speed, force, .. } = self.flight(dq, dq_dot);
        let still = Vector::zeros(dq.len());
        let loaded = self.flight(&still, &still);
        Flight { cell: self, speed: speed - &loaded.speed, force: force - &loaded.force }
    }

    /// The factors by which the function c.q + d.q' depends on the displacements of the modes, and on their speeds if it does (N
    /// each).
    pub fn follow(&self, c: &Vector, d: Option<&Vector>) -> (Vector, Option<Vector>) {
        match (&self.coupling, d) {
            (None, d) => (transposed(&self.shapes, c), d.map(|d| transposed(&self.shapes, d))),
            (Some(coupling), d) => {
                let (mut on_moved, mut on_speed) = (transposed(&self.shapes, c), transposed(&coupling.shapes, c));
                if let Some(d) = d {
                    let (by_speed, by_acceleration) = (transposed(&self.shapes, d), transposed(&coupling.shapes, d));
                    for (i, mode) in self.modes.iter().enumerate() {
                        on_moved[i] -= mode.omega2 * by_acceleration[i];
                        on_speed[i] += by_speed[i] - 2.0 * mode.sigma * by_acceleration[i];
                    }
                }
                (on_moved, Some(on_speed))
            }
        }
    }

    /// The factors n.X by which the phase n.q depends on the displacements of the modes (N).
    pub fn participation(&self, normal: &Vector) -> Vector {
        transposed(&self.shapes, normal)
    }
}

/// M, which in a linear cell is the same at every q.
fn constant_mass(equations: &dyn Equations) -> Matrix {
    equations.mass(&Vector::zeros(equations.coordinates()))
}

/// M, M⁻¹, C, K, f of `equations` with `switches` in the modes whose values are among the law values `k`.
///
/// # Errors
/// If M is not positive definite, or a number overflows.
pub fn matrices(equations: &dyn Equations, switches: &[Switch], k: &[f64]) -> Result<Matrices, Refusal> {
    let mass = constant_mass(equations);
    if mass.iter().any(|x| !x.is_finite()) {
        return Err(Refusal::Overflow);
    }
    inverse_root(&mass)?; // an error if M is not positive definite
    Ok(Matrices {
        mobility: equations.mobility(&Vector::zeros(mass.nrows())),
        mass,
        damping: equations.damping(k),
        stiffness: without_roundings(equations.stiffness(k), equations, switches, k),
        load: DVector::from(&equations.load(k)),
    })
}

/// K without what is left, of rounding errors alone, where the forces of switches cancel those of springs: a coordinate without a spring would
/// become one with a very soft spring, whose mode shape is a rounding error.
fn without_roundings(mut stiffness: Matrix, equations: &dyn Equations, switches: &[Switch], k: &[f64]) -> Matrix {
    let cancelling: Vec<(f64, &Vector)> = switches
        .iter()
        .map(|switch| (equations.lost(switch.index, k)[1].abs(), &switch.normal))
        .filter(|(slope, _)| *slope > 0.0)
        .collect();
    if !cancelling.is_empty() {
        let size = |i: usize, j: usize| cancelling.iter().map(|(slope, n)| slope * (n[i] * n[j]).abs()).sum::<f64>();
        let (rows, columns) = stiffness.shape();
        for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
            if stiffness[(i, j)].abs() <= CANCELLED_STIFFNESS * size(i, j) {
                stiffness[(i, j)] = 0.0;
            }
        }
    }
    stiffness
}

/// The motion in a cell from a given state on.
#[derive(Debug, Clone)]
pub struct Flight<'a> {
    cell: &'a Cell,
    /// Modal speeds at the start (N).
    speed: Vector,
    /// Modal forces g - omega² xi at the start (N).
    force: Vector,
}

/// The motion at one instant of a flight.
#[derive(Debug, Clone)]
pub struct Point {
    /// Time since the start of the flight [s].
    pub t: f64,
    /// Responses of each mode to a unit speed and to a unit force.
    responses: SmallVec<[Response; 10]>,
    /// xi(t) - xi(0).
    pub moved: Vector,
    /// xi'(t) - xi'(0).
    pub gained: Vector,
}

impl<'a> Flight<'a> {
    /// The modes of its cell.
    pub fn modes(&self) -> &'a [Mode] {
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
    pub fn rates(&self, i: usize, point: &Point) -> (f64, f64) {
        let mode = &self.cell.modes[i];
        let v = self.speed[i] + point.gained[i];
        (v, self.force[i] - mode.omega2 * point.moved[i] - 2.0 * mode.sigma * v)
    }

    /// Each mode with its speed and acceleration at the start.
    #[inline]
    pub fn motions_at_start(&self) -> impl Iterator<Item = (&'a Mode, f64, f64)> {
        let start = self.speed.iter().zip(&*self.force);
        self.cell.modes.iter().zip(start).map(|(mode, (v, f))| (mode, *v, f - 2.0 * mode.sigma * v))
    }

    /// Each mode with its speed and acceleration at a `point` of the flight.
    #[inline]
    pub fn motions(&self, point: &Point) -> impl Iterator<Item = (&'a Mode, f64, f64)> {
        let start = self.speed.iter().zip(&*self.force);
        let since = point.moved.iter().zip(&*point.gained);
        self.cell.modes.iter().zip(start.zip(since)).map(|(mode, ((v, f), (moved, gained)))| {
            let v = v + gained;
            (mode, v, f - mode.omega2 * moved - 2.0 * mode.sigma * v)
        })
    }

    /// The point at the start.
    #[inline]
    pub fn begin(&self) -> Point {
        let still = Response { s1: 0.0, s2: 0.0, decay: 0.0 };
        let n = self.speed.len();
        let (moved, gained) = (Vector::zeros(n), Vector::zeros(n));
        Point { t: 0.0, responses: SmallVec::from_elem(still, n), moved, gained }
    }

    /// The point after the time `t` [s].
    pub fn at(&self, t: f64) -> Point {
        let mut point = self.begin();
        self.go(&mut point, t);
        point
    }

    /// Moves `point` to the time `t` [s]. It works in place, because a point is expensive to copy.
    #[inline]
    pub fn go(&self, point: &mut Point, t: f64) {
        point.t = t;
        self.place(point, |mode, _| mode.response(t));
    }

    /// Moves `point` by a short time `dt` [s] of either sign: |`dt`| * rate <=
    /// `tolerance::modes::SHIFT_SPAN`.
    #[inline]
    pub fn shift(&self, point: &mut Point, dt: f64) {
        point.t += dt;
        self.place(point, |mode, response| mode.shifted(response, dt));
    }

    /// Updates `point` with the new response of each mode, which `respond` computes.
    #[inline(always)]
    fn place(&self, point: &mut Point, respond: impl Fn(&Mode, &Response) -> Response) {
        let Point { responses, moved, gained, .. } = point;
        let start = self.speed.iter().zip(&*self.force);
        let places = responses.iter_mut().zip(moved.iter_mut().zip(gained.iter_mut()));
        for ((mode, (v, f)), (response, (moved, gained))) in self.cell.modes.iter().zip(start).zip(places) {
            *response = respond(mode, response);
            let Response { s1, s2, .. } = *response;
            *moved = v * s1 + f * s2;
            *gained = (f - 2.0 * mode.sigma * v) * s1 - mode.omega2 * s2 * v;
        }
    }

    /// Upper bound of the rates of its modes [1/s].
    #[inline]
    pub fn rate(&self) -> f64 {
        self.cell.rate
    }

    /// Increments of q and q' since the start, at a point (N each).
    #[inline]
    pub fn increments(&self, point: &Point) -> (Vector, Vector) {
        let (shapes, Point { moved, gained, .. }) = (&self.cell.shapes, point);
        let mut dv = shapes * gained;
        for Conserved { motion, on_gained, .. } in &self.cell.conserved {
            dv.add_times(-on_gained.dot(gained), motion);
        }
        let Some(coupling) = &self.cell.coupling else { return (shapes * moved, dv) };
        let further = Vector::from_fn(moved.len(), |i| self.cell.modes[i].next(moved[i], gained[i]));
        for Conserved { motion, on_further, .. } in &self.cell.conserved {
            dv.add_times(-on_further.as_ref().map_or(0.0, |on_further| on_further.dot(&further)), motion);
        }
        (shapes * moved + &(&coupling.shapes * gained), dv + &(&coupling.shapes * &further))
    }

    /// Energy dissipated from the start to a point [J], an integral of the speeds.
    #[inline]
    pub fn dissipated(&self, point: &Point) -> f64 {
        if let Some(coupling) = &self.cell.coupling {
            return coupling.dissipated(self, point.t);
        }
        let mut dissipated = 0.0;
        for i in 0..self.speed.len() {
            let mode = &self.cell.modes[i];
            if mode.sigma > 0.0 {
                let (v, a) = self.rates_at_start(i);
                dissipated += mode.dissipated(v, a, point.t, &point.responses[i]);
            }
        }
        dissipated
    }
}
/// A basis of the motions along which all `normals` (n, one per column) vanish, one per column, and the coordinates whose speeds are the
/// components. Each normal is solved for the
/// coordinate with its largest coefficient (Gauss and Jordan), so that a coordinate that is held by itself is at rest exactly.
pub(crate) fn remaining<R: Sized64>(normals: &DMatrix<R>) -> (DMatrix<R>, Vec<usize>) {
    let n = normals.nrows();
    let mut rows: Vec<Vec<R>> = (0..normals.ncols()).map(|c| normals.column(c).iter().copied().collect()).collect();
    let mut solved: Vec<usize> = vec![];
    for i in 0..rows.len() {
        let open = (0..n).filter(|j| !solved.contains(j));
        let size = |j: usize| rows[i][j].rounded().abs();
        let largest = open.max_by(|&a, &b| size(a).total_cmp(&size(b)));
        let Some(largest) = largest else { break };
        let row: Vec<R> = rows[i].iter().map(|x| *x / rows[i][largest]).collect();
        rows[i].clone_from(&row);
        for (_, other) in rows.iter_mut().enumerate().filter(|(other, _)| *other != i) {
            let factor = other[largest];
            other.iter_mut().zip(&row).for_each(|(x, by)| *x = *x - *by * factor);
        }
        solved.push(largest);
    }
    let free: Vec<usize> = (0..n).filter(|j| !solved.contains(j)).collect();
    let basis = DMatrix::from_fn(n, free.len(), |i, c| match solved.iter().position(|&j| j == i) {
        Some(row) => -rows[row][free[c]],
        None => R::from(f64::from(u8::from(free[c] == i))),
    });
    (basis, free)
}
