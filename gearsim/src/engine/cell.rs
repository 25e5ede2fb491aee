//! A linear cell: M q'' + C q' + K q = f with constant matrices, decomposed into modes once.
//!
//! With the mass-normalised mode shapes X ([`modal`](crate::engine::modal)), q = q_0 + X dxi, where dxi are the changes of the modal
//! coordinates. Each modal coordinate xi_i moves as a [`Mode`]. Rigid-body modes are exact: K does not contribute to them. If damping
//! couples the modes, q = q_0 + X dxi + Y dxi' ([`coupling`](crate::engine::coupling)).

use nalgebra::DMatrix;

use crate::engine::conserved::Conserved;
use crate::engine::coupling::Coupling;
use crate::engine::equations::Equations;
use crate::engine::error::Refusal;
use crate::engine::modal::{Coupled, Matrices, Modal, inverse_root};
use crate::engine::mode::Mode;
use crate::engine::real::Sized64;
use crate::engine::switch::Switch;
use crate::engine::vector::{Matrix, Vector, transposed};
use crate::tolerance::events::BALANCED_RATES;

mod driven;
mod flight;
mod gains;
mod matrices;
mod speeds;

pub use driven::{Driven, Varying};
pub use flight::{Flight, Point};
pub use gains::Gains;
pub use matrices::matrices;
pub use speeds::{Moments, Speed, Sum, derivative, rate_of};

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
    /// Those of [`matrices`] and [`Modal::of`].
    pub fn new(equations: &dyn Equations, k: &[f64]) -> Result<Self, Refusal> {
        Self::of(&matrices(equations, &[], k)?)
    }

    /// The cell with these matrices.
    ///
    /// # Errors
    /// Those of [`Modal::of`].
    pub fn of(matrices: &Matrices) -> Result<Self, Refusal> {
        let modal = Modal::of(matrices)?;
        Ok(Self::from_modal(&modal, &modal.shapes, &modal.momentum, &modal.springs))
    }

    /// The cell in which the speeds along `normals` (one column of n numbers per held motion) are zero.
    ///
    /// # Errors
    /// Those of [`Modal::of`].
    pub fn held(
        equations: &dyn Equations,
        values: (&[Switch], &[f64]),
        normals: &DMatrix<f64>,
    ) -> Result<Self, Refusal> {
        let HeldModes { modal, shapes, momentum, springs } = HeldModes::of(equations, values, normals)?;
        Ok(Self::from_modal(&modal, &shapes, &momentum, &springs))
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

    /// The cell in the damped modes, if damping couples the undamped ones; otherwise the cell unchanged.
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

    /// The same cell, which corrects the momentum of the first `motions` rigid motions of `equations` ([`Conserved`]). `matrices` are those
    /// of the cell.
    pub fn conserving(mut self, equations: &dyn Equations, matrices: &Matrices, motions: usize) -> Self {
        let of_cell = [&matrices.mass, &matrices.damping, &matrices.stiffness];
        let motions = (0..motions).map(|i| equations.motion(i));
        self.conserved = motions.filter_map(|z| Conserved::of(z, &self, of_cell)).collect();
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
        Flight { cell: self, speed, force, driven: None }
    }

    /// The same motion from the known generalised forces `f` (n) at `q`, without forces that depend on speeds. The forces on the vibrations
    /// are computed from `f` instead of from the load and `q`. Where flanks just touch, `f` is exactly zero, because the deflection beyond
    /// the edge is a single difference. The load and the spring forces of the modes cancel only to rounding errors, which would separate
    /// the flanks.
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

    /// The same motion with the generalised forces `f` (n) in addition to the load.
    #[cold]
    pub fn pushed<'a>(&'a self, flight: Flight<'a>, f: &Vector) -> Flight<'a> {
        let [speed, force] = match &self.coupling {
            Some(coupling) => coupling.push(f),
            None => [Vector::zeros(self.modes.len()), transposed(&self.shapes, f)],
        };
        Flight { speed: flight.speed + &speed, force: flight.force + &force, ..flight }
    }

    /// The same motion, with forces on the modes that cancel to rounding errors set to zero. `q` are the coordinates at its start. A rounding
    /// error would separate flanks that just touch.
    #[cold]
    pub fn balanced<'a>(&'a self, mut flight: Flight<'a>, q: &Vector) -> Flight<'a> {
        let sizes = self.load.abs() + &(&self.springs.abs() * &q.abs());
        flight.force =
            flight.force.zip_map(&sizes, |force, size| if force.abs() <= BALANCED_RATES * size { 0.0 } else { force });
        flight
    }

    /// The motion of the difference (dq, dq') of two motions. No load acts on it.
    pub fn difference(&self, dq: &Vector, dq_dot: &Vector) -> Flight<'_> {
        let Flight { speed, force, .. } = self.flight(dq, dq_dot);
        let still = Vector::zeros(dq.len());
        let loaded = self.flight(&still, &still);
        Flight { speed: speed - &loaded.speed, force: force - &loaded.force, ..loaded }
    }

    /// The slopes of the function c.q + d.q' with respect to the modal displacements (one per mode), and with respect to the modal speeds
    /// if it depends on them.
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

    /// The slopes n.X of the phase n.q with respect to the modal displacements (one per mode).
    pub fn participation(&self, normal: &Vector) -> Vector {
        transposed(&self.shapes, normal)
    }
}

/// The undamped modes of a cell in which motions are held; `shapes`, `momentum` and `springs` refer to all coordinates.
pub struct HeldModes {
    pub modal: Modal,
    pub shapes: Matrix,
    momentum: Matrix,
    springs: Matrix,
}

impl HeldModes {
    /// The modes with zero speeds along `normals` (one column of n numbers per held motion).
    ///
    /// # Errors
    /// Those of [`Modal::of`].
    pub fn of(
        equations: &dyn Equations,
        (switches, k): (&[Switch], &[f64]),
        normals: &DMatrix<f64>,
    ) -> Result<Self, Refusal> {
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
        Ok(HeldModes { modal, shapes, momentum, springs })
    }
}

/// A basis Z of the motions that the holds leave free, one motion per column, and the coordinates whose speeds are the components in this
/// basis. `normals` has one column of n numbers per hold; its product with each column of Z is zero. Each normal is solved for the
/// coordinate with its largest coefficient (Gauss-Jordan elimination). A coordinate that is held alone is then exactly at rest.
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
