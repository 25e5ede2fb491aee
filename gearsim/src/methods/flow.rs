//! The vector that methods integrate: coordinates, speeds, and the energy that damping has taken.

use nalgebra::SVector;

/// y = (q, q', energy lost), or its derivative by time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flow<const N: usize> {
    /// Coordinates, less whole turns (N).
    pub q: SVector<f64, N>,
    /// Speeds (N).
    pub v: SVector<f64, N>,
    /// Energy lost to damping \[J\]: a quadrature beside the motion, on which nothing depends.
    pub lost: f64,
}

impl<const N: usize> Flow<N> {
    /// Nothing.
    pub fn zero() -> Self {
        Flow { q: SVector::zeros(), v: SVector::zeros(), lost: 0.0 }
    }

    /// Adds `factor` times `other`.
    #[inline]
    pub fn add(&mut self, factor: f64, other: &Flow<N>) {
        self.q += other.q * factor;
        self.v += other.v * factor;
        self.lost += other.lost * factor;
    }

    /// `self` + `factor` `other`.
    #[inline]
    pub fn plus(mut self, factor: f64, other: &Flow<N>) -> Self {
        self.add(factor, other);
        self
    }

    /// Whether all of it is finite.
    #[inline]
    pub fn is_finite(&self) -> bool {
        self.q.iter().chain(self.v.iter()).all(|x| x.is_finite()) && self.lost.is_finite()
    }
}

/// What an error of each component is measured by: never zero.
#[derive(Debug, Clone, Copy)]
pub struct Scale<const N: usize> {
    /// Of the coordinates (N).
    pub q: SVector<f64, N>,
    /// Of the speeds (N).
    pub v: SVector<f64, N>,
}

impl<const N: usize> Scale<N> {
    /// The largest component of the motion in `flow`, each in units of its scale. The quadrature has none.
    #[inline]
    pub fn norm(&self, flow: &Flow<N>) -> f64 {
        let mut norm = 0.0f64;
        for i in 0..N {
            let x = (flow.q[i] / self.q[i]).abs().max((flow.v[i] / self.v[i]).abs());
            // Not `max`, which would pass over NaN.
            norm = if x > norm || x.is_nan() { x } else { norm };
        }
        norm
    }

    /// Widens the scale to what `flow` has reached.
    #[inline]
    pub fn reach(&mut self, flow: &Flow<N>) {
        for i in 0..N {
            self.q[i] = self.q[i].max(flow.q[i].abs());
            self.v[i] = self.v[i].max(flow.v[i].abs());
        }
    }
}
