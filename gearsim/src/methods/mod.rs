//! Numerical integration of cells that have no closed form; also for comparison with the exact engine.
//!
//! A method advances y' = f(t, y) by one step. In a cell, f is smooth. The method gives an estimate of the error and a polynomial for the
//! motion within the step (dense output). The trait `Method` is implemented once per file. The other files are common to all methods:
//! `field` (the right-hand side), `control` (the step length), `steps` (the solver that the hybrid loop of [`crate::engine`] calls), and
//! `choice` (the method that runs a scene, and the reason).
//!
//! The tableaux are written here instead of using a library, because the search for events needs the coefficients of the dense output. From
//! these coefficients the search proves that there is no root between samples. The method can also step exactly to a boundary.

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

    /// The exponent of the step control: the error estimate of a step of length h is proportional to h^(1/exponent).
    fn exponent(&self) -> f64;

    /// Stability limit of h |lambda|. Above it, stability limits the step, not accuracy.
    fn stability(&self) -> f64;

    /// Tries a step of length `h` \[s\] from the state `start` with the derivative `rate`. `scale` is the allowed error of each component.
    /// `None` if the equations of the step cannot be solved.
    fn attempt(&mut self, field: &mut Field<'_>, start: &Flow, rate: &Flow, h: f64, scale: &Scale) -> Option<Trial>;

    /// The motion within the last step that `attempt` tried.
    fn dense(&mut self, field: &mut Field<'_>, start: &Flow, h: f64, trial: &Trial) -> Dense;
}

/// An attempted step.
#[derive(Debug, Clone)]
pub struct Trial {
    /// The state at its end.
    pub end: Flow,
    /// The derivative at its end.
    pub rate: Flow,
    /// Its estimated error, relative to the allowed error.
    pub error: f64,
    /// h |lambda|, estimated from two stages; 0 if not estimated.
    pub stiffness: f64,
}
