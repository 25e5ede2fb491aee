//! The kernel of plain events: L simulations pass one step of a stiffness at once.
//!
//! An event is plain under these conditions. The phase is certainly monotone, or contains a single vibration ([`turning`]). Newton's method
//! converges. The step lies before the end of the run. The motion passes the step, or is reflected without being pressed against it. A lane
//! whose event is not plain is not changed; the general loop ([`simulate`]) handles its event.
//!
//! The kernel is compiled for a few numbers of coordinates N, for L = 8 ([`ensemble`](crate::ensemble)) and for L = 1
//! ([`alone`]). If a simulation has fewer coordinates, the last ones stay at rest.
//!
//! [`simulate`]: crate::engine::simulate

#![allow(
    clippy::needless_range_loop,
    clippy::manual_range_contains,
    reason = "loops over indices and plain comparisons become vector instructions; iterators and calls may not"
)]

pub mod alone;
mod cells;
mod elementary;
mod expected;
mod flight;
mod handover;
mod jump;
pub mod kind;
mod locate;
pub mod pack;
mod turning;
pub mod vectors;

use cells::Cells;
use expected::Expected;
use flight::Flight;
use jump::{Attempt, Located};
use pack::{Mask, Pack, two_sum};

/// Largest number of coordinates in lanes. The state of more does not fit into the registers, so the gain is small, and the code
/// takes long to compile.
pub const LARGEST: usize = 6;

/// The state of L simulations, in arrays. They are aligned like the vectors of the processor.
#[repr(align(64))]
pub struct Lanes<const N: usize, const L: usize> {
    /// The cells of one pitch, in their order.
    pub tables: Vec<Cells<N, L>>,
    /// Whether each mode is rigid, in every lane.
    pub rigid: [bool; N],
    /// Index of the coordinate that is the phase.
    pub phase: usize,
    /// G of the steps; zero for steps without impulse.
    pub compliance: Pack<L>,
    /// M⁻¹n / G (N).
    pub direction: [Pack<L>; N],

    /// Coordinates without their whole pitches (N).
    pub q: [Pack<L>; N],
    /// Speeds (N).
    pub q_dot: [Pack<L>; N],
    /// Rounding errors of the speeds, to be added to them (N).
    pub lost: [Pack<L>; N],
    /// Time as the sum of two numbers [s].
    pub clock: [Pack<L>; 2],
    /// End of the run [s].
    pub end: Pack<L>,
    /// Dissipated energy [J].
    pub dissipated: Pack<L>,
    /// Index of the cell of each lane.
    pub at: [usize; L],
    /// Whole pitches since the lane was loaded.
    pub turns: [i64; L],
    /// Whether a law has a period of several turns.
    pub long: bool,
    /// Number of cell changes since the lane was loaded, and of reflections.
    pub changes: [u64; L],
    pub reflections: [u64; L],
    /// Prediction for the next passage of each cell.
    pub expected: Vec<Expected<N, L>>,
}

impl<const N: usize, const L: usize> Lanes<N, L> {
    /// Passes one event in the `active` lanes whose event is plain; returns these lanes.
    #[inline(always)]
    pub fn pass(&mut self, active: Mask<L>) -> Mask<L> {
        let attempt = self.attempt(active);
        self.take(&attempt);
        attempt.sure
    }

    /// The next event of the `active` lanes.
    #[inline(always)]
    pub fn attempt(&self, active: Mask<L>) -> Attempt<N, L> {
        let first = (0..L).find(|lane| active.is_set(*lane)).map_or(0, |lane| self.at[lane]);
        let together = (0..L).all(|lane| !active.is_set(lane) || self.at[lane] == first);
        let common = together.then_some(first);
        let mut gathered = None;
        let cells = self.cells(common, &mut gathered);
        let expected = self.expected(common);
        // Solve.
        let flight = Flight::new(cells, &self.q, &self.q_dot);
        // Locate.
        let mut target = self.target(cells, &flight);
        let unsure = active.without(target.certain);
        if unsure.intersects(active) {
            self.turn(cells, &flight, &mut target, unsure);
        }
        let sure = active.and(target.certain);
        let (sure, t, points, evaluations) = self.locate(cells, &flight, &target, &expected, sure);
        // Jump.
        self.jump(cells, &flight, &target, &points, Located { sure, t, evaluations, common })
    }

