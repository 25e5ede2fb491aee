//! A parameter that varies and whose factors in the forces depend on the state, as those of the demand on a motor whose torque falls with
//! its speed.
//!
//! All forces are linear in the parameter p. With its value p_0 at the start and another one p_1,
//!
//! ```text
//! F(p) = F(p_0) + (p - p_0)/(p_1 - p_0) (F(p_1) - F(p_0)).
//! ```
//!
//! p_1 is the value of the time history that is farthest from p_0: the factor is at most 1, and rounding errors do not grow.

use std::fmt;
use std::sync::Arc;

use crate::engine::equations::Equations;
use crate::engine::vector::{Matrix, Vector};
use crate::scene::TimeHistory;

/// Where equations are evaluated: coordinates, speeds, law values, and their slopes.
pub type At<'a> = (&'a [f64], &'a [f64], &'a [f64], &'a [f64]);

/// The equations with p_1.
#[derive(Clone)]
pub struct Farthest {
    equations: Arc<dyn Equations>,
    /// p_1 - p_0.
    away: f64,
}

impl Farthest {
    /// p_1 of a parameter with the value `at_start` (p_0) at the start.
    pub fn value(history: &TimeHistory, at_start: f64) -> f64 {
        let (low, high) = history.bounds();
        if high - at_start >= at_start - low { high } else { low }
    }

    /// `equations` are those with p_1; `away` is p_1 - p_0.
    pub fn new(equations: Box<dyn Equations>, away: f64) -> Self {
        Farthest { equations: equations.into(), away }
    }

    /// Adds the forces of a parameter that has changed by `change` since the start; `at_start` are the forces with p_0 (N).
    pub fn add_force(&self, change: f64, (q, q_dot, k, dk): At<'_>, at_start: &Vector, force: &mut Vector) {
        force.add_times(change / self.away, &(self.equations.force(q, q_dot, k, dk) - at_start));
    }

    /// The same for the Jacobian; `ddk` are the second derivatives of the laws.
    pub fn add_jacobian(
        &self,
        change: f64,
        (q, q_dot, k, dk): At<'_>,
        ddk: &[f64],
        at_start: &[Matrix; 2],
        jacobian: &mut [Matrix; 2],
    ) {
        let there = self.equations.jacobian(q, q_dot, k, dk, ddk);
        for ((sum, there), at_start) in jacobian.iter_mut().zip(there).zip(at_start) {
            *sum += (there - at_start) * (change / self.away);
        }
    }

    /// The same for the power of torque `i` \[W\]; `equations` are those with p_0.
    pub fn power(&self, change: f64, i: usize, (q, q_dot, k, _): At<'_>, equations: &dyn Equations) -> f64 {
        let of = |e: &dyn Equations| e.torque_work(i, q_dot) + e.torque_power(i, q, q_dot, k);
        change / self.away * (of(&*self.equations) - of(equations))
    }
}

impl fmt::Debug for Farthest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Farthest").field("away", &self.away).finish_non_exhaustive()
    }
}
