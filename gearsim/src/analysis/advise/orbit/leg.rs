//! A leg: a stretch of the period without steps, with its propagators.

use nalgebra::{DMatrix, DVector};

/// The laws of one phase that step at the end of a leg.
pub(super) struct LawSteps {
    /// Index of the coordinate that is the phase.
    pub phase: usize,
    /// Its speed [unit of the phase/s].
    pub speed: f64,
    /// The value of each law after the step [SI].
    pub beyond: Vec<f64>,
}

/// A stretch of the period without steps.
pub(super) struct Leg {
    /// The value of each law [SI].
    pub levels: Vec<f64>,
    /// Propagator of the whole leg (2m x 2m).
    pub whole: DMatrix<f64>,
    /// Propagator of one substep (2m x 2m).
    pub part: DMatrix<f64>,
    /// Number of substeps.
    pub substeps: usize,
    /// Duration of a substep [s].
    pub step: f64,
    /// Static deflection z_s (m).
    pub rest: DVector<f64>,
    /// The steps at its end, one entry per phase.
    pub steps: Vec<LawSteps>,
}

impl Leg {
    /// The state at the end of the leg, from the state `y` at its start.
    pub fn cross(&self, y: &DVector<f64>) -> DVector<f64> {
        self.moved(&self.whole, y)
    }

    /// The state one substep after the state `y`.
    pub fn walk(&self, y: &DVector<f64>) -> DVector<f64> {
        self.moved(&self.part, y)
    }

    /// y_s + P (y - y_s).
    fn moved(&self, propagator: &DMatrix<f64>, y: &DVector<f64>) -> DVector<f64> {
        let m = self.rest.len();
        let mut from = y.clone();
        let mut place = from.rows_mut(0, m);
        place -= &self.rest;
        let mut to = propagator * from;
        let mut place = to.rows_mut(0, m);
        place += &self.rest;
        to
    }
}

/// The matrix A of the map y -> A y + a of a period. The impulses change only a.
pub(super) fn period(legs: &[Leg]) -> DMatrix<f64> {
    let size = 2 * legs[0].rest.len();
    legs.iter().fold(DMatrix::identity(size, size), |a, leg| &leg.whole * a)
}
