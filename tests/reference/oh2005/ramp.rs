//! Eqs. (2), (3) integrated through ramps instead of steps. For narrow ramps the motion tends to that with the jump rule.
//!
//! k(theta) rises over `eps` \[rad\] centred on each switching angle, as 10 s^3 - 15 s^4 + 6 s^5 (twice continuously
//! differentiable, so that fourth order is kept) or linearly. The method is the classical Runge-Kutta method of fourth order. Its steps
//! shrink to a fraction of the time that the ramp takes to pass, about eps/sqrt(theta'^2 + M2 |dk| phi^2).

use super::{GearPair, PITCH, State};

/// Form of the ramp that replaces a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ramp {
    /// dk/dtheta constant within the ramp
    Linear,
    /// 10 s^3 - 15 s^4 + 6 s^5
    Smooth,
}

impl Ramp {
    /// Height and slope at s, both 0..1 within the ramp.
    fn at(self, s: f64) -> (f64, f64) {
        let inside = s.clamp(0.0, 1.0);
        match self {
            Self::Linear => (inside, if s > 0.0 && s < 1.0 { 1.0 } else { 0.0 }),
            Self::Smooth => {
                let (s, rest) = (inside, 1.0 - inside);
                (s * s * s * (10.0 - s * (15.0 - 6.0 * s)), 30.0 * s * s * rest * rest)
            }
        }
    }
}

impl GearPair {
    /// Distance \[rad\] to the nearest switching angle, signed: negative below it, and the rise of k there \[N m\].
    fn nearest_step(&self, theta: f64) -> (f64, f64) {
        let local = theta - PITCH * (theta / PITCH).floor();
        let up = self.k2 - self.k1;
        let steps = [(local, -up), (local - self.width1, up), (local - PITCH, -up)];
        steps.into_iter().min_by(|a, b| a.0.abs().total_cmp(&b.0.abs())).expect("three steps")
    }

    /// k \[N m\] and dk/dtheta \[N m/rad\] with ramps of width `eps` \[rad\].
    pub fn ramped(&self, ramp: Ramp, eps: f64, theta: f64) -> (f64, f64) {
        let (distance, rise) = self.nearest_step(theta);
        let below = if rise > 0.0 { self.k1 } else { self.k2 };
        let (height, slope) = ramp.at(distance / eps + 0.5);
        (below + rise * height, rise * slope / eps)
    }

    /// The motion over \[0, `t_end`\] \[s\] with ramps of width `eps` \[rad\]. `fineness` divides every step; 1 has an error of about 1e-9.
    pub fn solve_ramp(&self, ramp: Ramp, eps: f64, from: State, t_end: f64, fineness: f64) -> State {
        let rate = |y: [f64; 4]| {
            let (k, dk) = self.ramped(ramp, eps, y[0]);
            let (phi_ddot, theta_ddot) = self.exact(k, dk, y[2], y[3]);
            [y[1], theta_ddot, y[3], phi_ddot]
        };
        let along = |y: [f64; 4], d: [f64; 4], h: f64| std::array::from_fn(|i| y[i] + h * d[i]);
        let longest = 0.02 / (self.w0() * fineness);
        let mut y = [from.theta, from.theta_dot, from.phi, from.phi_dot];
        let mut t = 0.0;
        while t < t_end {
            let (distance, rise) = self.nearest_step(y[0]);
            let beside = (distance.abs() - 0.5 * eps).max(0.0);
            let speed = (y[1] * y[1] + self.m2() * rise.abs() * y[2] * y[2]).sqrt();
            let passage = (0.5 * beside + eps / (60.0 * fineness)) / speed;
            let h = longest.min(passage).min(t_end - t);
            let a = rate(y);
            let b = rate(along(y, a, h / 2.0));
            let c = rate(along(y, b, h / 2.0));
            let d = rate(along(y, c, h));
            let mean = std::array::from_fn(|i| (a[i] + 2.0 * (b[i] + c[i]) + d[i]) / 6.0);
            y = along(y, mean, h);
            t += h;
        }
        State { theta: y[0], theta_dot: y[1], phi: y[2], phi_dot: y[3] }
    }
}
