//! Forces on the coordinates of trains with the effects `stiffness_step` and `torques`; of the chain and the idler also `damping`.

use super::ByHand;

/// Discs on a shaft, from the motor to the load.
pub struct Chain {
    /// Stiffness and damping of each shaft, damping of each disc.
    pub k: [f64; 4],
    pub c: [f64; 4],
    pub drag: [f64; 5],
    pub motor: f64,
    pub load: f64,
}

/// An idler train: two meshes.
pub struct Idler {
    /// Entries (0, 0), (0, 1), (0, 2), (1, 1), (2, 2) of the damping matrix; the others follow by symmetry or are zero.
    pub c: [f64; 5],
    /// Generalised force of the torques on each coordinate.
    pub torque: [f64; 3],
}

/// A planetary stage with three planets. The meshes are in the order sun, ring of planet 1, sun, ring of planet 2, ...
pub struct Planetary {
    /// Base radius of the ring [m], torsional stiffness of its support [N m/rad].
    pub r_r: f64,
    pub k_r: f64,
    /// Generalised forces of the torques on the phase and on the carrier.
    pub torque: [f64; 2],
}

impl ByHand<5> for Chain {
    fn evaluate(&self, q: &[f64; 5], v: &[f64; 5], _: &[f64], _: &[f64]) -> [f64; 5] {
        let shaft = |i: usize| self.k[i] * (q[i] - q[i + 1]) + self.c[i] * (v[i] - v[i + 1]);
        let [a, b, c, d] = [shaft(0), shaft(1), shaft(2), shaft(3)];
        [
            self.motor - a - self.drag[0] * v[0],
            a - b - self.drag[1] * v[1],
            b - c - self.drag[2] * v[2],
            c - d - self.drag[3] * v[3],
            d - self.load - self.drag[4] * v[4],
        ]
    }
}

impl ByHand<3> for Idler {
    fn evaluate(&self, q: &[f64; 3], v: &[f64; 3], k: &[f64], dk: &[f64]) -> [f64; 3] {
        let Idler { c, torque } = self;
        let jump = (dk[0] * q[1] * q[1] + dk[1] * q[2] * q[2]) / 2.0;
        [
            torque[0] - jump - c[0] * v[0] - c[1] * v[1] - c[2] * v[2],
            torque[1] - k[0] * q[1] - c[1] * v[0] - c[3] * v[1],
            torque[2] - k[1] * q[2] - c[2] * v[0] - c[4] * v[2],
        ]
    }
}

impl ByHand<6> for Planetary {
    fn evaluate(&self, q: &[f64; 6], _: &[f64; 6], k: &[f64], dk: &[f64]) -> [f64; 6] {
        let Planetary { r_r, k_r, torque } = self;
        let turned = r_r * (q[2] - q[1]);
        let (mut jump, mut ring, mut planets) = (0.0, 0.0, [0.0; 3]);
        for (i, planet) in planets.iter_mut().enumerate() {
            let u = q[3 + i];
            let delta = turned - u;
            let force = k[2 * i + 1] * delta;
            jump += dk[2 * i] * u * u + dk[2 * i + 1] * delta * delta;
            ring += force;
            *planet = force - k[2 * i] * u;
        }
        let [a, b, c] = planets;
        [torque[0] - jump / 2.0, torque[1] + r_r * ring, -r_r * ring - k_r * q[2], a, b, c]
    }
}
