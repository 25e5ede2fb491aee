//! One mode under a load that varies in time: a ramp, g = t, or a swing, g = e^{i W t} - 1.
//!
//! All responses are divided differences of the exponential e^{z t}: over the two eigenvalues of the mode (S1), with one or two zeros for a
//! constant and a ramp (S2, S3), with i W for a swing. They are entire functions of t, sigma, omega² and W (McCurdy, Ng & Parlett, Math.
//! Comp. 43, 1984; Higham, Functions of Matrices, 2008, ch. 10), so that rigid and critical modes, slow and fast swings and resonance have
//! no formula of their own. Their numerical evaluation has three forms, none of which divides by a small difference:
//!
//! ```text
//! R = exp[l1, l2, i W]    response to e^{i W t} from rest; its rate is S1 + i W R
//!   = a power series                                            all rates times t are small
//!   = (e^{i W t} - 1 - i W S1 + omega² S2)/P(i W)               near critical damping and for rigid motions
//!   = (exp[i W, l1] - S1)/(i W - l2)                            otherwise; l1 is the eigenvalue closer to i W
//! ```

use nalgebra::Complex;

use super::{Kind, Mode, Response};
use crate::tolerance::modes::{DRIVEN_SERIES_SPAN, EIGENVALUES_APART, SERIES_TERM};

/// Number of terms of the series, enough for [`DRIVEN_SERIES_SPAN`].
const TERMS: usize = 32;

impl Mode {
    /// S3 \[s³\]: the response to the load t from rest, after the time `t` \[s\], where the response to a constant load is `at`.
    #[inline]
    pub fn ramp(&self, t: f64, at: &Response) -> f64 {
        match self.kind {
            Kind::Rigid => t * t * t / 6.0,
            _ if self.rate * t < DRIVEN_SERIES_SPAN => self.ramp_by_series(t),
            Kind::Over { kappa, slow, fast } if kappa > EIGENVALUES_APART * self.sigma => {
                (decayed_twice(slow, t) - decayed_twice(fast, t)) / (2.0 * kappa)
            }
            _ => (t - at.s1 - 2.0 * self.sigma * at.s2) / self.omega2,
        }
    }

    /// The series of S1, integrated twice.
    fn ramp_by_series(&self, t: f64) -> f64 {
        let (a, b) = (2.0 * self.sigma * t, self.omega2 * t * t);
        let (mut previous, mut term, mut sum) = (0.0, t, t * t * t / 6.0);
        for k in 1..TERMS {
            let k = k as f64;
            (previous, term) = (term, -(a * k * term + b * previous) / ((k + 1.0) * k));
            sum += term * t * t / ((k + 2.0) * (k + 3.0));
            if term.abs() + previous.abs() <= SERIES_TERM * t {
                break;
            }
        }
        sum
    }

    /// The response to the load e^{i W t} - 1 from rest \[s²\], and its rate \[s\], after the time `t` \[s\]. `w` is W > 0 \[rad/s\], `phase` is
    /// e^{i W t} - 1, and `at` the response to a constant load.
    pub fn swing(&self, w: f64, t: f64, phase: Complex<f64>, at: &Response) -> [Complex<f64>; 2] {
        if self.rate.max(w) * t < DRIVEN_SERIES_SPAN {
            return self.swing_by_series(w, t);
        }
        let response = match self.apart() {
            Some(eigenvalues) => self.by_difference(w, t, phase, at, eigenvalues),
            None => {
                let numerator = phase + self.omega2 * at.s2 - Complex::new(0.0, w * at.s1);
                numerator / self.stiffness_at(w)
            }
        };
        [response - at.s2, Complex::new(0.0, w) * response]
    }

    /// P(i W) = omega² - W² + 2 i sigma W \[1/s²\]: the load per displacement of the steady motion e^{i W t}.
    #[inline]
    pub fn stiffness_at(&self, w: f64) -> Complex<f64> {
        let omega = self.omega2.sqrt();
        Complex::new((omega - w) * (omega + w), 2.0 * self.sigma * w)
    }

