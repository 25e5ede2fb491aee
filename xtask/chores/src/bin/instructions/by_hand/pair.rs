//! The gear pair: Oh, Grosh & Barber (2005), Eqs. (2)-(5), and the same with further effects.

use super::ByHand;

/// Constants of the pair: M1, M2, C = 2 zeta sqrt(k_mid/M2), T0.
#[derive(Clone, Copy)]
pub struct Pair {
    pub m1: f64,
    pub m2: f64,
    pub c: f64,
    pub t0: f64,
}

/// Eqs. (2), (3) with Rayleigh damping.
pub struct Exact(pub Pair);
/// Eqs. (2), (3) without damping.
pub struct Undamped(pub Pair);
/// Eqs. (4), (5) with damping.
pub struct Rigid(pub Pair);
/// Without torques, damping and steps of the stiffness.
pub struct Free(pub Pair);
/// Eqs. (2), (3) without damping, with the transmission error k[1].
pub struct WithError(pub Pair);
/// Eqs. (2), (3) with backlash: k[4] is 1 in contact, k[5] is the edge of the dead band, k[6] is 1 if the damper acts, k[7] is 1 if it
/// is clipped.
pub struct WithPlay(pub Pair);
/// Eqs. (2), (3) without damping, with sliding friction: k[2] is the side of the pitch point that bears the force, k[3] its arm.
pub struct WithFriction {
    pub pair: Pair,
    pub mu: f64,
    pub mixed: f64,
    pub tangent: f64,
    /// 1/N1 - 1/N2 and 1/N1 + 1/N2.
    pub n1: f64,
    pub n2: f64,
}

impl ByHand<2> for Exact {
    fn evaluate(&self, q: &[f64; 2], q_dot: &[f64; 2], k: &[f64], dk: &[f64]) -> [f64; 2] {
        let Pair { m1, m2, c, t0 } = self.0;
        let (phi, phi_dot, square) = (q[1], q_dot[1], q[1] * q[1]);
        [
            -m1 * k[0] * phi - c * m1 * phi_dot + m1 * t0 - m2 * dk[0] * square / 2.0,
            -m2 * k[0] * phi - c * m2 * phi_dot + m2 * t0 - m1 * dk[0] * square / 2.0,
        ]
    }
}

impl ByHand<2> for Undamped {
    fn evaluate(&self, q: &[f64; 2], _: &[f64; 2], k: &[f64], dk: &[f64]) -> [f64; 2] {
        let Pair { m1, m2, t0, .. } = self.0;
        let (phi, square) = (q[1], q[1] * q[1]);
        [-m1 * k[0] * phi + m1 * t0 - m2 * dk[0] * square / 2.0, -m2 * k[0] * phi + m2 * t0 - m1 * dk[0] * square / 2.0]
    }
}

impl ByHand<2> for Rigid {
    fn evaluate(&self, q: &[f64; 2], q_dot: &[f64; 2], k: &[f64], _: &[f64]) -> [f64; 2] {
        let Pair { m1, m2, c, t0 } = self.0;
        let (phi, phi_dot) = (q[1], q_dot[1]);
        [-m1 * k[0] * phi - c * m1 * phi_dot + m1 * t0, -m2 * k[0] * phi - c * m2 * phi_dot + m2 * t0]
    }
}

impl ByHand<2> for Free {
    fn evaluate(&self, q: &[f64; 2], _: &[f64; 2], k: &[f64], _: &[f64]) -> [f64; 2] {
        let Pair { m1, m2, .. } = self.0;
        [-m1 * k[0] * q[1], -m2 * k[0] * q[1]]
    }
}

impl ByHand<2> for WithError {
    fn evaluate(&self, q: &[f64; 2], _: &[f64; 2], k: &[f64], dk: &[f64]) -> [f64; 2] {
        let Pair { m1, m2, t0, .. } = self.0;
        let delta = q[1] - k[1];
        let (elastic, jump) = (t0 - k[0] * delta, (k[0] * dk[1] - dk[0] * delta / 2.0) * delta);
        [m1 * elastic + m2 * jump, m2 * elastic + m1 * jump]
    }
}

impl ByHand<2> for WithPlay {
    fn evaluate(&self, q: &[f64; 2], q_dot: &[f64; 2], k: &[f64], dk: &[f64]) -> [f64; 2] {
        let Pair { m1, m2, c, t0 } = self.0;
        let (touch, over) = (k[4], q[1] - k[5]);
        let spring = k[0] * touch * over;
        let (elastic, jump) = (t0 - spring - spring * k[7] - c * k[6] * q_dot[1], dk[0] * touch * over * over / 2.0);
        [m1 * elastic - m2 * jump, m2 * elastic - m1 * jump]
    }
}

impl ByHand<2> for WithFriction {
    fn evaluate(&self, q: &[f64; 2], q_dot: &[f64; 2], k: &[f64], dk: &[f64]) -> [f64; 2] {
        let WithFriction { pair: Pair { m1, m2, t0, .. }, mu, mixed, tangent, n1, n2 } = *self;
        let phi = q[1];
        let rolling = n1 * q_dot[1] + n2 * q_dot[0];
        let rub = mu * k[0] * (phi * phi + 1e-24).sqrt() * rolling / (rolling * rolling + mixed * mixed).sqrt();
        let (side, arm) = (tangent * k[2] * rub, 0.5 * k[3] * rub);
        let (along, across) = (t0 - k[0] * phi - side - n1 * arm, -n2 * arm - dk[0] * phi * phi / 2.0);
        [m1 * along + m2 * across, m2 * along + m1 * across]
    }
}
