//! One mode of a linear cell, xi'' + 2 sigma xi' + omega² xi = g, propagated exactly.
//!
//! With S1, the response to a unit speed, and S2 = ∫ S1 dt,
//!
//! ```text
//! xi(t)  - xi(0)  = v S1 + f S2                    f = g - omega² xi(0), v = xi'(0)
//! xi'(t) - xi'(0) = (f - 2 sigma v) S1 - omega² v S2
//! ```
//!
//! This holds for every damping, because S1 and S2 are entire functions of t, sigma and omega². The formulas give increments
//! instead of values, so that a constant quantity gets no rounding error. S1 and S2 are evaluated without cancellation in one of
//! three ways: for an oscillating mode, for an aperiodic mode, and by a series for short times. At the limits between them the
//! results agree to rounding.

use crate::tolerance::modes::{CRITICAL_DAMPING, OVERDAMPED, SERIES_SPAN, SERIES_TERM};

/// Constants of a mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mode {
    /// Half the damping, sigma [1/s].
    pub sigma: f64,
    /// Square of the undamped natural angular frequency, omega² [1/s²].
    pub omega2: f64,
    /// Upper bound of its rates, omega + 2 sigma [1/s]. The series of S1 and S2 is short for rate * t << 1.
    pub rate: f64,
    /// Upper bound of S1 at any time [s]; infinite for a rigid mode.
    gain: f64,
    /// 1/omega² [s²]; infinite without stiffness.
    per_omega2: f64,
    /// Coefficients of dt², ..., dt⁶ in the series of S1(dt).
    series: [f64; 5],
    /// The form of its motion.
    kind: Kind,
}

/// The form of a mode's motion.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    /// sigma = omega = 0: rigid-body motion.
    Rigid,
    /// sigma = 0 < omega = w: the motion has no exponential.
    Undamped { w: f64 },
    /// 0 < sigma < omega, w² = omega² - sigma².
    Under { w: f64, per_w: f64 },
    /// d = omega² - sigma² is so small that its square root has few correct digits. The motion is expanded in d.
    Critical { d: f64 },
    /// sigma > omega: decay rates slow = sigma - kappa (may be 0), fast = sigma + kappa.
    Over { kappa: f64, slow: f64, fast: f64 },
}

/// S1 [s] and S2 [s²] at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Response {
    /// Response to a unit initial speed.
    pub s1: f64,
    /// Response to a unit constant force.
    pub s2: f64,
    /// e^{-sigma t} - 1 if the mode oscillates; else 0.
    pub decay: f64,
}

impl Mode {
    /// The mode with damping `sigma` >= 0 [1/s] and stiffness `omega2` >= 0 [1/s²].
    pub fn new(sigma: f64, omega2: f64) -> Mode {
        let omega = omega2.sqrt();
        let d = (omega - sigma) * (omega + sigma);
        let kind = if omega == 0.0 && sigma == 0.0 {
            Kind::Rigid
        } else if sigma == 0.0 {
            Kind::Undamped { w: omega }
        } else if d.abs() <= CRITICAL_DAMPING * omega2 {
            Kind::Critical { d }
        } else if d > 0.0 {
            Kind::Under { w: d.sqrt(), per_w: 1.0 / d.sqrt() }
        } else {
            let kappa = (-d).sqrt();
            let fast = sigma + kappa;
            Kind::Over { kappa, slow: omega2 / fast, fast }
        };
        let gain = match kind {
            Kind::Rigid => f64::INFINITY,
            Kind::Undamped { .. } | Kind::Under { .. } => 1.0 / omega,
            Kind::Critical { .. } => 1.0 / sigma,
            Kind::Over { fast, .. } => 1.0 / fast,
        };
        // The derivatives of S1 at 0 are 1, -a, a² - b, ... with a = 2 sigma, b = omega².
        let (a, b) = (2.0 * sigma, omega2);
        let (c2, c3) = (-a, a * a - b);
        let c4 = -a * c3 - b * c2;
        let c5 = -a * c4 - b * c3;
        let c6 = -a * c5 - b * c4;
        let series = [c2 / 2.0, c3 / 6.0, c4 / 24.0, c5 / 120.0, c6 / 720.0];
        Mode { sigma, omega2, rate: omega + 2.0 * sigma, gain, per_omega2: 1.0 / omega2, series, kind }
    }

