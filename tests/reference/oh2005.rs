//! The gear pair of Oh, Grosh & Barber, written out by hand: equations, jump, closed form, six-step solver.
//!
//! theta = (q1 + q2)/2, phi = (q1 - q2)/2, q_i = N_i theta_i \[rad\]; one tooth pitch is 2 pi in theta.
//!
//! ```text
//! T = I1/(2 N1^2) (theta' + phi')^2 + I2/(2 N2^2) (theta' - phi')^2,  V = k(theta) phi^2,  D = C phi'^2
//! phi''   + M2 C phi' + M2 k phi + (M1/2) (dk/dtheta) phi^2 = M2 T0      Eq. (2)
//! theta'' + M1 C phi' + M1 k phi + (M2/2) (dk/dtheta) phi^2 = M1 T0      Eq. (3)
//! ```
//!
//! Source: Oh, Grosh & Barber, "Energy Conserving Equations of Motion for Gear Systems", J. Vib. Acoust. 127(2),
//! 2005, doi:10.1115/1.1891815. The inertias are 10^3 times the printed ones \[kg mm^2\]: with these the printed ratios N1 Omega1/wd
//! hold. The damping follows from Rayleigh's function D, so it also acts in (3). In (2) alone, as printed, it would change the total
//! momentum.

mod fast;
mod ramp;
mod solver;
#[cfg(test)]
mod tests;

pub use fast::Fast;
pub use ramp::Ramp;
pub use solver::{Event, Kind, Run};

use std::f64::consts::TAU;

/// One tooth pitch in theta \[rad\]: exactly this binary number, in every reference.
pub const PITCH: f64 = TAU;

/// Parameters of the gear pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GearPair {
    /// inertia of the driving gear I1 \[kg m^2\]
    pub i1: f64,
    /// inertia of the driven gear I2 \[kg m^2\]
    pub i2: f64,
    /// teeth of the driving gear N1
    pub n1: f64,
    /// teeth of the driven gear N2
    pub n2: f64,
    /// mesh stiffness with one tooth pair in contact \[N m\]
    pub k1: f64,
    /// mesh stiffness with two tooth pairs in contact \[N m\]
    pub k2: f64,
    /// extent of k1 in theta, from the beginning of each pitch \[rad\]; k2 has the rest
    pub width1: f64,
    /// damping factor relative to k0
    pub zeta: f64,
    /// balanced torque: T0 N1 drives, T0 N2 loads \[N m\]
    pub t0: f64,
}

/// Position and velocity of the gear pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// mean rotation theta, unwrapped \[rad\]
    pub theta: f64,
    /// its velocity \[rad/s\]
    pub theta_dot: f64,
    /// relative deflection phi \[rad\]
    pub phi: f64,
    /// its velocity \[rad/s\]
    pub phi_dot: f64,
}

/// Velocities after a step of stiffness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Jump {
    /// the step is crossed
    Transmit {
        /// theta' beyond the step \[rad/s\]
        theta_dot: f64,
        /// phi' beyond the step \[rad/s\]
        phi_dot: f64,
    },
    /// the energy does not suffice to climb the step: the motion turns back
    Reflect {
        /// theta' afterwards \[rad/s\]
        theta_dot: f64,
        /// phi' afterwards \[rad/s\]
        phi_dot: f64,
    },
}

impl GearPair {
    /// The gear set of the paper's Table 1 and Section 3, at damping `zeta` and torque `t0` \[N m\] (not in the paper).
    pub fn paper(zeta: f64, t0: f64) -> Self {
        let (i1, i2, n1, n2) = (2.89e-3, 740.2e-3, 24.0, 96.0);
        Self { i1, i2, n1, n2, k1: 1430.0, k2: 2780.0, width1: 1.73, zeta, t0 }
    }

    /// The standard start: theta = 0 where one tooth pair is in contact, phi at rest, driving gear at `rpm`.
    pub fn start(&self, rpm: f64) -> State {
        let theta_dot = self.n1 * (rpm * TAU / 60.0);
        State { theta: 0.0, theta_dot, phi: self.t0 / self.k1, phi_dot: 0.0 }
    }

    /// M1 = (N1^2/I1 - N2^2/I2)/2 \[1/(kg m^2)\]
    pub fn m1(&self) -> f64 {
        (self.n1 * self.n1 / self.i1 - self.n2 * self.n2 / self.i2) / 2.0
    }

    /// M2 = (N1^2/I1 + N2^2/I2)/2 \[1/(kg m^2)\]
    pub fn m2(&self) -> f64 {
        (self.n1 * self.n1 / self.i1 + self.n2 * self.n2 / self.i2) / 2.0
    }

    /// k0 = (k1 + k2)/2 \[N m\], Eq. (14)
    pub fn k0(&self) -> f64 {
        (self.k1 + self.k2) / 2.0
    }

    /// w0 = sqrt(M2 k0) \[rad/s\], Eq. (14)
    pub fn w0(&self) -> f64 {
        (self.m2() * self.k0()).sqrt()
    }

    /// wd = w0 sqrt(1 - zeta^2) \[rad/s\], Eq. (16)
    pub fn wd(&self) -> f64 {
        self.w0() * (1.0 - self.zeta * self.zeta).sqrt()
    }

    /// C in D = C phi'^2, from 2 zeta w0 = M2 C \[N m s\]
    pub fn c(&self) -> f64 {
        2.0 * self.zeta * self.w0() / self.m2()
    }

    /// Extent of k2 in theta \[rad\]
    pub fn width2(&self) -> f64 {
        PITCH - self.width1
    }

