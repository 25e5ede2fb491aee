//! Any linear cell M q'' + C q' + K q = f with the phase n.q, as equations for the engine. For cases that need no scene.

use gearsim::engine::cell::{Cell, Flight, Point};
use gearsim::engine::crossing::{Cost, Lost, Search, Side};
use gearsim::engine::equations::{DeadBand, Equations, Switching};
use gearsim::engine::signal::Signal;
use nalgebra::SVector;

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
    pub fn cell(&self) -> Cell<N> {
        Cell::new(self, &[]).unwrap_or_else(|refusal| panic!("{refusal}: {self:?}"))
    }
}

fn times<const N: usize>(a: &[[f64; N]; N], x: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|i| (0..N).map(|j| a[i][j] * x[j]).sum())
}

fn dot<const N: usize>(x: &[f64; N], y: &[f64; N]) -> f64 {
    (0..N).map(|i| x[i] * y[i]).sum()
}

impl<const N: usize> Equations<N> for Linear<N> {
    fn kinetic(&self, q_dot: &[f64; N]) -> f64 {
        0.5 * dot(q_dot, &times(&self.mass, q_dot))
    }
    fn potential(&self, q: &[f64; N], _: &[f64]) -> f64 {
        0.5 * dot(q, &times(&self.stiffness, q))
    }
    fn dissipation(&self, q_dot: &[f64; N], _: &[f64]) -> f64 {
        0.5 * dot(q_dot, &times(&self.damping, q_dot))
    }
    fn torque_work(&self, _: usize, dq: &[f64; N]) -> f64 {
        self.work(dq)
    }
    fn work(&self, dq: &[f64; N]) -> f64 {
        dot(&self.load, dq)
    }
    fn force(&self, q: &[f64; N], q_dot: &[f64; N], _: &[f64], _: &[f64]) -> [f64; N] {
        let (c, k) = (times(&self.damping, q_dot), times(&self.stiffness, q));
        std::array::from_fn(|i| self.load[i] - c[i] - k[i])
    }
    fn jacobian(&self, _: &[f64; N], _: &[f64; N], _: &[f64], _: &[f64], _: &[f64]) -> [[[f64; N]; N]; 2] {
        unreachable!("linear cells are not integrated")
    }
    fn mass(&self) -> [[f64; N]; N] {
        self.mass
    }
    fn damping(&self, _: &[f64]) -> [[f64; N]; N] {
        self.damping
    }
    fn stiffness(&self, _: &[f64]) -> [[f64; N]; N] {
        self.stiffness
    }
    fn load(&self, _: &[f64]) -> [f64; N] {
        self.load
    }
    fn motion(&self, _: usize) -> [f64; N] {
        [1.0; N]
    }
    fn switching(&self, _: usize) -> Switching {
        Switching::WithJump
    }
    fn normal(&self, _: usize) -> [f64; N] {
        self.normal
    }
    fn step(&self, _: usize, q: &[f64; N], _: &[f64], dk: f64) -> f64 {
        0.5 * dk * q[0] * q[0]
    }
    fn dead_band(&self, _: usize) -> Option<DeadBand<N>> {
        None
    }
}

/// The result of a search: the boundary, the time [s], and the cost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Met {
    pub side: Option<Side>,
    pub t: f64,
    pub cost: Cost,
}

/// Searches for the first boundary that n.q meets before `horizon` [s]. The boundaries are at the distances `down` and `up`.
pub fn first<const N: usize>(
    flight: &Flight<'_, N>,
    participation: &SVector<f64, N>,
    [down, up]: [f64; 2],
    horizon: f64,
) -> Result<Met, Lost> {
    let (mut point, mut cost): (Point<N>, Cost) = (flight.begin(), Cost::default());
    let signal = Signal { flight, on_moved: participation, on_speed: None };
    let search = Search { signal, rate: signal.derivatives(&point)[1], down, up, horizon };
    let side = search.first(&mut point, &mut cost)?;
    Ok(Met { side, t: if side.is_some() { point.t } else { horizon }, cost })
}

/// [`first`] from q = 0 with the speeds `v`.
pub fn first_from<const N: usize>(system: &Linear<N>, v: [f64; N], gaps: [f64; 2], horizon: f64) -> Met {
    let cell = system.cell();
    let flight = cell.flight(&SVector::zeros(), &SVector::from(v));
    let participation = cell.participation(&SVector::from(system.normal));
    first(&flight, &participation, gaps, horizon).expect("a search that ends")
}
