//! Compliance of the gear body under a tooth. The body is an elastic ring: P. Sainsot, P. Velex, O. Duverger, "Contribution of Gear
//! Body to Tooth Deflections - A New Bidimensional Analytical Formula", J. Mech. Des. 126(4), 2004, doi:10.1115/1.1758252.
//!
//! ```text
//! delta/F = cos²(a)/(E b) (L (u/S)² + M (u/S) + P (1 + Q tan²(a)))
//! ```
//!
//! - a: angle of the force to the normal of the tooth's centre line;
//! - u: distance from the root circle to the intersection of force and centre line;
//! - S = 2 r_f theta_f: thickness of the tooth at the root circle;
//! - L, M, P, Q = A/theta_f² + B h² + C h/theta_f + D/theta_f + E h + F with h = r_f/r_bore.
//!
//! The fit is for 1.4 <= h <= 7 and 0.01 <= theta_f <= 0.12. We extrapolate to theta_f = 0.2 (15 teeth): theta_f occurs only in
//! denominators, so the terms with theta_f become small.

use super::pair::GearError;

/// A to F of L, M, P and Q: Table 1 of the paper.
const TABLE: [[f64; 6]; 4] = [
    [-5.574e-5, -1.9986e-3, -2.3015e-4, 4.7702e-3, 0.0271, 6.8045],
    [60.111e-5, 28.100e-3, -83.431e-4, -9.9256e-3, 0.1624, 0.9086],
    [-50.952e-5, 185.50e-3, 0.0538e-4, 53.300e-3, 0.2895, 0.9236],
    [-6.2042e-5, 9.0889e-3, -4.0964e-4, 7.8297e-3, -0.1472, 0.6904],
];
/// Range of r_f/r_bore of the table.
const HOLLOW: std::ops::RangeInclusive<f64> = 1.4..=7.0;
/// Range of theta_f for which we use the table [rad].
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
    /// The body of a gear with the root radius `root` [m], the bore radius `bore` [m] and the half angle `foot` [rad] of a tooth
    /// at the root circle. Messages call the gear `name`.
    ///
    /// # Errors
    /// If the gear is outside the range of the table.
    pub(super) fn new(root: f64, bore: f64, foot: f64, name: &str) -> Result<Foundation, GearError> {
        let h = root / bore;
        if !HOLLOW.contains(&h) {
            let what = format!(
                "the root circle of {name} is {h:.3} times as wide as its bore: Sainsot's formula allows 1.4 to 7"
            );
            return Err(GearError::new(what, "give another bore, or use the method \"iso6336\""));
        }
        if !FOOT.contains(&foot) {
            let what =
                format!("the half angle of a tooth of {name} at the root is {foot:.4} rad: it must be 0.01 to 0.2 rad");
            return Err(GearError::new(what, "use 15 to 300 teeth, or the method \"iso6336\""));
        }
        let value = |[a, b, c, d, e, f]: [f64; 6]| a / (foot * foot) + b * h * h + c * h / foot + d / foot + e * h + f;
        Ok(Foundation { coefficients: TABLE.map(value), thickness: 2.0 * root * foot })
    }

    /// E b delta/F for a force at the angle `a` [rad] that crosses the centre line of the tooth `u` [m] above the root circle.
    pub(super) fn compliance(&self, a: f64, u: f64) -> f64 {
        let [l, m, p, q] = self.coefficients;
        let (ratio, tan) = (u / self.thickness, a.tan());
        a.cos().powi(2) * (l * ratio * ratio + m * ratio + p * (1.0 + q * tan * tan))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The paper states with Table 1 the ranges 6.82-6.94 of L, 1.08-3.29 of M, 2.56-13.47 of P and 0.141-0.62 of Q. A wrong leading
    /// digit in the table would give values far outside.
    #[test]
    fn coefficients_lie_in_the_published_ranges() {
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
    fn bodies_outside_the_range_are_refused() {
        assert!(Foundation::new(1.0, 0.9, 0.1, "gear 1").unwrap_err().what.contains("1.111 times"));
        assert!(Foundation::new(1.0, 0.5, 0.3, "gear 1").unwrap_err().what.contains("0.3000 rad"));
    }
}