    /// Stiffness of a cell \[N m\]. Cells are counted through the pitches: 2 n has k1, 2 n + 1 has k2.
    pub fn k(&self, cell: i64) -> f64 {
        if cell & 1 == 0 { self.k1 } else { self.k2 }
    }

    /// Extent of a cell in theta \[rad\]
    pub fn width(&self, cell: i64) -> f64 {
        if cell & 1 == 0 { self.width1 } else { self.width2() }
    }

    /// The cell of an unwrapped angle, and the angle beyond the cell's lower end \[rad\].
    pub fn locate(&self, theta: f64) -> (i64, f64) {
        let pitch = (theta / PITCH).floor();
        // fused, hence exact up to one rounding however many pitches there are
        let remainder = (-pitch).mul_add(PITCH, theta);
        let first = 2 * pitch as i64;
        match remainder < self.width1 {
            true => (first, remainder),
            false => (first + 1, remainder - self.width1),
        }
    }

    /// The unwrapped angle \[rad\] of `local` beyond the lower end of `cell`.
    pub fn unwrap(&self, cell: i64, local: f64) -> f64 {
        let offset = if cell & 1 == 0 { local } else { self.width1 + local };
        (cell.div_euclid(2) as f64).mul_add(PITCH, offset)
    }

    /// (phi'', theta'') \[rad/s^2\] with all terms, Eqs. (2), (3). `zeta` = 0 has no damping.
    pub fn exact(&self, k: f64, dk_dtheta: f64, phi: f64, phi_dot: f64) -> (f64, f64) {
        let momentum = self.t0 - k * phi - self.c() * phi_dot;
        let step = dk_dtheta * phi * phi / 2.0;
        (self.m2() * momentum - self.m1() * step, self.m1() * momentum - self.m2() * step)
    }

    /// (phi'', theta'') \[rad/s^2\] of the rigid kinematic Newtonian form, without dk/dtheta, Eqs. (4), (5).
    pub fn newtonian(&self, k: f64, phi: f64, phi_dot: f64) -> (f64, f64) {
        self.exact(k, 0.0, phi, phi_dot)
    }

    /// phi'' \[rad/s^2\] at time `t` \[s\] of the classical form, k = k(Omega0 t), with `omega` = theta' held, Eq. (6).
    pub fn classical(&self, omega: f64, t: f64, phi: f64, phi_dot: f64) -> f64 {
        self.newtonian(self.k(self.locate(omega * t).0), phi, phi_dot).0
    }

    /// The velocities after a step `dk` = k beyond - k before \[N m\], Eqs. (9), (11).
    pub fn jump(&self, dk: f64, phi: f64, theta_dot: f64, phi_dot: f64) -> Jump {
        let ratio = self.m1() / self.m2();
        let square = theta_dot * theta_dot - self.m2() * dk * phi * phi;
        if square < 0.0 {
            // (11) with theta'+ = -theta'-: the momentum conjugate to phi is kept
            let phi_dot = phi_dot - 2.0 * ratio * theta_dot;
            return Jump::Reflect { theta_dot: -theta_dot, phi_dot };
        }
        let after = square.sqrt().copysign(theta_dot);
        // (9) as a difference of squares divided by the sum: no cancellation where the step is small
        let sum = after + theta_dot;
        let change = if sum == 0.0 { 0.0 } else { -self.m2() * dk * phi * phi / sum };
        Jump::Transmit { theta_dot: after, phi_dot: phi_dot + ratio * change }
    }

    /// The state `t` \[s\] after `from` within a cell of stiffness `k` \[N m\], underdamped, Eqs. (12), (13).
    pub fn closed_form(&self, k: f64, from: State, t: f64) -> State {
        let sigma = self.zeta * self.w0();
        let w = (self.m2() * k - sigma * sigma).sqrt();
        let (rest, ratio) = (self.t0 / k, self.m1() / self.m2());
        let (sin, cos) = (w * t).sin_cos();
        let decay = (-sigma * t).exp();
        let a = from.phi - rest;
        let phi = rest + decay * (a * cos + (from.phi_dot + sigma * a) / w * sin);
        let slope = (sigma * from.phi_dot + self.m2() * k * a) / w;
        let phi_dot = decay * (from.phi_dot * cos - slope * sin);
        // theta'' = (M1/M2) phi'' throughout the cell, integrated twice
        let theta_dot = from.theta_dot + ratio * (phi_dot - from.phi_dot);
        let drift = from.theta_dot - ratio * from.phi_dot;
        let theta = from.theta + (drift * t + ratio * (phi - from.phi));
        State { theta, theta_dot, phi, phi_dot }
    }

    /// Kinetic energy T \[J\]
    pub fn kinetic(&self, s: &State) -> f64 {
        let (v1, v2) = ((s.theta_dot + s.phi_dot) / self.n1, (s.theta_dot - s.phi_dot) / self.n2);
        (self.i1 * v1 * v1 + self.i2 * v2 * v2) / 2.0
    }

    /// Potential energy V = k phi^2 \[J\]
    pub fn potential(&self, k: f64, s: &State) -> f64 {
        k * s.phi * s.phi
    }

    /// U = T + V - 2 T0 (phi - phi0) \[J\]: constant without damping, never rising with it.
    pub fn energy(&self, k: f64, s: &State, phi0: f64) -> f64 {
        self.kinetic(s) + self.potential(k, s) - 2.0 * self.t0 * (s.phi - phi0)
    }
}
