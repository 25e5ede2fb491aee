//! The course of a stiffness within one cell of its pitch, where that is not constant.

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector};

use super::{Profile, Step};

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
    /// The cubic with these values and slopes at the ends of a cell.
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

impl Profile {
    /// The stiffness that is constant between its steps.
    pub fn stepping(steps: Vec<Step>) -> Self {
        Profile { steps, curves: vec![], origin: 0.0, pitches: 1 }
    }

    /// The stiffness that follows a curve in each cell, of a width each.
    pub fn curved(cells: Vec<(Curve, f64)>) -> Self {
        let steps = cells.iter().map(|(curve, width)| Step { value: curve.mean(*width), width: *width }).collect();
        Profile { steps, curves: cells.into_iter().map(|(curve, _)| curve).collect(), origin: 0.0, pitches: 1 }
    }

    /// The same, said to go over a number of pitches.
    pub fn over(self, pitches: u32) -> Self {
        Profile { pitches, ..self }
    }

    /// The same, its first level beginning at the phase `origin`, or whole pitches from it.
    pub fn beginning(self, origin: f64) -> Self {
        Profile { origin, ..self }
    }

    /// Whether it is constant in every cell.
    pub fn steps_only(&self) -> bool {
        self.curves.is_empty()
    }

    /// The same levels, joined by straight ramps of width `ramp`, of which the part `before` lies before the step and the rest
    /// after it; curves stay as they are. `None` if a level has no room for that.
    pub fn ramped(&self, ramp: f64, before: f64) -> Option<Self> {
        let n = self.steps.len();
        if n == 1 || !self.steps_only() {
            return Some(self.clone());
        }
        if self.steps.iter().any(|step| step.width <= ramp) {
            return None;
        }
        // The pitch begins at a step, so within a ramp: that one is cut in two.
        let after = (1.0 - before) * ramp;
        let mut cells = vec![];
        let mut add = |from: f64, to: f64, width: f64| {
            if width > 0.0 {
                cells.push((Curve::Cubic([from, (to - from) / width, 0.0, 0.0]), width));
            }
        };
        for (i, step) in self.steps.iter().enumerate() {
            let (last, next) = (self.steps[(i + n - 1) % n].value, self.steps[(i + 1) % n].value);
            if i == 0 {
                add(last + before * (step.value - last), step.value, after);
            }
            add(step.value, step.value, step.width - ramp);
            match i + 1 == n {
                false => add(step.value, next, ramp),
                true => add(step.value, step.value + before * (next - step.value), before * ramp),
            }
        }
        Some(Profile::curved(cells).beginning(self.origin).over(self.pitches))
    }

    /// The periodic cubic spline through `points` (place, value), at increasing places within one pitch of `period`: twice
    /// continuously differentiable. `None` if there are fewer than three, or they are not so.
    ///
    /// h_(i-1) m_(i-1) + 2 (h_(i-1) + h_i) m_i + h_i m_(i+1) = 6 (d_i - d_(i-1)), with the second derivatives m, the distances
    /// h and the slopes d of the chords: de Boor, A Practical Guide to Splines (1978), ch. IV.
    pub fn spline(points: &[(f64, f64)], period: f64) -> Option<Self> {
        let n = points.len();
        let (first, last) = (points.first()?.0, points.last()?.0);
        if n < 3 || first < 0.0 || last >= period || points.windows(2).any(|p| p[0].0 >= p[1].0) {
            return None;
        }
        let h = |i: usize| if i + 1 == n { points[0].0 + period - points[i].0 } else { points[i + 1].0 - points[i].0 };
        let chord = |i: usize| (points[(i + 1) % n].1 - points[i].1) / h(i);
        let mut matrix = DMatrix::<f64>::zeros(n, n);
        for i in 0..n {
            let before = (i + n - 1) % n;
            matrix[(i, i)] += 2.0 * (h(before) + h(i));
            matrix[(i, before)] += h(before);
            matrix[(i, (i + 1) % n)] += h(i);
        }
        let right = DVector::from_fn(n, |i, _| 6.0 * (chord(i) - chord((i + n - 1) % n)));
        let m = matrix.lu().solve(&right)?;
        let cubic = |i: usize| {
            let (m0, m1) = (m[i], m[(i + 1) % n]);
            [points[i].1, chord(i) - h(i) * (2.0 * m0 + m1) / 6.0, m0 / 2.0, (m1 - m0) / (6.0 * h(i))]
        };
        // The last piece goes on beyond the end of the pitch, at which it is cut.
        let cut = period - last;
        let tail = Curve::Cubic(cubic(n - 1));
        let [k, dk, ddk] = tail.at(cut);
        let mut cells = vec![];
        if first > 0.0 {
            cells.push((Curve::Cubic([k, dk, ddk / 2.0, cubic(n - 1)[3]]), first));
        }
        cells.extend((0..n - 1).map(|i| (Curve::Cubic(cubic(i)), h(i))));
        cells.push((tail, cut));
        Some(Profile::curved(cells))
    }

