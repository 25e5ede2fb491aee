//! Right-hand sides of the gear pair as one would write them by hand, a function a set of effects: Oh, Grosh & Barber
//! (2005), Eqs. (2)-(6). What generated ones are held to.

/// Accelerations of theta and phi from the state and the stiffness, as `Equations` has them.
pub trait RightHandSide {
    fn acceleration(&self, q: &[f64; 2], q_dot: &[f64; 2], k: &[f64], dk: &[f64]) -> [f64; 2];
}

/// Numbers of the pair.
#[derive(Clone, Copy)]
pub struct Pair {
    pub m1: f64,
    pub m2: f64,
    pub c: f64,
    pub t0: f64,
}

/// Eqs. (2), (3) with Rayleigh damping.
pub struct Exact(pub Pair);
/// The same without damping.
pub struct Undamped(pub Pair);
/// Eqs. (4), (5) with damping.
pub struct Rigid(pub Pair);
/// Neither torques nor damping, constant stiffness.
pub struct Free(pub Pair);

impl RightHandSide for Exact {
    fn acceleration(&self, q: &[f64; 2], q_dot: &[f64; 2], k: &[f64], dk: &[f64]) -> [f64; 2] {
        let Pair { m1, m2, c, t0 } = self.0;
        let (phi, phi_dot, square) = (q[1], q_dot[1], q[1] * q[1]);
        [
            -m1 * k[0] * phi - c * m1 * phi_dot + m1 * t0 - m2 * dk[0] * square / 2.0,
            -m2 * k[0] * phi - c * m2 * phi_dot + m2 * t0 - m1 * dk[0] * square / 2.0,
        ]
    }
}

impl RightHandSide for Undamped {
    fn acceleration(&self, q: &[f64; 2], _: &[f64; 2], k: &[f64], dk: &[f64]) -> [f64; 2] {
        let Pair { m1, m2, t0, .. } = self.0;
        let (phi, square) = (q[1], q[1] * q[1]);
        [-m1 * k[0] * phi + m1 * t0 - m2 * dk[0] * square / 2.0, -m2 * k[0] * phi + m2 * t0 - m1 * dk[0] * square / 2.0]
    }
}

impl RightHandSide for Rigid {
    fn acceleration(&self, q: &[f64; 2], q_dot: &[f64; 2], k: &[f64], _: &[f64]) -> [f64; 2] {
        let Pair { m1, m2, c, t0 } = self.0;
        let (phi, phi_dot) = (q[1], q_dot[1]);
        [-m1 * k[0] * phi - c * m1 * phi_dot + m1 * t0, -m2 * k[0] * phi - c * m2 * phi_dot + m2 * t0]
    }
}

impl RightHandSide for Free {
    fn acceleration(&self, q: &[f64; 2], _: &[f64; 2], k: &[f64], _: &[f64]) -> [f64; 2] {
        let Pair { m1, m2, .. } = self.0;
        [-m1 * k[0] * q[1], -m2 * k[0] * q[1]]
    }
}