    /// The cell of each lane: the `common` cell of all lanes, or, if there is none, gathered from the tables.
    #[inline(always)]
    fn cells<'a>(&'a self, common: Option<usize>, gathered: &'a mut Option<Cells<N, L>>) -> &'a Cells<N, L> {
        match common {
            Some(first) => &self.tables[first],
            None => gathered.insert(Cells::gather(&self.tables, &self.at)),
        }
    }

    /// Stores the events of an attempt in the lanes in which they are plain.
    #[inline(always)]
    pub fn take(&mut self, attempt: &Attempt<N, L>) {
        // Almost always the events of all lanes are plain. The branch lets the next flight start without waiting for the mask.
        let all = Mask::of(|_| true);
        let predicted = attempt.sure.without(attempt.found);
        if attempt.sure.is_all() && predicted.is_all() {
            let next = self.prediction(attempt);
            self.keep(attempt, all);
            self.expect(&next, all, attempt.common);
        } else {
            if predicted.intersects(all) {
                let next = self.prediction(attempt);
                self.expect(&next, predicted, attempt.common);
            }
            self.keep(attempt, attempt.sure);
        }
        if attempt.turned.intersects(attempt.sure) {
            for lane in (0..L).filter(|lane| attempt.turned.and(attempt.sure).is_set(*lane)) {
                self.reflections[lane] += 1;
            }
        }
        self.enter(attempt.up, attempt.sure.without(attempt.turned));
    }

    /// Stores the state after the event in the lanes `sure`.
    #[inline(always)]
    fn keep(&mut self, attempt: &Attempt<N, L>, sure: Mask<L>) {
        for i in 0..N {
            self.q[i] = attempt.q[i].or(sure, self.q[i]);
            self.q_dot[i] = attempt.q_dot[i].or(sure, self.q_dot[i]);
            self.lost[i] = attempt.lost[i].or(sure, self.lost[i]);
        }
        self.dissipated = attempt.dissipated.or(sure, self.dissipated);
        self.advance(attempt.t, sure);
    }

    #[inline(always)]
    fn advance(&mut self, t: Pack<L>, sure: Mask<L>) {
        let ([high, low], [sum, rest]) = (self.clock, self.clock_after(t));
        self.clock = [sum.or(sure, high), rest.or(sure, low)];
    }

    /// The time of the clock after the duration `t` [s].
    #[inline(always)]
    fn clock_after(&self, t: Pack<L>) -> [Pack<L>; 2] {
        let [high, low] = self.clock;
        two_sum(high, t + low)
    }

    /// Moves the lanes `sure` into their next cells.
    #[inline(always)]
    fn enter(&mut self, up: Mask<L>, sure: Mask<L>) {
        let last = self.tables.len() - 1;
        for lane in 0..L {
            if !sure.is_set(lane) {
                continue;
            }
            self.changes[lane] += 1;
            let (up, at) = (up.is_set(lane), self.at[lane]);
            if self.long {
                self.turns[lane] += self.tables[at].turns[usize::from(up)][lane];
            }
            // A law of one pitch counts a turn where its cells begin again.
            let turn = i64::from(!self.long);
            (self.at[lane], self.turns[lane]) = match (up, at) {
                (true, at) if at == last => (0, self.turns[lane] + turn),
                (true, at) => (at + 1, self.turns[lane]),
                (false, 0) => (last, self.turns[lane] - turn),
                (false, at) => (at - 1, self.turns[lane]),
            };
        }
    }
}