    /// Whether it is a rigid-body motion: no stiffness, no damping.
    #[inline]
    pub fn is_rigid(&self) -> bool {
        matches!(self.kind, Kind::Rigid)
    }

    /// The damped angular frequency [rad/s]; 0 if the mode does not oscillate.
    pub fn damped_frequency(&self) -> f64 {
        match self.kind {
            Kind::Undamped { w } | Kind::Under { w, .. } => w,
            _ => 0.0,
        }
    }

    /// Lower bound of its decay rate \[1/s\].
    pub fn slowest(&self) -> f64 {
        match self.kind {
            Kind::Over { slow, .. } => slow,
            _ => self.sigma,
        }
    }

    /// Coefficients of dt², ..., dt⁶ in the series of S1(dt).
    pub fn series(&self) -> [f64; 5] {
        self.series
    }

    /// y'' = -2 sigma y' - omega² y: from two successive derivatives of a free motion, the next one.
    #[inline]
    pub fn next(&self, y: f64, y_dot: f64) -> f64 {
        -2.0 * self.sigma * y_dot - self.omega2 * y
    }

    /// For the speed, the acceleration, the jerk and the snap: the sum of the absolute values of the terms of each.
    pub fn sizes(&self, (v, a): (f64, f64)) -> [f64; 4] {
        let (v, a) = (v.abs(), a.abs() + 4.0 * self.sigma * v.abs());
        let jerk = 2.0 * self.sigma * a + self.omega2 * v;
        [v, a, jerk, 2.0 * self.sigma * jerk + self.omega2 * a]
    }

    /// S1 and S2 after the time `t` >= 0 [s].
    #[inline]
    pub fn response(&self, t: f64) -> Response {
        match self.kind {
            Kind::Rigid => Response { s1: t, s2: 0.5 * t * t, decay: 0.0 },
            Kind::Undamped { w } => {
                let (h, c) = (0.5 * w * t).sin_cos();
                let u = h / w;
                Response { s1: 2.0 * u * c, s2: 2.0 * u * u, decay: 0.0 }
            }
            Kind::Under { w, per_w } if self.rate * t >= SERIES_SPAN => {
                let decay = (-self.sigma * t).exp_m1();
                let (h, c) = (0.5 * w * t).sin_cos();
                let e = 2.0 * h * (1.0 + decay);
                self.by_increments(decay - h * e, c * e * per_w, decay)
            }
            _ => self.heavily_damped_or_short(t),
        }
    }

    /// S2 from S1 and e^{-sigma t} cos(wt) - 1: S2 = (1 - e^{-sigma t} C - sigma S1)/omega².
    #[inline]
    fn by_increments(&self, cosine_less_one: f64, s1: f64, decay: f64) -> Response {
        Response { s1, s2: (-cosine_less_one - self.sigma * s1) * self.per_omega2, decay }
    }

    fn heavily_damped_or_short(&self, t: f64) -> Response {
        if self.rate * t < SERIES_SPAN {
            return self.by_series(t);
        }
        match self.kind {
            Kind::Critical { d } => {
                let (decay, dt2) = ((-self.sigma * t).exp_m1(), d * t * t);
                let e = 1.0 + decay;
                Response { decay: 0.0, ..self.by_increments(decay - 0.5 * dt2 * e, e * t * (1.0 - dt2 / 6.0), 0.0) }
            }
            Kind::Over { kappa, slow, fast } => {
                let s1 = (-slow * t).exp() * -(-2.0 * kappa * t).exp_m1() / (2.0 * kappa);
                if kappa > OVERDAMPED * self.sigma {
                    return Response { s1, s2: (decayed(slow, t) - decayed(fast, t)) / (2.0 * kappa), decay: 0.0 };
                }
                self.by_increments(0.5 * ((-slow * t).exp_m1() + (-fast * t).exp_m1()), s1, 0.0)
            }
            // Reached only if `t` is NaN. The response is then NaN too.
            Kind::Rigid | Kind::Undamped { .. } | Kind::Under { .. } => self.by_series(t),
        }
    }

