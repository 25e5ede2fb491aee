//! The gap in `f64` with bounds on its rounding errors. It decides most pieces at low cost.
//!
//! The rounding errors of phase and decay give a mode an error of about 1e-16 (1 + (omega + sigma) t) of its amplitude. `ROUNDING` is
//! 200 times this 1e-16. The amplitude is bounded by |E1| <= min(t, 1/omega) and |E2| <= min(t^2/2, 2/omega2).

use super::cell::Motion;
use super::crossing::Surface;
use super::judge::Local;
use super::number::Scalar;

const ROUNDING: f64 = 2e-14;

/// A surface in `f64`.
pub(super) struct Rough {
    motions: Vec<Motion<f64>>,
    level: f64,
    sign: f64,
}

impl Rough {
    pub(super) fn new<const BITS: usize>(surface: &Surface<'_, BITS>) -> Self {
        let motions = surface.motions.iter().map(Motion::rounded).collect();
        Self { motions, level: surface.level.approx(), sign: surface.sign }
    }

    /// Binary magnitude of the terms that make up the gap.
    pub(super) fn magnitude(&self) -> i64 {
        let scale = self.motions.iter().map(|m| (m.weight * m.x).abs()).fold(self.level.abs(), f64::max);
        scale.max(f64::MIN_POSITIVE).log2().ceil() as i64
    }

    /// The largest rate \[1/s\] of the modes.
    pub(super) fn rate(&self) -> f64 {
        let each = self.motions.iter().map(|m| 2.0 * m.law.sigma + m.law.omega2.sqrt());
        each.fold(f64::MIN_POSITIVE, f64::max)
    }

    pub(super) fn local(&self, t: f64) -> Local {
        let mut gap = [self.level, 0.0, 0.0];
        let mut error = [ROUNDING * self.level.abs(), 0.0, 0.0];
        for m in &self.motions {
            let values = m.at(&t);
            let errors = errors(m, t);
            for i in 0..3 {
                gap[i] -= m.weight * values[i];
                error[i] += m.weight.abs() * errors[i];
            }
        }
        Local { gap: gap.map(|x| self.sign * x), error }
    }

    /// A bound on |gap'''| from `t` on.
    pub(super) fn third(&self, t: f64) -> f64 {
        let each = |m: &Motion<f64>| {
            let (sigma, omega2) = (m.law.sigma, m.law.omega2);
            let [_, v, a] = m.at(&t);
            let j = -2.0 * sigma * a - omega2 * v;
            let [_, e1, e2] = errors(m, t);
            let (a, j) = (a.abs() + e2, j.abs() + 2.0 * sigma * e2 + omega2 * e1);
            m.weight.abs() * (j * j + omega2 * a * a).sqrt()
        };
        self.motions.iter().map(each).sum::<f64>() * (1.0 + 1e-9)
    }

    /// Bounds of sum weight xi' over \[0, `t_max`\].
    fn speeds(&self, t_max: f64) -> (f64, f64) {
        self.motions.iter().fold((0.0, 0.0), |(low, high), m| {
            let (sigma, omega2) = (m.law.sigma, m.law.omega2);
            let (a, b) = match (omega2 > 0.0, sigma > 0.0) {
                // (xi')^2 + (omega2 xi - g)^2/omega2 never grows
                (true, _) => {
                    let most = (m.v * m.v + m.push * m.push / omega2).sqrt();
                    (-most, most)
                }
                // the speed tends monotonically to g/(2 sigma)
                (false, true) => (m.v, m.force / (2.0 * sigma)),
                (false, false) => (m.v, m.v + m.force * t_max),
            };
            let (a, b) = (m.weight * a, m.weight * b);
            let margin = 1e-12 * (a.abs() + b.abs());
            (low + a.min(b) - margin, high + a.max(b) + margin)
        })
    }

    /// Whether the gap certainly rises until `t_max`.
    pub(super) fn rises(&self, t_max: f64) -> bool {
        let (low, high) = self.speeds(t_max);
        if self.sign > 0.0 { high < 0.0 } else { low > 0.0 }
    }

    /// Whether the gap certainly falls until `t_max`.
    pub(super) fn falls(&self, t_max: f64) -> bool {
        let (low, high) = self.speeds(t_max);
        if self.sign > 0.0 { low > 0.0 } else { high < 0.0 }
    }

    /// The only crossing in (a, b\], approximately: the start of the iteration in all digits.
    pub(super) fn root(&self, a: f64, b: f64) -> f64 {
        let (mut left, mut right, mut t) = (a, b, a);
        for _ in 0..100 {
            let at = self.local(t);
            if t > a {
                if at.gap[0] > 0.0 { left = t } else { right = t }
            }
            let newton = t - at.gap[0] / at.gap[1];
            let next = if newton > left && newton < right { newton } else { 0.5 * (left + right) };
            if (next - t).abs() <= 1e-15 * next.abs() {
                return next;
            }
            t = next;
        }
        t
    }
}

/// Bounds on the errors of xi, xi', xi'' at `t`.
fn errors(m: &Motion<f64>, t: f64) -> [f64; 3] {
    let (sigma, omega2) = (m.law.sigma, m.law.omega2);
    let omega = omega2.sqrt();
    let impulse = t.min(1.0 / omega);
    let step = (0.5 * t * t).min(2.0 / omega2);
    let turns = ROUNDING * (1.0 + (omega + sigma) * t);
    // the push is a difference of two terms, whose rounding errors count
    let push = m.push.abs() + 1e-2 * (m.force.abs() + (omega2 * m.x).abs());
    let e0 = turns * (m.x.abs() + m.v.abs() * impulse + push * step);
    let e1 = turns * (m.v.abs() + push * impulse);
    [e0, e1, ROUNDING * (m.force.abs() + push) + 2.0 * sigma * e1 + omega2 * e0]
}
