//! The profile of a law: its values over the phase, constant between steps or smooth between kinks.
//!
//! What a scene says of a stiffness, a transmission error or the friction of a mesh, what tooth geometry gives, and what the engine
//! follows from cell to cell.

mod curve;
#[cfg(test)]
mod tests;

use nalgebra::{DMatrix, DVector};
use xprec::Df64;

pub use curve::Curve;

/// A law, a stiffness, a transmission error or one of friction, over one pitch: constant between its steps, or smooth between its kinks.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// The levels over one pitch, in the order in which a positive phase meets them; means, where it follows curves.
    pub steps: Vec<Step>,
    /// What it follows in each cell; empty where it is constant there.
    pub curves: Vec<Curve>,
    /// Phase at which the first level begins, once a pitch [unit of the phase].
    pub origin: f64,
    /// Pitches after which it repeats itself: 1, of a transmission error also more, over which the levels then go.
    pub pitches: u32,
}

/// One level of a [`Profile`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// Value [unit of the law].
    pub value: f64,
    /// Phase over which it holds [unit of the phase]; the widths add up to the pitch, or the pitches.
    pub width: f64,
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
    pub fn with_pitches(self, pitches: u32) -> Self {
        Profile { pitches, ..self }
    }

    /// The same, its first level beginning at the phase `origin`, or whole pitches from it.
    pub fn with_origin(self, origin: f64) -> Self {
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
        Some(Profile::curved(cells).with_origin(self.origin).with_pitches(self.pitches))
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

    /// Mean of the largest and the smallest value [unit of the law].
    pub fn mid(&self) -> f64 {
        let (low, high) = self.extremes();
        (high + low) / 2.0
    }

    /// [`Profile::mid`] in double-double precision.
    pub fn exact_mid(&self) -> Df64 {
        let (low, high) = self.extremes();
        (Df64::from(high) + low) * 0.5
    }

    /// Mean over the period [unit of the law].
    pub fn mean(&self) -> f64 {
        let width: f64 = self.steps.iter().map(|step| step.width).sum();
        self.steps.iter().map(|step| step.value * step.width).sum::<f64>() / width
    }
}
