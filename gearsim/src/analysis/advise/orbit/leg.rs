//! A stretch of the period in which nothing steps, ready to be walked.

use nalgebra::{DMatrix, DVector};

pub(super) struct Leg {
    /// Propagator of all of it.
    pub whole: DMatrix<f64>,
    /// Propagator of one substep.
    pub part: DMatrix<f64>,
    pub substeps: usize,
    /// Time of a substep [s].
    pub step: f64,
    /// z_s.
    pub rest: DVector<f64>,
    /// Impulses at its end: by each phase that steps, its coordinate, speed, and the step of K.
    pub steps: Vec<(usize, f64, DMatrix<f64>)>,
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
