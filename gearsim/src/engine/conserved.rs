//! Momentum that springs and dampers leave alone, and rounded shapes would not.
//!
//! A rigid motion z has the momentum z.M q'. A vibration has no part in it: z.M X = 0. Of a rounded X it is some roundings,
//! by which every flight would push the rotation, mostly to the same side where cells are met again and again in the same
//! way: over many events that adds up. What z.M X comes to is known in twice the digits, and taken back.

use xprec::Df64;

use crate::engine::cell::Cell;
use crate::engine::vector::{Matrix, Vector};
use crate::tolerance::modes::NO_FORCE;

/// A rigid motion in a cell.
#[derive(Debug, Clone)]
pub struct Conserved {
    /// z (N).
    pub motion: Vector,
    /// z.M X of the vibrations, over z.M z; 0 for rigid modes (N).
    pub on_gained: Vector,
    /// The same of the shapes that follow the modes' speeds, where damping couples them.
    pub on_further: Option<Vector>,
}

impl Conserved {
    /// The motion `z` in a cell with M, C, K; `None` where it meets with forces there, or numbers overflow.
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
        // Beyond what numbers can hold it is not known.
        let known = on_gained.iter().chain(on_further.iter().flat_map(|x| x.iter())).all(|x| x.is_finite());
        known.then_some(Conserved { motion: z, on_gained, on_further })
    }
}
