//! A stretch of the period in which nothing steps, ready to be walked.

use nalgebra::{DMatrix, DVector};

/// Laws that step on one phase at the end of a leg.
pub(super) struct Step {
    /// Coordinate that is the phase.
    pub phase: usize,
    /// Its speed.
    pub speed: f64,
    /// The value of each law beyond.
    pub beyond: Vec<f64>,
}

pub(super) struct Leg {
    /// The value of each law.
    pub levels: Vec<f64>,
    /// Propagator of all of it.
    pub whole: DMatrix<f64>,
    /// Propagator of one substep.
    pub part: DMatrix<f64>,
    pub substeps: usize,
    /// Time of a substep [s].
    pub step: f64,
    /// z_s.
    pub rest: DVector<f64>,
    /// What steps at its end, by phases.
    pub steps: Vec<Step>,
}

impl Leg {
    /// From its start to its end.
    pub fn cross(&self, y: &DVector<f64>) -> DVector<f64> {
        self.moved(&self.whole, y)
    }

    /// On by one substep.
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

/// A of y -> A y + a over a period; the impulses enter a alone.
pub(super) fn period(legs: &[Leg]) -> DMatrix<f64> {
    let size = 2 * legs[0].rest.len();
    legs.iter().fold(DMatrix::identity(size, size), |a, leg| &leg.whole * a)
}