    /// The eigenvalues of the mode: that closer to i W with W > 0 first; `None` if they coincide to rounding errors.
    pub fn eigenvalues(&self) -> Option<[Complex<f64>; 2]> {
        match self.kind {
            Kind::Undamped { w } => Some([Complex::new(0.0, w), Complex::new(0.0, -w)]),
            Kind::Under { w, .. } => Some([Complex::new(-self.sigma, w), Complex::new(-self.sigma, -w)]),
            Kind::Over { slow, fast, .. } => Some([Complex::from(-slow), Complex::from(-fast)]),
            Kind::Rigid | Kind::Critical { .. } => None,
        }
    }

    /// The same; `None` if they nearly coincide.
    fn apart(&self) -> Option<[Complex<f64>; 2]> {
        self.eigenvalues().filter(|[near, far]| (near - far).norm() > 2.0 * EIGENVALUES_APART * self.sigma)
    }

    /// R from the eigenvalues l1, l2.
    fn by_difference(
        &self,
        w: f64,
        t: f64,
        phase: Complex<f64>,
        at: &Response,
        [near, far]: [Complex<f64>; 2],
    ) -> Complex<f64> {
        let own = match near.im > 0.0 {
            true => Complex::new(1.0 - self.omega2 * at.s2 - self.sigma * at.s1, near.im * at.s1),
            false => Complex::from((near.re * t).exp()),
        };
        let apart = Complex::new(0.0, w) - near;
        let between = match (apart * t).norm() < 1.0 {
            true => own * exp_m1_quotient(apart * t) * t,
            false => (phase + 1.0 - own) / apart,
        };
        (between - at.s1) / (Complex::new(0.0, w) - far)
    }

    /// The series of the response to e^{i W t} - 1 = sum over n >= 1 of (i W t)ⁿ/n!.
    fn swing_by_series(&self, w: f64, t: f64) -> [Complex<f64>; 2] {
        let (a, b, z) = (2.0 * self.sigma * t, self.omega2 * t * t, Complex::new(0.0, w * t));
        let none = Complex::from(0.0);
        // Terms e_n tⁿ, with e_0 = e_1 = 0.
        let (mut before, mut term, mut load) = (none, none, Complex::from(1.0));
        let (mut sum, mut rate) = (none, none);
        for n in 0..TERMS {
            let n = n as f64;
            let push = if n == 0.0 { none } else { load };
            let next = (push * t * t - term * (a * (n + 1.0)) - before * b) / ((n + 2.0) * (n + 1.0));
            (before, term) = (term, next);
            load *= z / (n + 1.0);
            sum += term;
            rate += term * (n + 2.0);
        }
        [sum, if t > 0.0 { rate / t } else { none }]
    }
}

/// ∫ ∫ e^{-rate s} ds ds over 0 <= s <= `t`.
fn decayed_twice(rate: f64, t: f64) -> f64 {
    let x = rate * t;
    if x < DRIVEN_SERIES_SPAN {
        // t² (1/2 - x/6 + x²/24 ...)
        let (mut term, mut sum) = (0.5, 0.5);
        for k in 3..TERMS + 3 {
            term *= -x / k as f64;
            sum += term;
        }
        return sum * t * t;
    }
    (t - super::decayed(rate, t)) / rate
}

/// e^z - 1, without cancellation.
#[inline]
pub fn exp_m1(z: Complex<f64>) -> Complex<f64> {
    let (decay, (h, c)) = (z.re.exp_m1(), (0.5 * z.im).sin_cos());
    let e = 1.0 + decay;
    Complex::new(decay - 2.0 * h * h * e, 2.0 * h * c * e)
}

/// (e^z - 1)/z.
pub fn exp_m1_quotient(z: Complex<f64>) -> Complex<f64> {
    if z == Complex::from(0.0) { Complex::from(1.0) } else { exp_m1(z) / z }
}
