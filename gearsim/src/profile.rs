//! The profile of a law: its value over the phase, piecewise constant or piecewise smooth.
//!
//! Scenes and tooth geometry ([`crate::gear`]) produce profiles of stiffnesses, transmission errors and friction laws. The engine follows
//! them from cell to cell.

mod curve;
#[cfg(test)]
mod tests;

use nalgebra::{DMatrix, DVector};
use xprec::Df64;

use crate::tolerance::scene::SAME_STEP;

pub use curve::Curve;

/// A stiffness, a transmission error or a friction law as a periodic function of the phase. The period is divided into cells; in each
/// cell the law is constant, or follows a smooth curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// The cells of one period, in the order of increasing phase. The value of a cell with a curve is the mean of the curve.
    pub steps: Vec<Step>,
    /// The curve of each cell; empty if the law is piecewise constant.
    pub curves: Vec<Curve>,
    /// Phase at which the first cell begins, modulo the period [unit of the phase].
    pub origin: f64,
    /// Period in pitches: 1, or more for a transmission error or damaged teeth.
    pub pitches: u32,
}

/// One cell of a [`Profile`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// Value [unit of the law].
    pub value: f64,
    /// Width of the cell [unit of the phase]. The widths add up to the period.
    pub width: f64,
}

impl Profile {
    /// A piecewise constant law over one pitch, with the origin 0.
    pub fn stepping(steps: Vec<Step>) -> Self {
        Profile { steps, curves: vec![], origin: 0.0, pitches: 1 }
    }

    /// A piecewise smooth law over one pitch, with the origin 0; each cell is given by its curve and its width [unit of the phase].
    pub fn curved(cells: Vec<(Curve, f64)>) -> Self {
        let steps = cells.iter().map(|(curve, width)| Step { value: curve.mean(*width), width: *width }).collect();
        Profile { steps, curves: cells.into_iter().map(|(curve, _)| curve).collect(), origin: 0.0, pitches: 1 }
    }

    /// The same law, with its cells covering this number of pitches.
    pub fn with_pitches(self, pitches: u32) -> Self {
        Profile { pitches, ..self }
    }

    /// The same law, with its first cell beginning at the phase `origin` [unit of the phase].
    pub fn with_origin(self, origin: f64) -> Self {
        Profile { origin, ..self }
    }

    /// Whether the law is piecewise constant.
    pub fn steps_only(&self) -> bool {
        self.curves.is_empty()
    }

    /// The same law with each step replaced by a straight ramp of width `ramp` [unit of the phase]. The fraction `before` of the ramp lies
    /// before the step, the rest after it. A law with curves, or with a single level, is returned unchanged. `None` if a level is not
    /// wider than the ramp.
    pub fn ramped(&self, ramp: f64, before: f64) -> Option<Self> {
        let n = self.steps.len();
        if n == 1 || !self.steps_only() {
            return Some(self.clone());
        }
        if self.steps.iter().any(|step| step.width <= ramp) {
            return None;
        }
        // The period begins at a step, which now lies within a ramp. This ramp is cut into two cells: at the beginning and at the end of
        // the period.
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
        Some(Profile::curved(cells).with_origin(self.origin).with_pitches(self.pitches))
    }

    /// The moving average of a law of levels or cubic curves, over a window of width `window` centred at each phase [unit of the phase].
    /// Each step becomes a ramp of this width. A window of width 0 gives the law itself.
    ///
    /// With F the integral of the law, the mean is (F(s + w/2) - F(s - w/2))/w. The result has a new cell where one end of the window
    /// passes the end of a cell. In such a cell the mean is linear if the law is piecewise constant; otherwise a cubic curve approximates
    /// it.
    pub fn averaged(&self, window: f64) -> Self {
        if window <= 0.0 || (self.steps_only() && self.steps.len() == 1) {
            return self.clone();
        }
        let period: f64 = self.bounds()[self.steps.len()];
        let turns = window / period;
        if (turns - turns.round()).abs() < SAME_STEP * turns {
            // The mean over whole periods is constant.
            return Profile::stepping(vec![Step { value: self.mean(), width: period }]).with_pitches(self.pitches);
        }
        self.over_windows(window, |s, inside| self.window_mean(s, inside, window))
    }

    /// The weighted moving average of a law over a window centred at each phase: the mean of `self` divided by the mean of `weight`. `self`
    /// must be the product of the law and `weight`, with the same cells as `weight`. `window` is the width [unit of the phase].
    pub fn averaged_by(&self, weight: &Profile, window: f64) -> Self {
        self.over_windows(window, |s, inside| {
            let ([f, df], [w, dw]) = (self.window_mean(s, inside, window), weight.window_mean(s, inside, window));
            [f / w, (df - dw * f / w) / w]
        })
    }

