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
mod flight;
mod handover;
pub mod kind;
pub mod pack;
mod turning;
pub mod vectors;

use crate::tolerance::events::{BOUND_MARGIN, REVERSION_LIMIT, ROOT_ERROR, SHORT_BOUNCE, WORTH_PREDICTING};
use crate::tolerance::modes::{KERNEL_ANGLE, SERIES_SPAN, SHIFT_SPAN};
use cells::Cells;
use flight::{Flight, Point, Response, responses};
use pack::{Mask, Pack};

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

/// Prediction for the next passage of a cell: its duration, and the responses of the modes after this time. They are computed
/// once the cell has been passed, so that the next passage does not wait for sine, cosine and exponential.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub struct Expected<const N: usize, const L: usize> {
    /// Duration of the last passage, minus the duration at the steady part of the speed [s].
    lateness: Pack<L>,
    /// Duration of the last passage [s]; 0 if there was none.
    last: Pack<L>,
    /// Predicted duration of the next passage [s]. It has a negative sign if the responses are not computed.
    t: Pack<L>,
    /// Responses of the modes after the time `t`.
    responses: [Response<L>; N],
}

impl<const N: usize, const L: usize> Expected<N, L> {
    /// The prediction for a cell that has not been passed yet.
    pub const NOTHING: Expected<N, L> = {
        let zero = Pack([0.0; L]);
        Expected { lateness: zero, last: zero, t: zero, responses: [Response::NONE; N] }
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
            last: self.last.or(mask, other.last),
            t: self.t.or(mask, other.t),
            responses,
        }
    }

    /// The prediction after a passage that took the time `taken`; `steady` is the duration at the steady part of the speed. The
    /// next duration is a linear extrapolation from the last two. Its responses are not computed if the last prediction was far off: the next
    /// one will hardly be used.
    #[inline(always)]
    fn next(&self, cells: &Cells<N, L>, rigid: &[bool; N], taken: Pack<L>, steady: Pack<L>) -> Self {
        let trend = (taken - self.last).zip(0.1 * self.last, |d, most| if d.abs() < most { d } else { 0.0 });
        let (lateness, t) = (taken - steady, taken + trend);
        let missed = (taken - self.t.abs()) * cells.rate;
        let near = missed.compare(missed, |missed, _| missed.abs() <= WORTH_PREDICTING);
        let responses = if near.intersects(Mask::of(|_| true)) { responses(cells, rigid, t) } else { self.responses };
        // Each lane decides for itself: its result does not depend on the others.
        Expected { lateness, last: taken, t: t.or(near, -t), responses }
    }
}

/// The boundary that the phase of each lane meets.
struct Target<const L: usize> {
    /// Whether the boundary is certain: the phase is proved to be monotone, or its crossing was found.
    certain: Mask<L>,
    /// Whether the crossing of a phase that may turn back was found. `steady` is then about its time.
    found: Mask<L>,
    /// Whether it moves to the upper boundary.
    up: Mask<L>,
    /// 1 towards the upper boundary, -1 towards the lower one.
    sign: Pack<L>,
    boundary: Pack<L>,
    /// Distance to the boundary.
    gap: Pack<L>,
    /// Time to the boundary at the steady part of the speed [s].
    steady: Pack<L>,
}

/// The next event of each lane: located and passed, but not yet stored in the lanes.
#[derive(Clone, Copy)]
pub struct Attempt<const N: usize, const L: usize> {
    /// The lanes whose event is plain.
    pub sure: Mask<L>,
    /// Time to the event [s].
    pub t: Pack<L>,
    /// Whether it is at the upper boundary of the cell.
    up: Mask<L>,
    /// Whether the motion is turned back.
    turned: Mask<L>,
    /// Whether the phase may have turned within the flight. The time of the event then does not predict the next one.
    found: Mask<L>,
    /// Number of evaluations of the motion.
    pub evaluations: usize,
    /// Time to the event at the steady part of the speed [s].
    steady: Pack<L>,
    /// Coordinates and speeds just before the event.
    pub arrival: [[Pack<L>; N]; 2],
    /// The state after the event.
    q: [Pack<L>; N],
    q_dot: [Pack<L>; N],
    lost: [Pack<L>; N],
    dissipated: Pack<L>,
    /// The cell of all active lanes; `None` if they are in different cells.
    common: Option<usize>,
}

