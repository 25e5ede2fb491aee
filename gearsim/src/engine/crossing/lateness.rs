//! How late a phase is at a boundary: the guess from which Newton's method starts.

use super::Side;

/// How much longer the phase took to the lower and to the upper boundary of a cell, when it last passed them, than the
/// steady part of its speed would take [s].
///
/// A motion that repeats itself meets the same delay in the same cell: the guess is then so close that the motion is
/// evaluated in full but once. It is a guess only. What is found from it is the same root, to rounding.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Lateness([f64; 2]);

impl Lateness {
    /// The guess for a phase that would take the time `steady` [s].
    #[inline]
    pub(super) fn guess(&self, side: Side, steady: f64) -> f64 {
        steady + self.0[side as usize]
    }

    /// Notes that it took the time `t` [s].
    #[inline]
    pub(super) fn note(&mut self, side: Side, steady: f64, t: f64) {
        self.0[side as usize] = t - steady;
    }
}