    /// Taylor series of S1 and S2. The terms follow from S1'' + 2 sigma S1' + omega² S1 = 0.
    fn by_series(&self, t: f64) -> Response {
        let (a, b) = (2.0 * self.sigma * t, self.omega2 * t * t);
        let (mut previous, mut term) = (0.0, t); // c_{k-1} t^{k-1}, c_k t^k
        let (mut s1, mut s2) = (t, 0.5 * t * t);
        for k in 1..24 {
            let k = f64::from(k);
            let next = -(a * k * term + b * previous) / ((k + 1.0) * k);
            (previous, term) = (term, next);
            s1 += term;
            s2 += term * t / (k + 2.0);
            if term.abs() + previous.abs() <= SERIES_TERM * t {
                break;
            }
        }
        Response { s1, s2, decay: if self.oscillates() { (-self.sigma * t).exp_m1() } else { 0.0 } }
    }

    fn oscillates(&self) -> bool {
        matches!(self.kind, Kind::Under { .. })
    }

    /// The response at t + `dt` from that at t, with |`dt`| * rate <= `tolerance::modes::SHIFT_SPAN`. It
    /// uses the series of S1(dt) and S2(dt), whose omitted terms are below rounding.
    #[inline]
    pub fn shifted(&self, at: &Response, dt: f64) -> Response {
        if self.is_rigid() {
            return self.response(at.s1 + dt);
        }
        let (a, b) = (2.0 * self.sigma, self.omega2);
        let [c2, c3, c4, c5, c6] = self.series;
        // Evaluate in pairs, which the processor computes in parallel: all that follows waits for this result.
        let dt2 = dt * dt;
        let s1 = dt * ((1.0 + dt * c2) + dt2 * ((c3 + dt * c4) + dt2 * (c5 + dt * c6)));
        let (low, middle) = (0.5 + dt * (c2 * (1.0 / 3.0)), c3 * 0.25 + dt * (c4 * 0.2));
        let s2 = dt2 * (low + dt2 * (middle + dt2 * (c5 * (1.0 / 6.0) + dt * (c6 * (1.0 / 7.0)))));
        let x = -self.sigma * dt;
        let x2 = x * x;
        let decay = x * ((1.0 + x * 0.5) + x2 * ((1.0 / 6.0 + x * (1.0 / 24.0)) + x2 * (1.0 / 120.0)));
        // S1 is a motion of unit speed: it has the speed 1 - 2 sigma S1 - omega² S2 and the force -omega² S1. S2 is a motion of
        // unit force: it has the speed S1 and the force 1 - omega² S2.
        let (speed, force) = (1.0 - a * at.s1 - b * at.s2, -b * at.s1);
        Response {
            s1: at.s1 + speed * s1 + force * s2,
            s2: at.s2 + at.s1 * s1 + (1.0 - b * at.s2) * s2,
            decay: if self.oscillates() { at.decay + (1.0 + at.decay) * decay } else { 0.0 },
        }
    }

    /// An upper bound of ∫|S1| dt over the time `span` \[s²\]: the displacement under a load that is at most 1.
    pub fn effect(&self, span: f64) -> f64 {
        let limited = (0.5 * span * span).min(self.gain * span);
        match self.kind {
            Kind::Rigid | Kind::Undamped { .. } => limited,
            Kind::Under { per_w, .. } => limited.min(per_w / self.sigma),
            // S1 >= 0, and its integral is S2.
            Kind::Critical { .. } | Kind::Over { .. } => limited.min(self.per_omega2),
        }
    }

    /// An upper bound of |y(t)| for all t >= 0, where y'' + 2 sigma y' + omega² y = 0, y(0) = `y` and y'(0) = `y_dot`. It is
    /// cheap to compute.
    #[inline]
    pub fn rough_bound(&self, y: f64, y_dot: f64) -> f64 {
        if y_dot == 0.0 { y.abs() } else { y.abs() + y_dot.abs() * self.gain }
    }

    /// The same, but tighter. It is infinite for a rigid motion that grows without bound.
    #[inline]
    pub fn bound(&self, y: f64, y_dot: f64) -> f64 {
        match self.kind {
            Kind::Undamped { w } | Kind::Under { w, .. } => {
                let b = (y_dot + self.sigma * y) / w;
                (y * y + b * b).sqrt().min(self.rough_bound(y, y_dot))
            }
            _ => self.rough_bound(y, y_dot),
        }
    }
}

/// ∫ e^{-rate s} ds over [0, t].
fn decayed(rate: f64, t: f64) -> f64 {
    if rate * t == 0.0 { t } else { -(-rate * t).exp_m1() / rate }
}

mod driven;
mod loss;
pub use driven::exp_m1;
pub(crate) use loss::GAUSS_16;
#[cfg(test)]
mod tests;
