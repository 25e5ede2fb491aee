//! The involute function inv(alpha) = tan(alpha) - alpha, and its inverse. Source: ISO 21771-1:2024, or any textbook.

/// tan(alpha) - alpha, of an angle [rad] in [0, pi/2).
pub fn involute(alpha: f64) -> f64 {
    // For small angles the difference loses digits by cancellation. Three terms of the series lose none.
    if alpha.abs() < 0.01 {
        let a2 = alpha * alpha;
        return alpha * a2 / 3.0 * (1.0 + a2 * (2.0 / 5.0 + a2 * (17.0 / 105.0)));
    }
    alpha.tan() - alpha
}

/// The angle in [0, pi/2) [rad] whose involute is `x`; `None` if `x` is negative or not finite.
pub fn inverse(x: f64) -> Option<f64> {
    if !(0.0..f64::INFINITY).contains(&x) {
        return None;
    }
    if x == 0.0 {
        return Some(0.0);
    }
    // With t = tan(alpha), solve t - atan(t) = x. The slope t²/(1 + t²) increases with t (convex), so Newton's method from a point
    // above the root decreases monotonically to it.
    let mut t = (3.0 * x).cbrt() + x + 1.0;
    for _ in 0..60 {
        let step = (t - t.atan() - x) * (1.0 + t * t) / (t * t);
        let next = t - step;
        if next >= t || next <= 0.0 {
            break;
        }
        t = next;
    }
    Some(t.atan())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// inv 20 deg = 0.014904384 (standard tables); the inverse returns the angle; series and formula agree where they meet.
    #[test]
    fn the_inverse_returns_the_angle() {
        assert!((involute(20f64.to_radians()) - 0.014_904_383_867).abs() < 1e-12);
        for degrees in [0.0, 0.1, 0.5, 5.0, 14.5, 20.0, 30.0, 60.0, 85.0] {
            let alpha = f64::to_radians(degrees);
            let back = inverse(involute(alpha)).unwrap();
            assert!((back - alpha).abs() < 1e-9, "{degrees}: {}", back - alpha);
        }
        let (below, above) = (involute(0.01 - 1e-9), involute(0.01 + 1e-9));
        assert!(((above - below) / (2e-9 * 0.01f64.tan().powi(2)) - 1.0).abs() < 1e-3, "{below} {above}");
        assert_eq!((inverse(-1.0), inverse(f64::NAN)), (None, None));
    }
}
