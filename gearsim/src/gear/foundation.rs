//! What the body of a gear gives way under a tooth, as an elastic ring: P. Sainsot, P. Velex, O. Duverger, "Contribution of Gear
//! Body to Tooth Deflections - A New Bidimensional Analytical Formula", J. Mech. Des. 126(4), 2004, doi:10.1115/1.1758252.
//!
//! ```text
//! delta/F = cos²(a)/(E b) (L (u/S)² + M (u/S) + P (1 + Q tan²(a)))
//! ```
//!
//! a: angle of the force to the normal of the tooth's middle; u: from the root circle to where the force crosses that middle;
//! S = 2 r_f theta_f: thickness of the tooth at the root circle; L, M, P, Q: A/theta_f² + B h² + C h/theta_f + D/theta_f + E h + F,
//! h = r_f/r_bore. Fitted for 1.4 <= h <= 7, 0.01 <= theta_f <= 0.12. We go on to theta_f = 0.2, 15 teeth: theta_f is in
//! denominators only, and their terms fade.

use super::pair::GearError;

/// A ... F of L, M, P and Q, Table 1.
const TABLE: [[f64; 6]; 4] = [
    [-5.574e-5, -1.9986e-3, -2.3015e-4, 4.7702e-3, 0.0271, 6.8045],
    [60.111e-5, 28.100e-3, -83.431e-4, -9.9256e-3, 0.1624, 0.9086],
    [-50.952e-5, 185.50e-3, 0.0538e-4, 53.300e-3, 0.2895, 0.9236],
    [-6.2042e-5, 9.0889e-3, -4.0964e-4, 7.8297e-3, -0.1472, 0.6904],
];
/// r_f/r_bore for which the table is.
const HOLLOW: std::ops::RangeInclusive<f64> = 1.4..=7.0;
/// theta_f [rad] for which we take it.
const FOOT: std::ops::RangeInclusive<f64> = 0.01..=0.2;

/// The body of a gear under its teeth.
#[derive(Debug, Clone)]
pub(super) struct Foundation {
    /// L, M, P, Q.
    coefficients: [f64; 4],
    /// S [m].
    thickness: f64,
}

impl Foundation {
    /// That of a gear with the root radius `root` and the radius of its bore `bore` [m], whose teeth have half the angle
    /// `foot` [rad] at the root; `name` is what it is called.
    ///
    /// # Errors
    /// Outside the range of the table.
    pub(super) fn new(root: f64, bore: f64, foot: f64, name: &str) -> Result<Foundation, GearError> {
        let h = root / bore;
        if !HOLLOW.contains(&h) {
            let what =
                format!("the root circle of {name} is {h:.3} times as wide as its bore: Sainsot's ring has 1.4 to 7");
            return Err(GearError::new(what, "give another bore"));
        }
        if !FOOT.contains(&foot) {
            let what = format!("the teeth of {name} have half an angle of {foot:.4} rad at the root, not 0.01 to 0.2");
            return Err(GearError::new(what, "take 15 to 300 teeth, or the method \"iso6336\""));
        }
        let value = |[a, b, c, d, e, f]: [f64; 6]| a / (foot * foot) + b * h * h + c * h / foot + d / foot + e * h + f;
        Ok(Foundation { coefficients: TABLE.map(value), thickness: 2.0 * root * foot })
    }

    /// E b delta/F for a force at the angle `a` [rad] that crosses the middle of the tooth `u` [m] above the root circle.
    pub(super) fn compliance(&self, a: f64, u: f64) -> f64 {
        let [l, m, p, q] = self.coefficients;
        let (ratio, tan) = (u / self.thickness, a.tan());
        a.cos().powi(2) * (l * ratio * ratio + m * ratio + p * (1.0 + q * tan * tan))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Table 1 is quoted with the ranges 6.82-6.94 of L, 1.08-3.29 of M, 2.56-13.47 of P and 0.141-0.62 of Q. A coefficient with
    /// a wrong digit up front would leave them by far.
    #[test]
    fn coefficients_lie_in_their_ranges() {
        let ranges = [(6.82, 6.94), (1.08, 3.29), (2.56, 13.47), (0.141, 0.62)];
        let mut met = [(f64::INFINITY, f64::NEG_INFINITY); 4];
        for i in 0..=40 {
            for j in 0..=40 {
                let (h, foot) = (1.4 + 5.6 * f64::from(i) / 40.0, 0.02 + 0.1 * f64::from(j) / 40.0);
                let found = Foundation::new(h, 1.0, foot, "it").unwrap().coefficients;
                for (met, x) in met.iter_mut().zip(found) {
                    *met = (met.0.min(x), met.1.max(x));
                }
            }
        }
        for ((low, high), (from, to)) in met.into_iter().zip(ranges) {
            let slack = 0.2 * (to - from);
            assert!(low > from - slack && high < to + slack, "{low} {high} not in {from} {to}");
        }
    }

    #[test]
    fn other_bodies_are_refused() {
        assert!(Foundation::new(1.0, 0.9, 0.1, "gear 1").unwrap_err().what.contains("1.111 times"));
        assert!(Foundation::new(1.0, 0.5, 0.3, "gear 1").unwrap_err().what.contains("0.3000 rad"));
    }
}
