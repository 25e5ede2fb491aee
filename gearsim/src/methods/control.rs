//! Control of the step length: adaptive, from the estimated error, or fixed.

use super::flow::{Flow, Scale};
use crate::engine::vector::Vector;
use crate::tolerance::methods::{LAST_STEP, SAFETY, SMALLEST_SPEED, STEP_RATIO};

/// How the step length is controlled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Steps {
    /// Adaptive: the estimated error of each component is below this fraction of its scale.
    Adaptive(f64),
    /// Fixed length \[s\].
    Fixed(f64),
}

/// The step control during a run.
#[derive(Debug, Clone)]
pub struct Control {
    steps: Steps,
    /// Largest absolute value of each component so far.
    reached: Scale,
    /// The next step to try \[s\].
    pub h: f64,
    /// Whether the last attempt was rejected; the next step is then not longer.
    rejected: bool,
    /// The fastest rate of the motion \[1/s\].
    rate: f64,
}

impl Control {
    /// The control of a run from `start`. `speeds` are the largest speeds that its energy allows (N), `rate` the fastest rate of
    /// the motion \[1/s\], `exponent` that of the method, and `most` the longest step \[s\].
    pub fn new(steps: Steps, start: &Flow, speeds: &Vector, rate: f64, exponent: f64, most: f64) -> Self {
        let rate = rate.max(1.0 / most);
        let size = |v: f64| if v > 0.0 && v.is_finite() { v } else { 1.0 };
        let v = speeds.map(|speed| SMALLEST_SPEED * size(speed));
        let mut reached = Scale { q: &v * (1.0 / rate), v };
        reached.reach(start);
        let h = match steps {
            Steps::Adaptive(tolerance) => (tolerance.powf(exponent) / rate).min(most),
            Steps::Fixed(h) => h,
        };
        Control { steps, reached, h, rejected: false, rate }
    }

    /// Widens the scale of components at rest: `speeds` are the largest speeds that the energy reached so far allows (N).
    pub fn allow(&mut self, speeds: &Vector) {
        let v = speeds * SMALLEST_SPEED;
        let q = &v * (1.0 / self.rate);
        self.reached.reach(&Flow { q, v, lost: 0.0 });
    }

    /// The allowed error of each component.
    pub fn allowed(&self) -> Scale {
        match self.steps {
            Steps::Adaptive(tolerance) => Scale { q: &self.reached.q * tolerance, v: &self.reached.v * tolerance },
            Steps::Fixed(_) => self.reached.clone(),
        }
    }

    /// The error of the coordinates within a step (N); 0 for steps of fixed length, whose error is not known.
    pub fn slack(&self) -> Vector {
        match self.steps {
            Steps::Adaptive(_) => self.allowed().q,
            Steps::Fixed(_) => Vector::zeros(self.reached.q.len()),
        }
    }

    /// Length of the next attempt, if the cell or the run ends after the time `left` \[s\].
    pub fn step(&self, left: f64) -> f64 {
        match self.steps {
            // A slightly longer last step avoids a very short one after it.
            Steps::Adaptive(_) if self.h * LAST_STEP >= left => left,
            _ => self.h.min(left),
        }
    }

    /// Whether a step of length `h` with the estimated `error` is accepted. Sets the length of the next step.
    pub fn accepts(&mut self, h: f64, error: f64, exponent: f64) -> bool {
        if let Steps::Fixed(_) = self.steps {
            return true;
        }
        let factor = SAFETY * error.powf(-exponent);
        // The comparison is also false for NaN.
        let accepted = error <= 1.0;
        let [least, most] = STEP_RATIO;
        let most = if self.rejected { 1.0 } else { most };
        let factor = if factor.is_nan() { least } else { factor.clamp(least, most) };
        // A step that was shortened to reach an end does not shorten the next one.
        self.h = if accepted && h < self.h { (h * factor).max(self.h) } else { h * factor };
        self.rejected = !accepted;
        accepted
    }

    /// Updates the largest absolute values with a state of the motion.
    pub fn reach(&mut self, flow: &Flow) {
        self.reached.reach(flow);
    }
}
