//! A linear cell in its undamped modes, with whatever damping between them: xi'' + G xi' + omega² xi = Xᵀ f(t).

use nalgebra::{DMatrix, SMatrix, SVector};

use crate::engine::cell;
use crate::engine::equations::Equations;
use crate::engine::error::Refusal;
use crate::engine::modal::Modal;

/// One cell.
#[derive(Debug, Clone)]
pub struct Linear<const N: usize> {
    /// X: q = X xi.
    pub shapes: SMatrix<f64, N, N>,
    /// Xᵀ M: modal speeds from speeds.
    pub momentum: SMatrix<f64, N, N>,
    /// Xᵀ K, zero for rigid modes: modal spring forces from coordinates.
    pub springs: SMatrix<f64, N, N>,
    /// Xᵀ f of the start.
    pub load: SVector<f64, N>,
    /// omega² of each mode (N).
    pub omega2: SVector<f64, N>,
    /// G.
    pub damping: SMatrix<f64, N, N>,
    /// Whether G is diagonal.
    pub by_itself: bool,
    /// Bound on the rates of its modes \[1/s\].
    pub rate: f64,
}

impl<const N: usize> Linear<N> {
    /// The cell of `equations` with law values `k`.
    ///
    /// # Errors
    /// Those of [`Modal::of`].
    pub fn new(equations: &dyn Equations<N>, k: &[f64]) -> Result<Self, Refusal> {
        let modal = Modal::of(&cell::matrices(equations, k)?)?;
        Ok(Self::seen(&modal, &modal.shapes, &modal.momentum, &modal.springs))
    }

    /// That of some modes, of which there may be less than N; `shapes` and the like are those in all coordinates.
    pub fn seen(modal: &Modal, shapes: &DMatrix<f64>, momentum: &DMatrix<f64>, springs: &DMatrix<f64>) -> Self {
        // Modes that are not there are at rest for ever.
        let entry = |a: &DMatrix<f64>, i: usize, j: usize| a.get((i, j)).copied().unwrap_or(0.0);
        let whole = |a: &DMatrix<f64>| SMatrix::<f64, N, N>::from_fn(|i, j| entry(a, i, j));
        let sigma = |i: usize| modal.modes.get(i).map_or(0.0, |mode| mode.sigma);
        let omega2 = |i: usize| modal.modes.get(i).map_or(0.0, |mode| mode.omega2);
        let damping = match &modal.coupled {
            Some(coupled) => whole(&coupled.damping),
            None => SMatrix::from_fn(|i, j| if i == j { 2.0 * sigma(i) } else { 0.0 }),
        };
        // Of a symmetric matrix, the largest sum of a row bounds the eigenvalues.
        let strongest = damping.row_iter().map(|row| row.abs().sum()).fold(0.0, f64::max);
        let fastest = (0..N).map(|i| omega2(i).sqrt()).fold(0.0, f64::max);
        Linear {
            shapes: whole(shapes),
            momentum: whole(momentum),
            springs: whole(springs),
            load: SVector::from_fn(|i, _| modal.load.get(i).copied().unwrap_or(0.0)),
            omega2: SVector::from_fn(|i, _| omega2(i)),
            damping,
            by_itself: modal.coupled.is_none(),
            rate: fastest + strongest,
        }
    }
}
