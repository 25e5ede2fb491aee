//! Torques that are not constant: their breakpoints, and their work, by integration of their power along the dense output.

use super::Advance;
use crate::engine::mode::GAUSS_16;
use crate::methods::dense::Dense;

impl Advance<'_> {
    /// Goes on into the next pieces of the courses.
    pub(super) fn enter_course(&mut self) {
        if let Some(forcing) = &mut self.field.forcing {
            let t = forcing.next();
            self.clock.set(t);
            forcing.enter(t);
        }
        self.field.begins = self.clock.now();
        self.rate = self.field.rate(0.0, &self.y);
    }

    /// The work of each torque, as far as it is not constant, the time `to` after the step of length `h` began \[J\].
    pub(super) fn work_after(&mut self, dense: &Dense, h: f64, to: f64) -> Vec<f64> {
        let mut work = self.work.clone();
        if work.is_empty() || h <= 0.0 {
            return work;
        }
        for (node, weight) in GAUSS_16 {
            for node in [-node, node] {
                let at = 0.5 * to * (1.0 + node);
                let y = dense.at(at / h);
                let varying = self.field.forcing.as_ref().map(|f| f.power(self.field.begins + at, &y.v));
                let equations = self.field.equations;
                let k = self.field.levels(at, &y);
                for (i, work) in work.iter_mut().enumerate() {
                    let power = equations.torque_power(i, &y.q, &y.v, k);
                    *work += 0.5 * to * weight * (power + varying.as_ref().map_or(0.0, |varying| varying[i]));
                }
            }
        }
        work
    }

    /// Adds the work of a step.
    pub(super) fn work_on(&mut self, dense: &Dense, h: f64, to: f64) {
        if !self.work.is_empty() {
            self.work = self.work_after(dense, h, to);
        }
    }
}