/// The located events of the lanes.
struct Located<const L: usize> {
    /// The lanes that are proved to reach their boundary.
    sure: Mask<L>,
    /// Time to the event [s].
    t: Pack<L>,
    /// Number of evaluations of the motion.
    evaluations: usize,
    /// The cell of all active lanes; `None` if they are in different cells.
    common: Option<usize>,
}

/// Maximum number of evaluations of the motion. A lane that needs more is left to the general loop.
const MOST: usize = 3;

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
        let gathered;
        let cells = if together {
            &self.tables[first]
        } else {
            gathered = Cells::gather(&self.tables, &self.at);
            &gathered
        };
        let expected = self.expected(together, first);
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
        let common = together.then_some(first);
        self.jump(cells, &flight, &target, &points, Located { sure, t, evaluations, common })
    }

    /// Stores the events of an attempt in the lanes in which they are plain.
    #[inline(always)]
    pub fn take(&mut self, attempt: &Attempt<N, L>) {
        // All events are plain almost always. The branch lets the next flight start without waiting for the mask.
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

    /// The boundary to which the phase moves, and whether the phase is proved to be monotone: the steady part of its speed
    /// exceeds a bound on the speed of the oscillations.
    #[inline(always)]
    fn target(&self, cells: &Cells<N, L>, flight: &Flight<'_, N, L>) -> Target<L> {
        let (mut drift, mut oscillation, mut uniform) = (Pack::all(0.0), Pack::all(0.0), Mask::of(|_| true));
        for i in 0..N {
            let (c, v, a) = (cells.modes[i].part, flight.speed[i], flight.acceleration(i));
            if self.rigid[i] {
                drift = drift + c * v;
                uniform = uniform.and((c * a).compare(c, |a, _| a == 0.0));
            } else {
                oscillation = oscillation + c.abs() * (v.abs() + a.abs() * cells.modes[i].gain);
            }
        }
        let up = drift.compare(drift, |d, _| d > 0.0);
        let sign = Pack::all(1.0).or_uniform(up, Pack::all(-1.0));
        let boundary = cells.bounds[1].or_uniform(up, cells.bounds[0]);
        let gap = sign * (boundary - self.q[self.phase]);
        let monotone = uniform.and(drift.abs().compare(oscillation, |d, w| d > w * (1.0 + BOUND_MARGIN)));
        let found = Mask::of(|_| false);
        Target { certain: monotone, found, up, sign, boundary, gap, steady: gap / drift.abs() }
    }

    /// The time of the crossing, the modes at that time, and the number of evaluations: Newton's method from the predicted time.
    /// The result of a lane is that of its first converged step; further steps of other lanes do not change it.
    #[inline(always)]
    fn locate(
        &self,
        cells: &Cells<N, L>,
        flight: &Flight<'_, N, L>,
        target: &Target<L>,
        expected: &Expected<N, L>,
        sure: Mask<L>,
    ) -> (Mask<L>, Pack<L>, [Point<L>; N], usize) {
        let guess =
            (target.steady + expected.lateness).zip(target.steady, |t, steady| if t > 0.0 { t } else { steady });
        let guess = target.steady.or(target.found, guess);
        // The condition is also false for NaN.
        let near_enough = ((guess - expected.t) * cells.rate).compare(guess, |angle, _| angle.abs() <= SHIFT_SPAN);
        let near_enough = near_enough.without(target.found);
        let elsewhere = Mask::of(|_| true).without(near_enough);
        let (mut t, mut near) = (expected.t, flight.all_after(&expected.responses));
        if elsewhere.intersects(sure) {
            t = guess.or(elsewhere, t);
            let anew = flight.all_after(&responses(cells, &self.rigid, guess));
            for i in 0..N {
                near[i] = anew[i].or(elsewhere, &near[i]);
            }
        }
        let (mut points, mut taken, mut done, mut evaluations) = (near, t, Mask::of(|_| false), 0);
        for round in 1..=MOST {
            evaluations = round;
            let [s, r, a, jerk, snap] = self.signal(cells, flight, &near, target.sign);
            let f = target.gap - s;
            // The root of f - r dt - a dt²/2 - jerk dt³/6 - snap dt⁴/24 by reversion of the series.
            let inverse = 1.0 / r;
            let h = f * inverse;
            let (a, j) = (0.5 * a * inverse * h, (1.0 / 6.0) * jerk * inverse * h * h);
            let snap = (1.0 / 24.0) * snap * inverse * h * h * h;
            let dt = h * (1.0 - a + (2.0 * a * a - j) - (5.0 * a * (a * a - j) + snap));
            let angle = dt.abs() * cells.rate;
            let next = a * a + j.abs();
            let lacking = (14.0 * next * next + snap.abs() * (angle + 6.0 * a.abs())) * dt.abs();
            let good = angle
                .compare(a, |angle, a| (angle <= SHIFT_SPAN) & (a.abs() < REVERSION_LIMIT))
                .and(r.compare(r, |r, _| r > 0.0));
            let good = good.and(lacking.compare(t, |l, t| l <= ROOT_ERROR * t)).without(done);
            let shifted = flight.all_shifted(&self.rigid, &near, t, dt);
            for i in 0..N {
                points[i] = shifted[i].or(good, &points[i]);
            }
            taken = (t + dt).or(good, taken);
            done = done.with(good);
            if done.covers(sure) || round == MOST {
                break;
            }
            t = t + dt.zip(t, |dt, t| dt.max(-0.5 * t).min(t));
            near = flight.all_after(&responses(cells, &self.rigid, t));
        }
        let in_time = taken.compare(self.end - self.clock[0] - self.clock[1], |t, left| t < left);
        let angle = cells.rate * taken;
        let resolved = angle.compare(angle, |angle, _| (angle >= SERIES_SPAN) & (angle < KERNEL_ANGLE));
        // Newton's method must converge to the crossing that was found, not to another one.
        let beside = ((taken - guess) * cells.rate).compare(guess, |angle, _| angle.abs() <= 2.0 * SHIFT_SPAN);
        let sure = sure.and(done).and(in_time).and(resolved);
        (sure.without(target.found.without(beside)), taken, points, evaluations)
    }

    /// The state after the event, in the lanes that pass or are turned back.
    #[inline(always)]
    fn jump(
        &self,
        cells: &Cells<N, L>,
        flight: &Flight<'_, N, L>,
        target: &Target<L>,
        points: &[Point<L>; N],
        Located { sure, t, evaluations, common }: Located<L>,
    ) -> Attempt<N, L> {
        let (mut q, mut q_dot, mut lost, mut dissipated) = (self.q, self.q_dot, self.lost, self.dissipated);
        let mut gained = [Pack::all(0.0); N];
        for j in 0..N {
            for i in 0..N {
                q[i] = q[i] + cells.shapes[i][j] * points[j].moved;
                gained[i] = gained[i] + cells.shapes[i][j] * points[j].gained;
            }
            if !self.rigid[j] {
                for i in 0..N {
                    lost[i] = lost[i] - cells.excess[i][j] * points[j].gained;
                }
                dissipated = dissipated + flight.dissipated(j, &points[j]);
            }
        }
        q[self.phase] = target.boundary;
        let mut arrival = [q, q_dot];
        for i in 0..N {
            arrival[1][i] = q_dot[i] + (gained[i] + lost[i]);
        }
        let mut dv = Pack::all(0.0);
        for i in 0..N {
            for j in 0..N {
                dv = dv + cells.step[1][i][j].or_uniform(target.up, cells.step[0][i][j]) * q[i] * q[j];
            }
        }
        let v = q_dot[self.phase] + gained[self.phase];
        let lowered = 2.0 * self.compliance * dv;
        let square = v * v - lowered;
        let gain = -(target.sign * lowered) / (square.sqrt() + v.abs());
        let passes = square.compare(v, |square, v| (square > 0.0) & v.is_finite());
        let turned = square.compare(v, |square, v| (square < 0.0) & v.is_finite());
        let (mut gain, mut goes_on) = (gain, passes);
        if turned.intersects(sure) {
            gain = (-2.0 * v).or(turned, gain);
            goes_on = goes_on.with(turned.and(self.is_free(cells, flight, points, v)));
        }
        for i in 0..N {
            [q_dot[i], lost[i]] = two_sum(q_dot[i], (gained[i] + lost[i]) + self.direction[i] * gain);
        }
        q[self.phase] = target.boundary.or_uniform(turned, cells.entered[1].or_uniform(target.up, cells.entered[0]));
        let (sure, up, steady, found) = (sure.and(goes_on), target.up, target.steady, target.found);
        Attempt { sure, t, up, turned, found, evaluations, steady, arrival, q, q_dot, lost, dissipated, common }
    }

    /// Whether a motion that is turned back with the normal speed `v` is not pressed against the step ([`presses`]): its bounce is longer than a
    /// pressed one. The acceleration after the impulse is at most that before it plus what the dampers add.
    ///
    /// [`presses`]: crate::engine::contact::presses
    #[inline(always)]
    fn is_free(&self, cells: &Cells<N, L>, flight: &Flight<'_, N, L>, points: &[Point<L>; N], v: Pack<L>) -> Mask<L> {
        let mut acceleration = Pack::all(0.0);
        for i in 0..N {
            acceleration = acceleration + cells.modes[i].part * flight.derivatives(i, &points[i])[1];
        }
        let bounce = 2.0 * v.abs() * cells.rate;
        bounce.compare(acceleration, |bounce, a| bounce > SHORT_BOUNCE * (a.abs() + bounce))
    }

    /// Displacement of the phase towards its boundary, and its first four derivatives.
    #[inline(always)]
    fn signal(
        &self,
        cells: &Cells<N, L>,
        flight: &Flight<'_, N, L>,
        points: &[Point<L>; N],
        sign: Pack<L>,
    ) -> [Pack<L>; 5] {
        let mut sum = [Pack::all(0.0); 5];
        for i in 0..N {
            let c = sign * cells.modes[i].part;
            let [v, a, jerk, snap] = flight.derivatives(i, &points[i]);
            for (sum, x) in sum.iter_mut().zip([points[i].moved, v, a, jerk, snap]) {
                *sum = *sum + c * x;
            }
        }
        sum
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

    /// The prediction for the cell of each lane.
    #[inline(always)]
    fn expected(&self, together: bool, first: usize) -> Expected<N, L> {
        let mut all = self.expected[first];
        if !together {
            for (place, expected) in self.expected.iter().enumerate() {
                all = expected.or(Mask::of(|lane| self.at[lane] == place), &all);
            }
        }
        all
    }

    /// The prediction for the next passage of the cells of an attempt.
    #[inline(always)]
    fn prediction(&self, attempt: &Attempt<N, L>) -> Expected<N, L> {
        let gathered;
        let cells = match attempt.common {
            Some(first) => &self.tables[first],
            None => {
                gathered = Cells::gather(&self.tables, &self.at);
                &gathered
            }
        };
        let expected = self.expected(attempt.common.is_some(), attempt.common.unwrap_or(0));
        expected.next(cells, &self.rigid, attempt.t, attempt.steady)
    }

    /// Stores the prediction of the lanes `sure`.
    #[inline(always)]
    fn expect(&mut self, next: &Expected<N, L>, sure: Mask<L>, common: Option<usize>) {
        if let Some(first) = common {
            self.expected[first] = next.or(sure, &self.expected[first]);
            return;
        }
        for (place, expected) in self.expected.iter_mut().enumerate() {
            *expected = next.or(sure.and(Mask::of(|lane| self.at[lane] == place)), expected);
        }
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

/// The sum a + b and its rounding error (Knuth).
#[inline(always)]
fn two_sum<const L: usize>(a: Pack<L>, b: Pack<L>) -> [Pack<L>; 2] {
    let sum = a + b;
    let part = sum - a;
    [sum, (a - (sum - part)) + (b - part)]
}