    /// A law with the period of this one that interpolates `value`. Its cells are the smooth pieces: they begin and end where one end of
    /// the window is at the end of a cell. `value(s, inside)` returns the value and the slope at the phase s, as the limit from the piece
    /// that contains the phase `inside`. Phases count from the beginning of the first cell.
    fn over_windows(&self, window: f64, value: impl Fn(f64, f64) -> [f64; 2]) -> Self {
        let bounds = self.bounds();
        let period = bounds[self.steps.len()];
        let ends = bounds[..self.steps.len()].iter().flat_map(|b| [b - window / 2.0, b + window / 2.0]);
        let mut ends: Vec<f64> = ends.map(|s| s.rem_euclid(period)).collect();
        ends.sort_by(f64::total_cmp);
        ends.dedup_by(|b, a| *b - *a < SAME_STEP * period);
        if ends[0] + period - ends[ends.len() - 1] < SAME_STEP * period {
            ends.pop();
        }
        let piece = |i: usize| {
            let next = (i + 1) % ends.len();
            let width = ends[next] - ends[i] + if next == 0 { period } else { 0.0 };
            let inside = ends[i] + width / 2.0;
            // The last piece ends at the same number at which the first one begins, to the last bit.
            let ends_at = value(ends[next], inside - if next == 0 { period } else { 0.0 });
            let ([a, da], [b, db]) = (value(ends[i], inside), ends_at);
            match self.steps_only() {
                true => (Curve::Cubic([a, (b - a) / width, 0.0, 0.0]), width),
                false => (Curve::hermite([a, b], [da, db], width), width),
            }
        };
        Profile::curved((0..ends.len()).map(piece).collect())
            .with_origin(self.origin + ends[0])
            .with_pitches(self.pitches)
    }

    /// The phases at which the cells begin, then the end of the last cell, counted from the beginning of the first cell.
    fn bounds(&self) -> Vec<f64> {
        let ends = self.steps.iter().scan(0.0, |end, step| {
            *end += step.width;
            Some(*end)
        });
        std::iter::once(0.0).chain(ends).collect()
    }

    /// The mean over a window centred at `s`, and its slope. The slope uses the cells in which the ends of a window centred at `inside`
    /// lie. Phases count from the beginning of the first cell.
    fn window_mean(&self, s: f64, inside: f64, window: f64) -> [f64; 2] {
        let bounds = self.bounds();
        let period = bounds[self.steps.len()];
        let part = |i: usize, x: f64| match self.curves.get(i) {
            Some(curve) => curve.mean(x) * x,
            None => self.steps[i].value * x,
        };
        let integral = |s: f64| {
            let (turns, s) = (s.div_euclid(period), s.rem_euclid(period));
            let parts = (0..self.steps.len()).map(|i| part(i, (s - bounds[i]).clamp(0.0, self.steps[i].width)));
            turns * period * self.mean() + parts.sum::<f64>()
        };
        let at = |offset: f64| {
            let middle = (inside + offset).rem_euclid(period);
            let cell = bounds[1..].iter().position(|end| middle < *end).unwrap_or(self.steps.len() - 1);
            let x = middle - bounds[cell] + (s - inside);
            self.curves.get(cell).map_or(self.steps[cell].value, |curve| curve.at(x)[0])
        };
        let half = window / 2.0;
        [(integral(s + half) - integral(s - half)) / window, (at(half) - at(-half)) / window]
    }

    /// The periodic cubic spline through `points` (phase, value), twice continuously differentiable. `None` if there are fewer than three
    /// points, or their phases do not ascend strictly within 0 <= phase < `period`.
    ///
    /// The second derivatives m at the points solve h_(i-1) m_(i-1) + 2 (h_(i-1) + h_i) m_i + h_i m_(i+1) = 6 (d_i - d_(i-1)), with the
    /// distances h and the slopes d of the chords. Source: de Boor, A Practical Guide to Splines (1978), ch. IV.
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
        // The last piece extends beyond the end of the period. It is cut there, and the remaining part becomes the first cell.
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

    /// Smallest and largest value [unit of the law].
    pub fn extremes(&self) -> (f64, f64) {
        let levels = self.steps.iter().map(|step| (step.value, step.value));
        let curves = self.curves.iter().zip(&self.steps).map(|(curve, step)| curve.extremes(step.width));
        let ends: Vec<_> = if self.steps_only() { levels.collect() } else { curves.collect() };
        ends.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |m, e| (m.0.min(e.0), m.1.max(e.1)))
    }

    /// Mean of the largest and the smallest value [unit of the law].
    pub fn mid(&self) -> f64 {
        let (low, high) = self.extremes();
        (high + low) / 2.0
    }

    /// [`Profile::mid`] in double-double precision.
    pub(crate) fn exact_mid(&self) -> Df64 {
        let (low, high) = self.extremes();
        (Df64::from(high) + low) * 0.5
    }

    /// Mean over the period [unit of the law].
    pub fn mean(&self) -> f64 {
        let width: f64 = self.steps.iter().map(|step| step.width).sum();
        self.steps.iter().map(|step| step.value * step.width).sum::<f64>() / width
    }
}
