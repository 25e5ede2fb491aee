//! Any linear cell M q'' + C q' + K q = f with the phase n.q, as equations for the engine. For cases that need no scene.

use gearsim::__private::equations::{Equations, Switching, matrix};
use gearsim::__private::{Cell, Cost, Flight, Matrix, Point, Search, SearchError, Side, Signal, Vector, dot};

/// The matrices of the cell. V = q.K q/2; a step dk of its only law gives dV = dk q_0²/2.
#[derive(Debug, Clone, Copy)]
pub struct Linear<const N: usize> {
    pub mass: [[f64; N]; N],
    pub damping: [[f64; N]; N],
    pub stiffness: [[f64; N]; N],
    pub load: [f64; N],
    pub normal: [f64; N],
}

/// A diagonal matrix.
pub fn diagonal<const N: usize>(of: [f64; N]) -> [[f64; N]; N] {
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { of[i] } else { 0.0 }))
}

impl<const N: usize> Linear<N> {
    /// A cell whose coordinates are its modes, given by (sigma, omega²): M = 1, and the phase is the sum of all modes.
    pub fn modal(modes: [(f64, f64); N], load: [f64; N]) -> Self {
        Linear {
            mass: diagonal([1.0; N]),
            damping: diagonal(modes.map(|(sigma, _)| 2.0 * sigma)),
            stiffness: diagonal(modes.map(|(_, omega2)| omega2)),
            load,
            normal: [1.0; N],
        }
    }

    /// The engine's modes of this cell.
    pub fn cell(&self) -> Cell {
        Cell::new(self, &[]).unwrap_or_else(|refusal| panic!("{refusal}: {self:?}"))
    }
}

impl<const N: usize> Equations for Linear<N> {
    fn coordinates(&self) -> usize {
        N
    }
    fn kinetic(&self, _: &[f64], q_dot: &[f64]) -> f64 {
        0.5 * dot(q_dot, &times(&self.mass, q_dot))
    }
    fn potential(&self, q: &[f64], _: &[f64]) -> f64 {
        0.5 * dot(q, &times(&self.stiffness, q))
    }
    fn dissipation(&self, _: &[f64], q_dot: &[f64], _: &[f64]) -> f64 {
        0.5 * dot(q_dot, &times(&self.damping, q_dot))
    }
    fn torque_work(&self, _: usize, dq: &[f64]) -> f64 {
        self.work(dq)
    }
    fn work(&self, dq: &[f64]) -> f64 {
        dot(&self.load, dq)
    }
    fn write_force(&self, q: &[f64], q_dot: &[f64], _: &[f64], _: &[f64], force: &mut [f64]) {
        let (c, k) = (times(&self.damping, q_dot), times(&self.stiffness, q));
        (0..N).for_each(|i| force[i] = self.load[i] - c[i] - k[i]);
    }
    fn jacobian(&self, _: &[f64], _: &[f64], _: &[f64], _: &[f64], _: &[f64]) -> [Matrix; 2] {
        unreachable!("linear cells are not integrated")
    }
    fn mass(&self, _: &[f64]) -> Matrix {
        matrix(&self.mass)
    }
    fn damping(&self, _: &[f64]) -> Matrix {
        matrix(&self.damping)
    }
    fn stiffness(&self, _: &[f64]) -> Matrix {
        matrix(&self.stiffness)
    }
    fn load(&self, _: &[f64]) -> Vector {
        self.load.into()
    }
    fn motion(&self, _: usize) -> Vector {
        [1.0; N].into()
    }
    fn switching(&self, _: usize) -> Switching {
        Switching::WithJump
    }
    fn normal(&self, _: usize) -> Vector {
        self.normal.into()
    }
    fn step(&self, _: usize, q: &[f64], _: &[f64], dk: f64) -> f64 {
        0.5 * dk * q[0] * q[0]
    }
}

fn times<const N: usize>(a: &[[f64; N]; N], x: &[f64]) -> [f64; N] {
    a.map(|row| dot(&row, x))
}

/// The result of a search: the boundary, the time [s], and the cost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Met {
    pub side: Option<Side>,
    pub t: f64,
    pub cost: Cost,
}

/// Searches for the first boundary that n.q meets before `horizon` [s]. The boundaries are at the distances `down` and `up`.
pub fn first(
    flight: &Flight<'_>,
    participation: &Vector,
    [down, up]: [f64; 2],
    horizon: f64,
) -> Result<Met, SearchError> {
    let (mut point, mut cost): (Point, Cost) = (flight.begin(), Cost::default());
    let signal = Signal { flight, on_moved: participation, on_speed: None, direct: None };
    let search = Search { signal, rate: signal.derivatives(&point)[1], down, up, horizon };
    let side = search.first(&mut point, &mut cost)?;
    Ok(Met { side, t: if side.is_some() { point.t } else { horizon }, cost })
}

/// [`first`] from q = 0 with the speeds `v`.
pub fn first_from<const N: usize>(system: &Linear<N>, v: [f64; N], gaps: [f64; 2], horizon: f64) -> Met {
    let cell = system.cell();
    let flight = cell.flight(&Vector::zeros(N), &v.into());
    let participation = cell.participation(&system.normal.into());
    first(&flight, &participation, gaps, horizon).expect("a search that ends")
}
