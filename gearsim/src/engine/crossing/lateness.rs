//! The delay of a phase at a boundary. Newton's method starts from it.

use super::Side;

/// Time that the last passage of a phase to the lower and to the upper boundary of a cell took, minus the time at the steady part
/// of its speed \[s\].
///
/// A periodic motion has the same delay in the same cell. The initial guess is then so close that one full evaluation of the
/// motion is enough. It is only a guess: the root that is found is the same, to rounding.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Delay([f64; 2]);

impl Delay {
    /// The expected time of a passage that would take the time `steady` at the steady part of its speed [s].
    #[inline]
    pub(super) fn guess(&self, side: Side, steady: f64) -> f64 {
        steady + self.0[side as usize]
    }

    /// Stores that it took the time `t` [s].
    #[inline]
    pub(super) fn note(&mut self, side: Side, steady: f64, t: f64) {
        self.0[side as usize] = t - steady;
    }
}
