//! The energy that one mode dissipates: the integral of its power, in closed form.

use super::{Kind, Mode, Response, decayed};
use crate::tolerance::modes::{DECAYED, EIGENVALUES_APART, SERIES_SPAN};

impl Mode {
    /// The dissipated energy ∫ 2 sigma xi'² dt over [0, `t`], from the initial speed `v`, the initial acceleration `a` and the
    /// `response` at `t`. It is an integral of the speed, not a difference of energies, so that the energy account is an
    /// independent check.
    #[inline]
    pub fn dissipated(&self, v: f64, a: f64, t: f64, response: &Response) -> f64 {
        let Mode { sigma, omega2, per_omega2, kind, .. } = *self;
        if self.rate * t < SERIES_SPAN {
            // For short times the closed forms below cancel.
            return 2.0 * sigma * self.by_quadrature(v, a, t);
        }
        match kind {
            Kind::Under { w, per_w } if w > EIGENVALUES_APART * sigma => {
                // xi' = e^{-sigma t} (v cos wt + b sin wt). The decayed sine and cosine of wt follow from S1 and S2, those of 2
                // wt from them: x1 = e² sin 2wt and x2 = 1 - e² cos 2wt with e = e^{-sigma t}.
                let b = (a + sigma * v) * per_w;
                let (sine, lacking) = (w * response.s1, omega2 * response.s2 + sigma * response.s1);
                let (x1, x2) = (2.0 * sine * (1.0 - lacking), lacking * (2.0 - lacking) + sine * sine);
                let flat = -response.decay * (2.0 + response.decay);
                let part = sigma * per_omega2;
                let (cosines, sines) = (part * (sigma * x2 + w * x1), part * (w * x2 - sigma * x1));
                0.5 * (v * v + b * b) * flat + 0.5 * (v * v - b * b) * cosines + v * b * sines
            }
            Kind::Over { kappa, slow, fast } if kappa > EIGENVALUES_APART * sigma => {
                let p = (fast * v + a) / (2.0 * kappa);
                let q = -(slow * v + a) / (2.0 * kappa);
                let (pp, pq, qq) = (decayed(2.0 * slow, t), decayed(slow + fast, t), decayed(2.0 * fast, t));
                2.0 * sigma * (p * p * pp + 2.0 * p * q * pq + q * q * qq)
            }
            Kind::Rigid | Kind::Undamped { .. } => 0.0, // no damping
            _ => 2.0 * sigma * self.by_quadrature(v, a, t),
        }
    }

    /// ∫ xi'² dt near critical damping and for short times, where the closed forms cancel: Gauss-Legendre quadrature on panels of
    /// one decay time.
    fn by_quadrature(&self, v: f64, a: f64, t: f64) -> f64 {
        // The energy dissipated after this time is negligible.
        let t = if self.sigma > 0.0 { t.min(DECAYED / self.sigma) } else { t };
        let panels = (self.sigma * t).ceil().max(1.0);
        let width = t / panels;
        let mut sum = 0.0;
        for panel in 0..panels as usize {
            for (x, weight) in GAUSS_16 {
                for x in [-x, x] {
                    let r = self.response((panel as f64 + 0.5 * (1.0 + x)) * width);
                    let speed = v + a * r.s1 - self.omega2 * v * r.s2;
                    sum += 0.5 * width * weight * speed * speed;
                }
            }
        }
        sum
    }
}

/// Nodes and weights of the 16-point Gauss-Legendre rule on [-1, 1], positive half (Abramowitz & Stegun, Table 25.4).
pub(crate) const GAUSS_16: [(f64, f64); 8] = [
    (0.095_012_509_837_637_44, 0.189_450_610_455_068_5),
    (0.281_603_550_779_258_9, 0.182_603_415_044_923_6),
    (0.458_016_777_657_227_4, 0.169_156_519_395_002_54),
    (0.617_876_244_402_643_7, 0.149_595_988_816_576_73),
    (0.755_404_408_355_003, 0.124_628_971_255_533_87),
    (0.865_631_202_387_831_7, 0.095_158_511_682_492_78),
    (0.944_575_023_073_232_6, 0.062_253_523_938_647_89),
    (0.989_400_934_991_649_9, 0.027_152_459_411_754_095),
];
