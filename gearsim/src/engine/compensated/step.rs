//! The step of V between two cells at the same coordinates, in double-double precision: dV = q.dK q/2 - df.q + h.

use nalgebra::{DMatrix, DVector};
use xprec::Df64;

use crate::engine::equations::Matrices;

/// The step from one cell to another one.
#[derive(Debug, Clone)]
pub struct Step {
    /// dK (n x n).
    pub stiffness: DMatrix<Df64>,
    /// df (n): of what does not depend on the cell, nothing is left.
    pub load: DVector<Df64>,
    /// h.
    pub at_zero: Df64,
}

impl Step {
    /// From the cell `here` to the cell `beyond`.
    pub fn between(here: &Matrices<Df64>, beyond: &Matrices<Df64>) -> Self {
        Step {
            stiffness: &beyond.stiffness - &here.stiffness,
            load: &beyond.load - &here.load,
            at_zero: beyond.at_zero - here.at_zero,
        }
    }

    /// dV at the coordinates `q` \[J\].
    pub fn at(&self, q: &DVector<Df64>) -> Df64 {
        let n = q.len();
        let along = |r: usize| (0..n).fold(-self.load[r] * 2.0, |sum, c| sum + self.stiffness[(r, c)] * q[c]);
        let twice = (0..n).fold(Df64::from(0.0), |sum, r| sum + q[r] * along(r));
        twice * 0.5 + self.at_zero
    }
}
