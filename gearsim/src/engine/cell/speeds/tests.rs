//! The integrals of products against Gauss-Legendre quadrature.

use super::*;
use crate::engine::mode::GAUSS_16;

/// For slow and for fast rates, upwards, downwards, and at the change from one to the other.
#[test]
fn moments_are_integrals() {
    let (panels, count) = (200, 2 * SLOW_TERMS + 4);
    let rates =
        [(0.0, 0.0), (-1e-20, 0.0), (-0.3, 0.2), (-5.0, 3.0), (0.0, 22.9), (-16.3, 16.4), (-40.0, 0.0), (-2.0, 150.0)];
    for (re, im) in rates {
        for t in [1.0, 1e-3] {
            let rate = Complex::new(re, im) / t;
            for (k, found) in Moments::of(rate, count, t).0.into_iter().enumerate() {
                let mut sum = Complex::from(0.0);
                for panel in 0..panels {
                    for (x, weight) in GAUSS_16.into_iter().flat_map(|(x, weight)| [(x, weight), (-x, weight)]) {
                        let s = t * (f64::from(panel) + 0.5 + 0.5 * x) / f64::from(panels);
                        sum += (rate * s).exp() * s.powi(k as i32) * (0.5 * weight * t / f64::from(panels));
                    }
                }
                let size = t.powi(k as i32 + 1);
                assert!((found - sum).norm() < 2e-14 * size, "moment {k} of {rate} until {t} s: {found}, not {sum}");
            }
        }
    }
}
