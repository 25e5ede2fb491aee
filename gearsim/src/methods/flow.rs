//! The vector that methods integrate: coordinates, speeds, and the dissipated energy.

use crate::engine::vector::Vector;

/// y = (q, q', energy lost), or its derivative by time.
#[derive(Debug, Clone, PartialEq)]
pub struct Flow {
    /// Coordinates, less whole turns (N).
    pub q: Vector,
    /// Speeds (N).
    pub v: Vector,
    /// Energy dissipated by damping \[J\]. The motion does not depend on it.
    pub lost: f64,
}

impl Flow {
    /// Zero, of n coordinates.
    pub fn zero(n: usize) -> Self {
        Flow { q: Vector::zeros(n), v: Vector::zeros(n), lost: 0.0 }
    }

    /// Adds `factor` times `other`.
    #[inline]
    pub fn add(&mut self, factor: f64, other: &Flow) {
        self.q.add_times(factor, &other.q);
        self.v.add_times(factor, &other.v);
        self.lost += other.lost * factor;
    }

    /// `self` + `factor` `other`.
    #[inline]
    pub fn plus(&self, factor: f64, other: &Flow) -> Self {
        let mut sum = self.clone();
        sum.add(factor, other);
        sum
    }

    /// Whether all its numbers are finite.
    #[inline]
    pub fn is_finite(&self) -> bool {
        self.q.iter().chain(self.v.iter()).all(|x| x.is_finite()) && self.lost.is_finite()
    }
}

/// The size by which the error of each component is divided; never zero.
#[derive(Debug, Clone)]
pub struct Scale {
    /// Scale of each coordinate (N).
    pub q: Vector,
    /// Scale of each speed (N).
    pub v: Vector,
}

impl Scale {
    /// The largest component of the motion in `flow`, each in units of its scale. The dissipated energy does not count.
    #[inline]
    pub fn norm(&self, flow: &Flow) -> f64 {
        let mut norm = 0.0f64;
        for i in 0..flow.q.len() {
            let x = (flow.q[i] / self.q[i]).abs().max((flow.v[i] / self.v[i]).abs());
            // `max` would ignore NaN.
            norm = if x > norm || x.is_nan() { x } else { norm };
        }
        norm
    }

    /// Enlarges the scale to the values in `flow`.
    #[inline]
    pub fn reach(&mut self, flow: &Flow) {
        for i in 0..flow.q.len() {
            self.q[i] = self.q[i].max(flow.q[i].abs());
            self.v[i] = self.v[i].max(flow.v[i].abs());
        }
    }
}
