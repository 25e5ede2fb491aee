//! Correction of the momentum of rigid motions for rounding errors of the mode shapes.
//!
//! A rigid motion z has the momentum z.M q'. Springs and dampers do not change it, because a vibration does not contribute: z.M X
//! = 0. With rounded shapes X this product is a few rounding errors, so each flight changes the momentum by such an error. If the
//! same cells follow one another in the same way, the errors have the same sign and add up over many events. Therefore z.M X is
//! computed in double-double precision, and its effect is subtracted.

use xprec::Df64;

use crate::engine::cell::Cell;
use crate::engine::vector::{Matrix, Vector};
use crate::tolerance::modes::NO_FORCE;

/// A rigid motion in a cell, and the error of its momentum.
#[derive(Debug, Clone)]
pub struct Conserved {
    /// The motion z (n).
    pub motion: Vector,
    /// z.M X / (z.M z) for the vibrations; 0 for rigid modes (n).
    pub on_gained: Vector,
    /// The same for the shapes Y that multiply the modes' speeds, if damping couples the modes.
    pub on_further: Option<Vector>,
}

impl Conserved {
    /// The motion `z` in a cell with M, C, K; `None` if a spring or damper of the cell acts on it, or a number overflows.
    pub fn of(z: Vector, cell: &Cell, [m, c, k]: [&Matrix; 3]) -> Option<Self> {
        let free = |a: &Matrix| {
            let (force, sum) = (a * &z, &a.abs() * &z.abs());
            force.iter().zip(&*sum).all(|(force, sum)| force.abs() <= NO_FORCE * sum)
        };
        if !free(c) || !free(k) {
            return None;
        }
        let sum = |of: &dyn Fn(usize) -> Df64| (0..z.len()).fold(Df64::from(0.0), |sum, i| sum + of(i));
        let product = |i: usize, j: usize| Df64::from(z[i]) * Df64::from(m[(i, j)]);
        let momentum: Vec<Df64> = (0..z.len()).map(|j| sum(&|i| product(i, j))).collect();
        let along = |x: &dyn Fn(usize) -> f64| sum(&|j| momentum[j] * Df64::from(x(j)));
        let size = along(&|j| z[j]);
        let excess = |shapes: &Matrix| -> Vector {
            let of = |i: usize| (along(&|j| shapes[(j, i)]) / size).hi();
            Vector::from_fn(z.len(), |i| if cell.modes[i].is_rigid() { 0.0 } else { of(i) })
        };
        let on_further = cell.coupling.as_ref().map(|coupling| excess(&coupling.shapes));
        let on_gained = excess(&cell.shapes);
        // If the products overflow, the correction is unknown.
        let known = on_gained.iter().chain(on_further.iter().flat_map(|x| x.iter())).all(|x| x.is_finite());
        known.then_some(Conserved { motion: z, on_gained, on_further })
    }
}
