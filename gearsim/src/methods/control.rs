//! How long a step is: by its error (adaptive), or always the same (fixed).

use super::flow::{Flow, Scale};
use crate::engine::vector::Vector;
use crate::tolerance::methods::{LAST_STEP, SAFETY, SMALLEST_SPEED, STEP_RATIO};

/// How long steps are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Steps {
    /// So that the estimated error of each is below this part of the scale of each component.
    Adaptive(f64),
    /// This long \[s\].
    Fixed(f64),
}

/// The control of steps under way.
#[derive(Debug, Clone)]
pub struct Control {
    steps: Steps,
    /// What each component has reached.
    reached: Scale,
    /// The next step to try \[s\].
    pub h: f64,
    /// Whether the last step tried was rejected: the next one does not grow.
    rejected: bool,
}

impl Control {
    /// The control of a run from `start`. `speeds` are what its energy allows (N), `rate` the fastest of its motion \[1/s\],
    /// `exponent` that of the method, `most` the longest step \[s\].
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
        Control { steps, reached, h, rejected: false }
    }

    /// The error allowed in each component.
    pub fn allowed(&self) -> Scale {
        match self.steps {
            Steps::Adaptive(tolerance) => Scale { q: &self.reached.q * tolerance, v: &self.reached.v * tolerance },
            Steps::Fixed(_) => self.reached.clone(),
        }
    }

    /// What the coordinates within a step are known to (N); nothing tells that of steps of one length.
    pub fn slack(&self) -> Vector {
        match self.steps {
            Steps::Adaptive(_) => self.allowed().q,
            Steps::Fixed(_) => Vector::zeros(self.reached.q.len()),
        }
    }

    /// The step to try with `left` until the cell or the run must end \[s\].
    pub fn step(&self, left: f64) -> f64 {
        match self.steps {
            // A last step that is hardly longer is better than a tiny one after it.
            Steps::Adaptive(_) if self.h * LAST_STEP >= left => left,
            _ => self.h.min(left),
        }
    }

    /// Whether a step of length `h` with this error will do; the length of the next one follows.
    pub fn accepts(&mut self, h: f64, error: f64, exponent: f64) -> bool {
        if let Steps::Fixed(_) = self.steps {
            return true;
        }
        let factor = SAFETY * error.powf(-exponent);
        // Also where the error is not a number.
        let accepted = error <= 1.0;
        let [least, most] = STEP_RATIO;
        let most = if self.rejected { 1.0 } else { most };
        let factor = if factor.is_nan() { least } else { factor.clamp(least, most) };
        // A step cut short by an end says nothing against a longer one.
        self.h = if accepted && h < self.h { (h * factor).max(self.h) } else { h * factor };
        self.rejected = !accepted;
        accepted
    }

    /// Takes note of where the motion has got to.
    pub fn reach(&mut self, flow: &Flow) {
        self.reached.reach(flow);
    }
}
