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

use gearsim::__private::equations::{Derived, Equations, Switching};
use gearsim::__private::models::GearPair;
use gearsim::__private::{Matrix, Vector};
use gearsim::model::{Coordinate, Model, Start};
use gearsim::scene::{Effects, InitialState, Scene};

use crate::row::Row;

/// A train of discs.
#[derive(Debug, Clone, Copy)]
pub struct Train {
    /// Number of discs.
    pub n: usize,
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

impl Train {
    /// Its scene: that of the gear pair at 4500 rpm with the coordinates of the train.
    ///
    /// # Errors
    /// If the scene of the gear pair does not load.
    pub fn scene(&self) -> anyhow::Result<Scene> {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/scenes/oh2005/spectrum_4500rpm_exact.toml");
        let scene = Scene::load_with(path.as_ref(), &[], &[&GearPair::MODEL]);
        let mut scene = scene.map_err(|e| anyhow::anyhow!("{}", e.render(100, false)))?;
        let coordinates = (0..self.n).map(|i| Coordinate {
            name: if i == 0 { "theta" } else { "x" },
            unit: "rad",
            doc: "",
            start: if i == 0 { Start::At(0.0) } else { Start::Static },
        });
        let coordinates: Vec<_> = coordinates.collect();
        let q = coordinates.iter().map(|c| c.start).collect();
        scene.model = Box::leak(Box::new(Model { coordinates: coordinates.leak(), ..GearPair::MODEL }));
        scene.start = InitialState { q, q_dot: vec![None; self.n], motions: vec![SPEED] };
        scene.effects = Effects::none(scene.model);
        Ok(scene)
    }

    fn diagonal(&self, of: impl Fn(usize) -> f64) -> Matrix {
        Matrix::from_fn(self.n, self.n, |i, j| if i == j { of(i) } else { 0.0 })
    }
}

/// Stiffness of the spring with deflection x_i [N m/rad], where `k` is that of the mesh.
fn spring(k: f64, i: usize) -> f64 {
    if i == 1 { k } else { K_S }
}

impl Equations for Train {
    fn coordinates(&self) -> usize {
        self.n
    }
    fn kinetic(&self, _: &[f64], q_dot: &[f64]) -> f64 {
        let speeds = q_dot.iter().scan(0.0, |sum, v| {
            *sum += v;
            Some(*sum)
        });
        speeds.map(|v| 0.5 * J * v * v).sum()
    }
    fn potential(&self, q: &[f64], k: &[f64]) -> f64 {
        (1..self.n).map(|i| 0.5 * spring(k[0], i) * q[i] * q[i]).sum()
    }
    fn dissipation(&self, _: &[f64], q_dot: &[f64], _: &[f64]) -> f64 {
        (1..self.n).map(|i| 0.5 * self.beta * spring(K_MID, i) * q_dot[i] * q_dot[i]).sum()
    }
    fn torque_work(&self, _: usize, dq: &[f64]) -> f64 {
        self.work(dq)
    }
    fn work(&self, dq: &[f64]) -> f64 {
        -T_0 * dq[1..].iter().sum::<f64>()
    }
    fn write_force(&self, q: &[f64], q_dot: &[f64], k: &[f64], dk: &[f64], force: &mut [f64]) {
        force[0] = -0.5 * dk[0] * q[1] * q[1];
        for i in 1..self.n {
            force[i] = -spring(k[0], i) * q[i] - self.beta * spring(K_MID, i) * q_dot[i] - T_0;
        }
    }
    fn jacobian(&self, _: &[f64], _: &[f64], _: &[f64], _: &[f64], _: &[f64]) -> [Matrix; 2] {
        unreachable!("its cells are linear")
    }
    fn mass(&self, _: &[f64]) -> Matrix {
        Matrix::from_fn(self.n, self.n, |i, j| J * (self.n - i.max(j)) as f64)
    }
    fn damping(&self, _: &[f64]) -> Matrix {
        self.diagonal(|i| if i == 0 { 0.0 } else { self.beta * spring(K_MID, i) })
    }
    fn stiffness(&self, k: &[f64]) -> Matrix {
        self.diagonal(|i| if i == 0 { 0.0 } else { spring(k[0], i) })
    }
    fn load(&self, _: &[f64]) -> Vector {
        Vector::from_fn(self.n, |i| if i == 0 { 0.0 } else { -T_0 })
    }
    fn motion(&self, _: usize) -> Vector {
        self.normal(0)
    }
    fn switching(&self, _: usize) -> Switching {
        Switching::WithJump
    }
    fn normal(&self, _: usize) -> Vector {
        Vector::from_fn(self.n, |i| f64::from(u8::from(i == 0)))
    }
    fn step(&self, _: usize, q: &[f64], _: &[f64], dk: f64) -> f64 {
        0.5 * dk * q[1] * q[1]
    }
}

/// Measures the train of `n` discs with dampers of time constant `beta` [s].
///
/// # Errors
/// If it does not run.
pub fn train(n: usize, beta: f64) -> anyhow::Result<Row> {
    let train = Train { n, beta };
    Row::of(&train.scene()?, &train)
}
