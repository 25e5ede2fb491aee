//! A linear cell in its undamped modes, with any damping between them: xi'' + G xi' + omega² xi = Xᵀ f(t).

use crate::engine::cell;
use crate::engine::equations::Equations;
use crate::engine::error::Refusal;
use crate::engine::modal::Modal;
use crate::engine::switch::Switch;
use crate::engine::vector::{Matrix, Vector};

/// One cell.
#[derive(Debug, Clone)]
pub struct LinearCell {
    /// X: q = X xi.
    pub shapes: Matrix,
    /// Xᵀ M: modal speeds from speeds.
    pub momentum: Matrix,
    /// Xᵀ K, zero for rigid modes: modal spring forces from coordinates.
    pub springs: Matrix,
    /// Xᵀ f, with the torques at the start.
    pub load: Vector,
    /// omega² of each mode \[1/s²\].
    pub omega2: Vector,
    /// G.
    pub damping: Matrix,
    /// Whether G is diagonal.
    pub by_itself: bool,
    /// Bound on the rates of its modes \[1/s\].
    pub rate: f64,
}

impl LinearCell {
    /// The cell of `equations` at the law values `k`, which include the values of the present modes of `switches`.
    ///
    /// # Errors
    /// Those of [`Modal::of`].
    pub fn new(equations: &dyn Equations, switches: &[Switch], k: &[f64]) -> Result<Self, Refusal> {
        let modal = Modal::of(&cell::matrices(equations, switches, k)?)?;
        Ok(Self::seen(&modal, &modal.shapes, &modal.momentum, &modal.springs))
    }

    /// The cell with the given modes; `shapes`, `momentum` and `springs` refer to all coordinates.
    pub fn seen(modal: &Modal, shapes: &Matrix, momentum: &Matrix, springs: &Matrix) -> Self {
        let (m, modes) = (modal.modes.len(), &modal.modes);
        let damping = match &modal.coupled {
            Some(coupled) => coupled.damping.clone(),
            None => Matrix::from_fn(m, m, |i, j| if i == j { 2.0 * modes[i].sigma } else { 0.0 }),
        };
        // The largest sum of absolute values in a row is an upper bound of the eigenvalues of a symmetric matrix.
        let strongest = damping.row_iter().map(|row| row.abs().sum()).fold(0.0, f64::max);
        let fastest = modes.iter().map(|mode| mode.omega2.sqrt()).fold(0.0, f64::max);
        LinearCell {
            shapes: shapes.clone(),
            momentum: momentum.clone(),
            springs: springs.clone(),
            load: (&modal.load).into(),
            omega2: Vector::from_fn(m, |i| modes[i].omega2),
            damping,
            by_itself: modal.coupled.is_none(),
            rate: fastest + strongest,
        }
    }
}