    /// Its least value and its greatest.
    pub fn extremes(&self) -> (f64, f64) {
        let levels = self.steps.iter().map(|step| (step.value, step.value));
        let curves = self.curves.iter().zip(&self.steps).map(|(curve, step)| curve.extremes(step.width));
        let ends: Vec<_> = if self.steps_only() { levels.collect() } else { curves.collect() };
        ends.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |m, e| (m.0.min(e.0), m.1.max(e.1)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// k and its derivatives at a phase within the pitch.
    fn at(stiffness: &Profile, s: f64) -> [f64; 3] {
        let mut begin = 0.0;
        for (curve, step) in stiffness.curves.iter().zip(&stiffness.steps) {
            if s < begin + step.width {
                return curve.at(s - begin);
            }
            begin += step.width;
        }
        stiffness.curves[stiffness.curves.len() - 1].at(stiffness.steps[stiffness.steps.len() - 1].width)
    }

    fn width(stiffness: &Profile) -> f64 {
        stiffness.steps.iter().map(|step| step.width).sum()
    }

    /// Through its points, and twice continuously differentiable: across its knots, and across the end of the pitch.
    #[test]
    fn splines_are_smooth_and_periodic() {
        let points = [(0.3, 1.0), (1.0, 3.0), (2.5, 2.0), (4.0, 2.5), (5.5, 0.5)];
        let spline = Profile::spline(&points, TAU).unwrap();
        assert!((width(&spline) - TAU).abs() < 1e-14);
        let same = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12);
        for (s, k) in points {
            assert!((at(&spline, s)[0] - k).abs() < 1e-13, "{s}");
            assert!(same(at(&spline, s - 1e-14), at(&spline, s + 1e-14)), "{s}");
        }
        assert!(same(at(&spline, 0.0), at(&spline, TAU)));
        assert_eq!(Profile::spline(&points[..2], TAU), None);
        assert_eq!(Profile::spline(&[(0.0, 1.0), (0.0, 2.0), (3.0, 1.0)], TAU), None);
    }

    /// Through n points of a cosine it errs as n⁻⁴.
    #[test]
    fn splines_converge_in_fourth_order() {
        let error = |n: usize| {
            let point = |i: usize| TAU * i as f64 / n as f64;
            let points: Vec<_> = (0..n).map(|i| (point(i), point(i).cos())).collect();
            let spline = Profile::spline(&points, TAU).unwrap();
            (0..1000)
                .map(|i| TAU * f64::from(i) / 1000.0)
                .fold(0.0f64, |m, s| m.max((at(&spline, s)[0] - s.cos()).abs()))
        };
        let order = (error(16) / error(64)).log2() / 2.0;
        assert!((order - 4.0).abs() < 0.2, "{order}");
    }

    #[test]
    fn ramps_join_levels() {
        let steps = [(1.0, 2.0), (3.0, TAU - 2.0)].map(|(value, width)| Step { value, width });
        let stepping = Profile::stepping(steps.to_vec());
        for before in [0.0, 0.5, 1.0] {
            let ramped = stepping.ramped(0.1, before).unwrap();
            assert!((width(&ramped) - TAU).abs() < 1e-14);
            // Half-way up, where the ramp about the step is half over.
            let middle = 2.0 + 0.1 * (0.5 - before);
            assert!((at(&ramped, middle)[0] - 2.0).abs() < 1e-12 && (at(&ramped, middle)[1] - 20.0).abs() < 1e-9);
            assert_eq!(ramped.extremes(), (1.0, 3.0));
            // Continuous, across the pitch too.
            let ends = ramped.curves.iter().zip(&ramped.steps).map(|(c, s)| (c.at(0.0)[0], c.at(s.width)[0]));
            let ends: Vec<_> = ends.collect();
            assert!((0..ends.len()).all(|i| (ends[i].1 - ends[(i + 1) % ends.len()].0).abs() < 1e-12), "{ends:?}");
        }
        assert_eq!(stepping.ramped(2.1, 0.5), None);
    }

    /// 2 + cos s + cos(2 s + 1), its slopes by differences, its extremes by a fine scan.
    #[test]
    fn fourier_series() {
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
