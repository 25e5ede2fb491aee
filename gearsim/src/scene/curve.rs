//! The course of a stiffness within one cell of its pitch, where that is not constant.

use std::f64::consts::TAU;

use super::{Step, Stiffness};

/// k(x), smooth over a cell; x is the phase from where the cell begins.
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
        /// One pitch \[unit of the phase\].
        period: f64,
    },
}

impl Curve {
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

    /// Where between 0 and `width` it is least and greatest, and how much it is there.
    pub fn extremes(&self, width: f64) -> (f64, f64) {
        // Between two neighbours of this grid there is at most one turn of a curve that anyone draws; Newton's method
        // on dk/dx = 0 gets the turn to rounding.
        let order = match self {
            Curve::Cubic(_) => 1.0,
            Curve::Fourier { harmonics, .. } => harmonics.iter().fold(1.0f64, |m, h| m.max(h.0)),
        };
        let grid = (64.0 * order) as usize;
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

    /// Mean over 0 to `width`.
    pub fn mean(&self, width: f64) -> f64 {
        match self {
            Curve::Cubic([a, b, c, d]) => a + width * (b / 2.0 + width * (c / 3.0 + width * d / 4.0)),
            Curve::Fourier { mean, .. } => *mean,
        }
    }
}

impl Stiffness {
    /// The stiffness that is constant between its steps.
    pub fn stepping(steps: Vec<Step>) -> Self {
        Stiffness { steps, curves: vec![] }
    }

    /// The stiffness that follows a curve in each cell, of a width each.
    pub fn curved(cells: Vec<(Curve, f64)>) -> Self {
        let steps = cells.iter().map(|(curve, width)| Step { value: curve.mean(*width), width: *width }).collect();
        Stiffness { steps, curves: cells.into_iter().map(|(curve, _)| curve).collect() }
    }

    /// Whether it is constant in every cell.
    pub fn steps_only(&self) -> bool {
        self.curves.is_empty()
    }

    /// The same levels, joined by straight ramps of width `ramp` in the middle of which the steps were. `None` if a level
    /// is not wider than that.
    pub fn ramped(&self, ramp: f64) -> Option<Self> {
        let n = self.steps.len();
        if n < 2 || self.steps.iter().any(|step| step.width <= ramp) {
            return (n == 1).then(|| self.clone());
        }
        // The pitch begins at a step, so in the middle of a ramp: that one is cut in two.
        let mut cells = vec![];
        for (i, step) in self.steps.iter().enumerate() {
            let (before, after) = (self.steps[(i + n - 1) % n].value, self.steps[(i + 1) % n].value);
            let slope = |from: f64, to: f64| (to - from) / ramp;
            let half = |from: f64, to: f64| 0.5 * (from + to);
            let cubic = |a: f64, b: f64| Curve::Cubic([a, b, 0.0, 0.0]);
            if i == 0 {
                cells.push((cubic(half(before, step.value), slope(before, step.value)), 0.5 * ramp));
            }
            cells.push((cubic(step.value, 0.0), step.width - ramp));
            let width = if i + 1 == n { 0.5 * ramp } else { ramp };
            cells.push((cubic(step.value, slope(step.value, after)), width));
        }
        Some(Stiffness::curved(cells))
    }
}
