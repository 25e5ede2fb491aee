//! Forces that are linear while the values of laws and switches do not change.

use smallvec::SmallVec;

use crate::vector::{Matrix, Vector};

/// F = f - K q - C q' with the dissipation function q'ᵀC q'/2. Zeros of K and C are left out.
#[derive(Debug, Clone)]
pub struct LinearForces {
    rows: Vec<Row>,
    is_damped: bool,
}

/// The force along one coordinate.
#[derive(Debug, Clone)]
struct Row {
    load: f64,
    /// Coordinate j, K_ij, C_ij.
    factors: SmallVec<[(usize, f64, f64); 4]>,
}

impl LinearForces {
    /// The forces with the load f (n), the stiffness matrix K and the damping matrix C (n x n each).
    pub fn new(load: &[f64], stiffness: &Matrix, damping: &Matrix) -> LinearForces {
        let row = |i: usize| {
            let all = (0..load.len()).map(|j| (j, stiffness[(i, j)], damping[(i, j)]));
            Row { load: load[i], factors: all.filter(|(_, k, c)| *k != 0.0 || *c != 0.0).collect() }
        };
        LinearForces { rows: (0..load.len()).map(row).collect(), is_damped: damping.iter().any(|c| *c != 0.0) }
    }

    /// The forces (n).
    #[inline]
    pub fn force(&self, q: &[f64], q_dot: &[f64]) -> Vector {
        let along = |row: &Row| row.factors.iter().fold(row.load, |sum, &(j, k, c)| sum - (k * q[j] + c * q_dot[j]));
        Vector::from_fn(self.rows.len(), |i| along(&self.rows[i]))
    }

    /// The dissipation function \[W\].
    #[inline]
    pub fn dissipation(&self, q_dot: &[f64]) -> f64 {
        if !self.is_damped {
            return 0.0;
        }
        let along = |row: &Row| row.factors.iter().map(|&(j, _, c)| c * q_dot[j]).sum::<f64>();
        self.rows.iter().zip(q_dot).map(|(row, v)| v * along(row)).sum::<f64>() / 2.0
    }
}
