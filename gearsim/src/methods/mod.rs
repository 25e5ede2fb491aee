//! Numerical integration of cells, for what has no closed form, and for comparison.
//!
//! A method carries y' = f(t, y), smooth in a cell, one step on, with an estimate of its error and a polynomial for what
//! is between: one trait, one file a method. Around them, and the same for all: `field` (the right-hand side), `control`
//! (how long a step is), `steps` (the solver that the hybrid loop of [`crate::engine`] calls), `choice` (which method runs a scene, and why).
//!
//! Our own tableaux rather than a library's: the search for events needs the coefficients of the dense output, to rule roots
//! out between the samples that a library's interpolation would give, and to land on a surface by the method itself.

pub mod choice;
pub mod control;
pub mod dense;
pub mod dop853;
pub mod dopri5;
pub mod explicit;
pub mod field;
pub mod flow;
pub mod radau;
pub mod rk4;
pub mod steps;
#[cfg(test)]
pub(crate) mod tests;

use dense::Dense;
use field::Field;
use flow::{Flow, Scale};

/// A one-step method.
pub trait Method {
    /// Its name in scenes.
    fn name(&self) -> &'static str;

    /// The error of a step of length h falls as h^(1/exponent), by its own estimate.
    fn exponent(&self) -> f64;

    /// h |lambda| beyond which it is held back by stability, not by accuracy.
    fn stability(&self) -> f64;

    /// Tries the step from `start`, where the rate is `rate`, of length `h` \[s\]. `scale` is the error allowed in each
    /// component. `None` where the step's equations have no solution that is found.
    fn attempt(&mut self, field: &mut Field<'_>, start: &Flow, rate: &Flow, h: f64, scale: &Scale) -> Option<Trial>;

    /// The motion within the step that `attempt` tried last.
    fn dense(&mut self, field: &mut Field<'_>, start: &Flow, h: f64, trial: &Trial) -> Dense;
}

/// A step that was tried.
#[derive(Debug, Clone)]
pub struct Trial {
    /// Where it ends.
    pub end: Flow,
    /// The rate there.
    pub rate: Flow,
    /// Its estimated error, in parts of what is allowed.
    pub error: f64,
    /// h |lambda| as two of its stages measure it; 0 where not measured.
    pub stiffness: f64,
}
