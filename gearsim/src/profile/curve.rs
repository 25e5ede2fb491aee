//! The curve of a law within one cell, if the law is not constant there.

use std::f64::consts::TAU;

/// A smooth function k(x) over a cell; x is the phase relative to the beginning of the cell.
#[derive(Debug, Clone, PartialEq)]
pub enum Curve {
    /// c_0 + c_1 x + c_2 x² + c_3 x³ \[unit of the law, per unit of the phase to the power\].
    Cubic([f64; 4]),
    /// mean + sum a_n cos(2 pi n x/period + phase_n).
    Fourier {
        /// Mean \[unit of the law\].
        mean: f64,
        /// n, a_n \[unit of the law\], phase_n \[rad\].
        harmonics: Vec<(f64, f64, f64)>,
        /// Period \[unit of the phase\].
        period: f64,
    },
}

impl Curve {
    /// The cubic with these values and these slopes at the two ends of a cell of this width.
    pub fn hermite([a, b]: [f64; 2], [da, db]: [f64; 2], width: f64) -> Curve {
        let chord = (b - a) / width;
        Curve::Cubic([a, da, (3.0 * chord - 2.0 * da - db) / width, (da + db - 2.0 * chord) / (width * width)])
    }

    /// k, dk/dx, d²k/dx² at `x`.
    #[inline]
    pub fn at(&self, x: f64) -> [f64; 3] {
        match self {
            Curve::Cubic([a, b, c, d]) => {
                [a + x * (b + x * (c + x * d)), b + x * (2.0 * c + x * 3.0 * d), 2.0 * c + 6.0 * d * x]
            }
            Curve::Fourier { mean, harmonics, period } => {
                harmonics.iter().fold([*mean, 0.0, 0.0], |[k, dk, ddk], (n, a, phase)| {
                    let w = n * TAU / period;
                    let (sin, cos) = (w * x + phase).sin_cos();
                    [k + a * cos, dk - a * w * sin, ddk - a * w * w * cos]
                })
            }
        }
    }

    /// The curve times `factor`.
    pub fn times(&self, factor: f64) -> Curve {
        match self {
            Curve::Cubic(coefficients) => Curve::Cubic(coefficients.map(|c| c * factor)),
            Curve::Fourier { mean, harmonics, period } => {
                let harmonics = harmonics.iter().map(|(n, a, phase)| (*n, a * factor, *phase)).collect();
                Curve::Fourier { mean: mean * factor, harmonics, period: *period }
            }
        }
    }

    /// The highest harmonic; 0 for a cubic.
    pub fn highest_order(&self) -> f64 {
        match self {
            Curve::Cubic(_) => 0.0,
            Curve::Fourier { harmonics, .. } => harmonics.iter().fold(0.0f64, |m, h| m.max(h.0)),
        }
    }

    /// Smallest and largest value for 0 <= x <= `width`.
    pub fn extremes(&self, width: f64) -> (f64, f64) {
        // The grid has 64 intervals per wave, so that an interval has at most one extremum of any practical curve. Newton's method on dk/dx
        // = 0 finds it to rounding error.
        let grid = (64.0 * self.highest_order().max(1.0)) as usize;
        let place = |i: usize| width * i as f64 / grid as f64;
        let mut values = vec![self.at(0.0)[0], self.at(width)[0]];
        for i in 0..grid {
            let (a, b) = (place(i), place(i + 1));
            let (da, db) = (self.at(a)[1], self.at(b)[1]);
            if da * db < 0.0 {
                let mut x = a + (b - a) * da / (da - db);
                for _ in 0..4 {
                    let [_, dk, ddk] = self.at(x);
                    x = if ddk == 0.0 { x } else { (x - dk / ddk).clamp(a, b) };
                }
                values.push(self.at(x)[0]);
            } else {
                values.push(self.at(b)[0]);
            }
        }
        values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(*v), high.max(*v)))
    }

    /// Mean over 0 <= x <= `width`; for a Fourier series the mean over its period.
    pub fn mean(&self, width: f64) -> f64 {
        match self {
            Curve::Cubic([a, b, c, d]) => a + width * (b / 2.0 + width * (c / 3.0 + width * d / 4.0)),
            Curve::Fourier { mean, .. } => *mean,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 2 + cos s + cos(2 s + 1): derivatives against finite differences, extremes against a fine scan.
    #[test]
    fn a_fourier_series_has_the_right_derivatives_and_extremes() {
        let curve = Curve::Fourier { mean: 2.0, harmonics: vec![(1.0, 1.0, 0.0), (2.0, 1.0, 1.0)], period: TAU };
        let k = |s: f64| 2.0 + s.cos() + (2.0 * s + 1.0).cos();
        for s in [0.0, 1.0, 2.7, 6.0] {
            let ([v, dv, ddv], h) = (curve.at(s), 1e-4);
            let (slope, bend) = ((k(s + h) - k(s - h)) / (2.0 * h), (k(s + h) - 2.0 * k(s) + k(s - h)) / (h * h));
            assert!((v - k(s)).abs() < 1e-14 && (dv - slope).abs() < 1e-6 && (ddv - bend).abs() < 1e-6);
        }
        let scan = (0..100_000).map(|i| k(TAU * f64::from(i) / 1e5));
        let (low, high) = scan.fold((9.0f64, -9.0f64), |(low, high), v| (low.min(v), high.max(v)));
        let found = curve.extremes(TAU);
        assert!((found.0 - low).abs() < 1e-8 && (found.1 - high).abs() < 1e-8, "{found:?} {low} {high}");
    }
}
