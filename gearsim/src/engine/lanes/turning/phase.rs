//! A phase that is the sum of a steady motion and a single vibration, at any time.

use crate::engine::lanes::elementary::{exp_m1, sin_cos};
use crate::engine::lanes::pack::Pack;
use crate::tolerance::events::{BOUND_MARGIN, REVERSION_LIMIT, TURN_REACH, TURN_STEP};

/// The phase from the start of a flight on.
pub(super) struct Phase {
    /// d.
    pub(super) drift: f64,
    /// c.
    pub(super) part: f64,
    pub(super) sigma: f64,
    pub(super) omega2: f64,
    /// 1/omega².
    pub(super) per_omega2: f64,
    pub(super) w: f64,
    /// y' = e (v C + v_s S) and y'' = e (a C + a_s S), with e = e^{-sigma t}, C = cos wt, S = sin wt.
    pub(super) v: [f64; 2],
    pub(super) a: [f64; 2],
    /// y(0).
    pub(super) start: f64,
}

/// The phase at a time.
#[derive(Clone, Copy)]
pub(super) struct PhasePoint {
    /// The time \[s\].
    pub(super) t: f64,
    pub(super) s: f64,
    /// s'.
    pub(super) rate: f64,
    /// y'.
    pub(super) v: f64,
    /// y''.
    pub(super) a: f64,
    /// Sum of the absolute values of the terms of s. The rounding error of s is proportional to it.
    pub(super) size: f64,
    /// e^{-sigma t}.
    pub(super) decay: f64,
}

/// A step in time from a point of the phase towards a target value of s.
pub(super) struct SearchStep {
    /// Newton's step \[s\]. It does not overshoot a root from which the phase bends away.
    pub(super) newton: f64,
    /// The step to the root of the series of s \[s\], if this is close enough for the search to end there.
    pub(super) root: Option<f64>,
}

impl Phase {
    /// Whether the steady speed exceeds the largest speed of the vibration. The phase then never turns back.
    #[inline(always)]
    pub(super) fn is_monotone(&self) -> bool {
        let fastest = (self.v[0] * self.v[0] + self.v[1] * self.v[1]).sqrt();
        self.drift.abs() > self.part.abs() * fastest * (1.0 + BOUND_MARGIN)
    }

    /// The step from `place` towards the time at which the phase is `target`; `fastest` bounds the rates \[1/s\].
    #[inline(always)]
    pub(super) fn step(&self, place: &PhasePoint, target: f64, fastest: f64) -> SearchStep {
        let per_rate = 1.0 / place.rate;
        let newton = (target - place.s) * per_rate;
        let jerk = -2.0 * self.sigma * place.a - self.omega2 * place.v;
        let snap = -2.0 * self.sigma * jerk - self.omega2 * place.a;
        // As in `locate`.
        let g = self.part * newton * per_rate;
        let (a, j) = (0.5 * place.a * g, (1.0 / 6.0) * jerk * g * newton);
        let snap = (1.0 / 24.0) * snap * g * newton * newton;
        let root = newton * (1.0 - a + (2.0 * a * a - j) - (5.0 * a * (a * a - j) + snap));
        let (angle, next) = (root.abs() * fastest, a * a + j.abs());
        let lacking = (14.0 * next * next + snap.abs() * (angle + 6.0 * a.abs())) * angle;
        let converges = next < REVERSION_LIMIT * REVERSION_LIMIT && angle <= TURN_REACH && lacking <= TURN_STEP;
        SearchStep { newton, root: converges.then_some(root) }
    }

    /// The phase at a time.
    #[inline(always)]
    pub(super) fn at(&self, t: f64) -> PhasePoint {
        let (sine, cosine) = sin_cos(Pack([self.w * t]));
        self.placed(t, cosine.0[0], sine.0[0], self.a)
    }

    /// The phase at a zero of y'', where cos wt and sin wt are known.
    #[inline(always)]
    pub(super) fn bent(&self, t: f64, cosine: f64, sine: f64) -> PhasePoint {
        self.placed(t, cosine, sine, [0.0; 2])
    }

    #[inline(always)]
    fn placed(&self, t: f64, cosine: f64, sine: f64, a: [f64; 2]) -> PhasePoint {
        let e = 1.0 + exp_m1(Pack([-(self.sigma * t)])).0[0];
        let v = e * (self.v[0] * cosine + self.v[1] * sine);
        let a = e * (a[0] * cosine + a[1] * sine);
        let y = -(a + 2.0 * self.sigma * v) * self.per_omega2;
        let way = self.drift * t;
        PhasePoint {
            t,
            s: way + self.part * (y - self.start),
            rate: self.drift + self.part * v,
            v,
            a,
            size: way.abs() + self.part.abs() * (y.abs() + self.start.abs()),
            decay: e,
        }
    }
}
