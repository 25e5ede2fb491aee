//! Predictions: when the next passage of a cell will probably end.
//!
//! A wrong prediction costs time, and changes no result beyond rounding errors.

use crate::engine::lanes::Lanes;
use crate::engine::lanes::cells::Cells;
use crate::engine::lanes::flight::{Response, responses};
use crate::engine::lanes::jump::Attempt;
use crate::engine::lanes::pack::{Mask, Pack};
use crate::tolerance::events::WORTH_PREDICTING;

/// Prediction for the next passage of a cell: its duration, and the responses of the modes after this time. They are computed
/// once the cell has been passed, so that the next passage does not wait for sine, cosine and exponential.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub struct Expected<const N: usize, const L: usize> {
    /// The predicted duration of the next passage, minus the duration that it would have at the steady part of the speed [s].
    pub(super) lateness: Pack<L>,
    /// The value of this difference at the last passage [s].
    late: Pack<L>,
    /// Duration of the last passage [s]; 0 if there was none.
    pub(super) last: Pack<L>,
    /// Predicted duration of the next passage [s]. It has a negative sign if the responses are not computed.
    pub(super) t: Pack<L>,
    /// Responses of the modes after the time `t`.
    pub(super) responses: [Response<L>; N],
}

impl<const N: usize, const L: usize> Expected<N, L> {
    /// The prediction for a cell that has not been passed yet.
    pub const NOTHING: Expected<N, L> = {
        let zero = Pack([0.0; L]);
        Expected { lateness: zero, late: zero, last: zero, t: zero, responses: [Response::NONE; N] }
    };

    /// Resets the prediction of a lane.
    pub fn forget(&mut self, lane: usize) {
        *self = Self::NOTHING.or(Mask::of(|i| i == lane), self);
    }

    /// Selects the lanes of `mask` from `self`, the others from `other`.
    #[inline(always)]
    fn or(&self, mask: Mask<L>, other: &Self) -> Self {
        let mut responses = self.responses;
        for i in 0..N {
            responses[i] = responses[i].or(mask, &other.responses[i]);
        }
        Expected {
            lateness: self.lateness.or(mask, other.lateness),
            late: self.late.or(mask, other.late),
            last: self.last.or(mask, other.last),
            t: self.t.or(mask, other.t),
            responses,
        }
    }

    /// The prediction after a passage. The passage took the time `taken`. At the steady part of the speed it would have taken the time
    /// `steady`. The next duration is extrapolated linearly from the last two, and so is its difference from the steady one. If the last
    /// prediction was wrong, the next one is probably wrong too, and its responses are not computed.
    #[inline(always)]
    fn next(&self, cells: &Cells<N, L>, rigid: &[bool; N], taken: Pack<L>, steady: Pack<L>) -> Self {
        let trend = |change: Pack<L>| change.zip(0.1 * self.last, |d, most| if d.abs() < most { d } else { 0.0 });
        let late = taken - steady;
        let (lateness, t) = (late + trend(late - self.late), taken + trend(taken - self.last));
        let missed = (taken - self.t.abs()) * cells.rate;
        let near = missed.compare(missed, |missed, _| missed.abs() <= WORTH_PREDICTING);
        let responses = if near.intersects(Mask::of(|_| true)) { responses(cells, rigid, t) } else { self.responses };
        // The choice is made for each lane separately, so that its result does not depend on the other lanes.
        Expected { lateness, late, last: taken, t: t.or(near, -t), responses }
    }
}

impl<const N: usize, const L: usize> Lanes<N, L> {
    /// The prediction for the cell of each lane.
    #[inline(always)]
    pub(super) fn expected(&self, common: Option<usize>) -> Expected<N, L> {
        let mut all = self.expected[common.unwrap_or(0)];
        if common.is_none() {
            for (place, expected) in self.expected.iter().enumerate() {
                all = expected.or(Mask::of(|lane| self.at[lane] == place), &all);
            }
        }
        all
    }

    /// Predicts the next passage of the cells that the lanes of `attempt` have passed.
    #[inline(always)]
    pub(super) fn prediction(&self, attempt: &Attempt<N, L>) -> Expected<N, L> {
        let mut gathered = None;
        let cells = self.cells(attempt.common, &mut gathered);
        let expected = self.expected(attempt.common);
        expected.next(cells, &self.rigid, attempt.t, attempt.steady)
    }

    /// Stores the prediction of the lanes `sure`.
    #[inline(always)]
    pub(super) fn expect(&mut self, next: &Expected<N, L>, sure: Mask<L>, common: Option<usize>) {
        if let Some(first) = common {
            self.expected[first] = next.or(sure, &self.expected[first]);
            return;
        }
        for (place, expected) in self.expected.iter_mut().enumerate() {
            *expected = next.or(sure.and(Mask::of(|lane| self.at[lane] == place)), expected);
        }
    }
}
