//! A train of any number of discs. Its equations are written by hand, so that no derived file is needed for each number of
//! coordinates, and their evaluation costs little beside the engine.
//!
//! Disc 1 drives disc 2 through a mesh whose stiffness k steps with theta; shafts of stiffness k_s connect the other discs. With
//! theta the rotation of disc 1 and x_i that of disc i + 1 relative to disc i, disc i turns by theta + x_1 + ... + x_{i-1}, and
//!
//! ```text
//! T = sum J (theta' + x_1' + ... + x_{i-1}')²/2     V = (k x_1² + k_s x_2² + ... + k_s x_{N-1}²)/2
//! ```
//!
//! Dampers act in parallel with the springs, in proportion to k_mid and k_s. Since k differs from k_mid, they couple the modes.

use gearsim::engine::equations::{DeadBand, Derived, Equations, Switching};
use gearsim::generated::gear_pair::GearPair;
use gearsim::model::{Coordinate, Model, Start};
use gearsim::scene::{Effects, InitialState, Scene};

use crate::row::Row;

/// The train of N discs.
#[derive(Debug, Clone, Copy)]
pub struct Train<const N: usize> {
    /// Time constant of the dampers, c = beta k [s]; 0 for none.
    pub beta: f64,
}

/// Inertia of a disc [kg m²].
const J: f64 = 1e-3;
/// Mid mesh stiffness k_mid [N m/rad].
const K_MID: f64 = 2.105e3;
/// Stiffness k_s of a shaft [N m/rad].
const K_S: f64 = 2e4;
/// Torque that drives the first disc and brakes the last [N m].
const T_0: f64 = 0.5;
/// Speed [rad/s]: more than twice the highest natural frequency of a train of any length, (4 k_s/J)^(1/2), so that no
/// parametric resonance builds up in undamped trains.
const SPEED: f64 = 2e4;

impl<const N: usize> Train<N> {
    /// Its scene: that of the gear pair at 4500 rpm with the coordinates of the train.
    ///
    /// # Errors
    /// If the scene of the gear pair does not load.
    pub fn scene() -> anyhow::Result<Scene> {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/scenes/oh2005/spectrum_4500rpm_exact.toml");
        let scene = Scene::load(path.as_ref(), &[], &[&GearPair::MODEL]);
        let mut scene = scene.map_err(|e| anyhow::anyhow!("{}", e.render(100, false)))?;
        let coordinates = (0..N).map(|i| Coordinate {
            name: if i == 0 { "theta" } else { "x" },
            unit: "rad",
            doc: "",
            start: if i == 0 { Start::At(0.0) } else { Start::Static },
        });
        let coordinates: Vec<_> = coordinates.collect();
        let q = coordinates.iter().map(|c| c.start).collect();
        scene.model = Box::leak(Box::new(Model { coordinates: coordinates.leak(), ..GearPair::MODEL }));
        scene.start = InitialState { q, q_dot: vec![None; N], motions: vec![SPEED] };
        scene.effects = Effects(0);
        Ok(scene)
    }
}

/// Stiffness of the spring with deflection x_i [N m/rad], where `k` is that of the mesh.
fn spring(k: f64, i: usize) -> f64 {
    if i == 1 { k } else { K_S }
}

impl<const N: usize> Equations<N> for Train<N> {
    fn kinetic(&self, q_dot: &[f64; N]) -> f64 {
        let speeds = q_dot.iter().scan(0.0, |sum, v| {
            *sum += v;
            Some(*sum)
        });
        speeds.map(|v| 0.5 * J * v * v).sum()
    }
    fn potential(&self, q: &[f64; N], k: &[f64]) -> f64 {
        (1..N).map(|i| 0.5 * spring(k[0], i) * q[i] * q[i]).sum()
    }
    fn dissipation(&self, q_dot: &[f64; N], _: &[f64]) -> f64 {
        (1..N).map(|i| 0.5 * self.beta * spring(K_MID, i) * q_dot[i] * q_dot[i]).sum()
    }
    fn torque_work(&self, _: usize, dq: &[f64; N]) -> f64 {
        self.work(dq)
    }
    fn work(&self, dq: &[f64; N]) -> f64 {
        -T_0 * dq[1..].iter().sum::<f64>()
    }
    fn force(&self, q: &[f64; N], q_dot: &[f64; N], k: &[f64], dk: &[f64]) -> [f64; N] {
        std::array::from_fn(|i| match i {
            0 => -0.5 * dk[0] * q[1] * q[1],
            _ => -spring(k[0], i) * q[i] - self.beta * spring(K_MID, i) * q_dot[i] - T_0,
        })
    }
    fn jacobian(&self, _: &[f64; N], _: &[f64; N], _: &[f64], _: &[f64], _: &[f64]) -> [[[f64; N]; N]; 2] {
        unreachable!("its cells are linear")
    }
    fn mass(&self) -> [[f64; N]; N] {
        std::array::from_fn(|i| std::array::from_fn(|j| J * (N - i.max(j)) as f64))
    }
    fn damping(&self, _: &[f64]) -> [[f64; N]; N] {
        diagonal(|i| if i == 0 { 0.0 } else { self.beta * spring(K_MID, i) })
    }
    fn stiffness(&self, k: &[f64]) -> [[f64; N]; N] {
        diagonal(|i| if i == 0 { 0.0 } else { spring(k[0], i) })
    }
    fn load(&self, _: &[f64]) -> [f64; N] {
        std::array::from_fn(|i| if i == 0 { 0.0 } else { -T_0 })
    }
    fn motion(&self, _: usize) -> [f64; N] {
        self.normal(0)
    }
    fn switching(&self, _: usize) -> Switching {
        Switching::WithJump
    }
    fn normal(&self, _: usize) -> [f64; N] {
        std::array::from_fn(|i| f64::from(u8::from(i == 0)))
    }
    fn step(&self, _: usize, q: &[f64; N], _: &[f64], dk: f64) -> f64 {
        0.5 * dk * q[1] * q[1]
    }
    fn dead_band(&self, _: usize) -> Option<DeadBand<N>> {
        None
    }
}

fn diagonal<const N: usize>(of: impl Fn(usize) -> f64) -> [[f64; N]; N] {
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { of(i) } else { 0.0 }))
}

/// Measures the train of N discs with dampers of time constant `beta` [s].
///
/// # Errors
/// If it does not run.
pub fn train<const N: usize>(beta: f64) -> anyhow::Result<Row> {
    Row::of(&Train::<N>::scene()?, &Train::<N> { beta })
}
