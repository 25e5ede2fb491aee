//! One mode, xi'' + 2 sigma xi' + omega² xi = g, in double-double precision. The formulas are those of [`crate::engine::mode`].

use xprec::Df64;

use crate::tolerance::modes::{COMPENSATED_SERIES_SPAN, COMPENSATED_SERIES_TERM, OVERDAMPED};

/// Constants of a mode.
#[derive(Debug, Clone, Copy)]
pub struct Mode {
    /// Half the damping, sigma [1/s].
    pub sigma: Df64,
    /// Square of the undamped natural angular frequency, omega² [1/s²].
    pub omega2: Df64,
    /// The form of its motion.
    kind: Kind,
}

/// The form of a mode's motion.
#[derive(Debug, Clone, Copy)]
enum Kind {
    /// sigma = omega = 0: rigid-body motion.
    Rigid,
    /// sigma < omega, w² = omega² - sigma².
    Under { w: Df64 },
    /// sigma = omega.
    Critical,
    /// sigma > omega: decay rates slow = sigma - kappa (may be 0), fast = sigma + kappa.
    Over { kappa: Df64, slow: Df64, fast: Df64 },
}

impl Mode {
    /// The mode with damping `sigma` >= 0 [1/s] and stiffness `omega2` >= 0 [1/s²].
    pub fn new(sigma: Df64, omega2: Df64) -> Mode {
        let d = omega2 - sigma * sigma;
        let kind = if sigma.hi() == 0.0 && omega2.hi() == 0.0 {
            Kind::Rigid
        } else if d.hi() > 0.0 {
            Kind::Under { w: d.sqrt() }
        } else if d.hi() < 0.0 {
            let kappa = (-d).sqrt();
            let fast = sigma + kappa;
            Kind::Over { kappa, slow: omega2 / fast, fast }
        } else {
            Kind::Critical
        };
        Mode { sigma, omega2, kind }
    }

    /// S1 [s] and S2 [s²] after the time `t` >= 0 [s].
    pub fn response(&self, t: Df64) -> (Df64, Df64) {
        let Mode { sigma, omega2, kind } = *self;
        if let Kind::Rigid = kind {
            return (t, t * t * 0.5);
        }
        if (omega2.hi().sqrt() + 2.0 * sigma.hi()) * t.hi() < COMPENSATED_SERIES_SPAN {
            return self.series(t);
        }
        let decay = (-sigma * t).exp_m1();
        // S2 from S1 and e^{-sigma t} cos(wt) - 1, as in the plain mode.
        let by_increments = |cosine_less_one: Df64, s1: Df64| (s1, -(cosine_less_one + sigma * s1) / omega2);
        match kind {
            Kind::Rigid => unreachable!("answered above"),
            Kind::Under { w } => {
                let (h, c) = (w * t * 0.5).sin_cos();
                let e = decay + 1.0;
                by_increments(decay - h * h * e * 2.0, h * c * e * 2.0 / w)
            }
            Kind::Critical => by_increments(decay, (decay + 1.0) * t),
            Kind::Over { kappa, slow, fast } => {
                let s1 = -(-slow * t).exp() * (-kappa * t * 2.0).exp_m1() / (kappa * 2.0);
                if kappa.hi() > OVERDAMPED * sigma.hi() {
                    return (s1, (decayed(slow, t) - decayed(fast, t)) / (kappa * 2.0));
                }
                by_increments(((-slow * t).exp_m1() + (-fast * t).exp_m1()) * 0.5, s1)
            }
        }
    }

    /// Taylor series of S1 and S2. The terms follow from S1'' + 2 sigma S1' + omega² S1 = 0.
    fn series(&self, t: Df64) -> (Df64, Df64) {
        let (a, b) = (self.sigma * t * 2.0, self.omega2 * t * t);
        let (mut previous, mut term) = (Df64::from(0.0), t);
        let (mut s1, mut s2) = (t, t * t * 0.5);
        for k in 1..24 {
            let k = f64::from(k);
            let next = -(a * term * k + b * previous) / ((k + 1.0) * k);
            (previous, term) = (term, next);
            s1 += term;
            s2 += term * t / (k + 2.0);
            if term.hi().abs() + previous.hi().abs() <= COMPENSATED_SERIES_TERM * t.hi() {
                break;
            }
        }
        (s1, s2)
    }
}

/// ∫ e^{-rate s} ds over [0, t].
fn decayed(rate: Df64, t: Df64) -> Df64 {
    if rate.hi() == 0.0 { t } else { -(-rate * t).exp_m1() / rate }
}
