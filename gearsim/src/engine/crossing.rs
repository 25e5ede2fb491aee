//! The first crossing of a boundary by a phase, guaranteed.
//!
//! The phase s(t) = s_0 + sum c_i dxi_i(t) of a linear cell starts between two boundaries. There are two cases:
//! - If the steady part of its speed exceeds a bound on the speed of the oscillations, s is monotone. It crosses only one
//!   boundary, once, and Newton's method in a bracket finds this root.
//! - Otherwise the search advances by steps that are proved to contain no crossing ([`step`]). Where the oscillations cannot
//!   reach the boundary yet, it advances at once to the earliest time at which they could. It ends when exactly one simple root
//!   is proved to lie ahead; Newton's method finds it.
//!
//! A phase that starts on a boundary and leaves it has the known root s(0) = 0. This root is divided out ([`departure`]), so that
//! the time of its return has a relative error of a few roundings, however short it is.
//!
//! A boundary that is touched but not passed by more than [`Search::tolerance`] is a graze. A graze is counted, but it is not an
//! event.

mod bernstein;
mod departure;
mod lateness;
mod march;
mod step;

use crate::engine::cell::Point;
use crate::engine::signal::Signal;
use crate::tolerance::events;
use crate::tolerance::modes::SHIFT_SPAN;

pub use lateness::Delay;

/// One of the two boundaries of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// The boundary at the smaller phase.
    Lower,
    /// The boundary at the larger phase.
    Upper,
}

impl Side {
    /// The direction towards this boundary: 1 or -1.
    #[inline]
    pub fn sign(self) -> f64 {
        if self == Side::Upper { 1.0 } else { -1.0 }
    }

    /// The other boundary.
    pub fn opposite(self) -> Side {
        if self == Side::Upper { Side::Lower } else { Side::Upper }
    }
}

/// The cost of a search.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Cost {
    /// Number of evaluations of the motion.
    pub evaluations: u64,
    /// Number of steps of the search, including those of Newton's method.
    pub steps: u64,
    /// Number of grazes: boundaries touched but not passed.
    pub grazes: u64,
}

/// Why a search found no answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum SearchError {
    /// It reached the maximum number of steps.
    #[error("the search did not end in {0} steps")]
    Stuck(u64),
    /// A number overflowed.
    #[error("a bound on the motion is larger than the range of floating-point numbers")]
    Overflow,
}

/// The search for the first crossing of a signal between two boundaries.
#[derive(Debug)]
pub struct Search<'a> {
    /// The signal.
    pub signal: Signal<'a>,
    /// Its derivative at the start, as exactly as it is known.
    pub rate: f64,
    /// Distance to the lower boundary, >= 0; may be infinite [unit of the signal].
    pub down: f64,
    /// Distance to the upper boundary, >= 0; may be infinite [unit of the signal].
    pub up: f64,
    /// Only crossings before this time are sought \[s\].
    pub horizon: f64,
}

/// Maximum number of steps of Newton's method. Bisection alone would need fewer.
const MOST_NEWTON: u64 = 200;

impl Search<'_> {
    /// The first boundary reached before the horizon, with `point` moved there. If there is none, `point` is at an undefined
    /// time. On entry `point` must be at the start.
    ///
    /// # Errors
    /// If the search does not end, or a number overflows.
    #[inline]
    pub fn first(&self, point: &mut Point, cost: &mut Cost) -> Result<Option<Side>, SearchError> {
        self.first_near(&mut Delay::default(), point, cost)
    }

    /// The same search, started at the time that the last passage predicts for the crossing. Stores the delay of this passage in
    /// `lateness`.
    ///
    /// # Errors
    /// Those of [`Search::first`].
    #[inline]
    pub fn first_near(
        &self,
        lateness: &mut Delay,
        point: &mut Point,
        cost: &mut Cost,
    ) -> Result<Option<Side>, SearchError> {
        let span = self.span();
        let (drift, oscillation) = self.signal.drift_and_oscillation(span);
        if drift.abs() > oscillation * (1.0 + events::BOUND_MARGIN) {
            let gap = if drift > 0.0 { self.up } else { self.down };
            // The bounds hold until the phase has crossed.
            if span == self.horizon || gap < span * (drift.abs() - oscillation) {
                return Ok(self.monotone(drift, oscillation, lateness, point, cost));
            }
        }
        self.march(point, cost)
    }

    /// The crossing that Newton's method finds from the same guess, without a bound, without a proof that it is the first, and
    /// without a bracket. It serves to measure the cost of the guarantee.
    pub fn newton_alone(&self, lateness: &mut Delay, point: &mut Point, cost: &mut Cost) -> Option<Side> {
        let drift = self.signal.drift_and_oscillation(self.horizon).0;
        let (side, gap) = if drift > 0.0 { (Side::Upper, self.up) } else { (Side::Lower, self.down) };
        let steady = gap / drift.abs();
        self.go(point, lateness.guess(side, steady), cost);
        let met = self.newton(side, gap, (0.0, 4.0 * steady), point, cost);
        lateness.note(side, steady, point.t);
        met
    }

    /// The time for which the motion is bounded at once \[s\]. A free motion is bounded for all times. Loads that vary can change the motion
    /// without limit; at its present rate the phase crosses in half of this time.
    #[inline]
    fn span(&self) -> f64 {
        if self.signal.flight.driven().is_none() {
            return self.horizon;
        }
        let gap = if self.rate > 0.0 { self.up } else { self.down };
        let crossed = 2.0 * gap / self.rate.abs();
        if crossed < self.horizon { crossed } else { self.horizon }
    }

    /// Depth of a graze [unit of the signal]: a boundary passed by less than this is not crossed.
    pub fn tolerance(&self) -> f64 {
        let width = [self.up, self.down].into_iter().filter(|x| x.is_finite()).sum::<f64>();
        events::GRAZE_DEPTH * width
    }

    /// The only crossing of a monotone phase: Newton's method in a bracket, from the expected time.
    #[inline]
    fn monotone(
        &self,
        drift: f64,
        oscillation: f64,
        lateness: &mut Delay,
        point: &mut Point,
        cost: &mut Cost,
    ) -> Option<Side> {
        let (side, gap) = if drift > 0.0 { (Side::Upper, self.up) } else { (Side::Lower, self.down) };
        let (slowest, fastest) = (drift.abs() - oscillation, drift.abs() + oscillation);
        let bracket = (gap / fastest * (1.0 - events::BRACKET_MARGIN), gap / slowest * (1.0 + events::BRACKET_MARGIN));
        if bracket.0 >= self.horizon {
            return None;
        }
        let steady = gap / drift.abs();
        let guess = lateness.guess(side, steady);
        self.go(point, if guess > bracket.0 && guess < bracket.1 { guess } else { steady }, cost);
        let met = self.newton(side, gap, bracket, point, cost);
        lateness.note(side, steady, point.t);
        met
    }

    /// Newton's method, from `point`, for the only root in a bracket. The root counts if it lies before the horizon.
    ///
    /// Once the root of the local Taylor polynomial is near, the motion is moved there by its series. One full evaluation of the
    /// motion is usually enough, and two almost always.
    #[inline]
    fn newton(&self, side: Side, gap: f64, bracket: (f64, f64), point: &mut Point, cost: &mut Cost) -> Option<Side> {
        let sign = side.sign();
        let (mut low, mut high) = bracket;
        for _ in 0..MOST_NEWTON {
            cost.steps += 1;
            let t = point.t;
            let [s, r, a, j, snap] = self.signal.derivatives(point);
            let (r, a, j, snap) = (sign * r, sign * a, sign * j, sign * snap);
            let f = gap - sign * s;
            if f > 0.0 {
                low = t
            } else {
                high = t
            }
            // The root of f - r dt - a dt²/2 - j dt³/6 - snap dt⁴/24 by reversion of the series.
            let (h, inverse) = (f / r, 1.0 / r);
            let (a, j, snap) =
                (a * inverse * h * 0.5, j * inverse * h * h * (1.0 / 6.0), snap * inverse * h * h * h * (1.0 / 24.0));
            let dt = h * (1.0 - a + (2.0 * a * a - j) - (5.0 * a * (a * a - j) + snap));
            let inside = t + dt >= low && t + dt <= high && a.abs() < events::REVERSION_LIMIT;
            let angle = dt.abs() * self.signal.flight.rate();
            if inside && angle <= SHIFT_SPAN {
                self.signal.flight.shift(point, dt);
                // The error of the truncated series is below one rounding.
                let next = a * a + j.abs();
                if (14.0 * next * next + snap.abs() * (angle + 6.0 * a.abs())) * dt.abs() <= events::ROOT_ERROR * t {
                    break;
                }
            } else if high - low <= events::BRACKET_WIDTH * high {
                break;
            } else {
                self.go(point, if inside { t + dt } else { 0.5 * (low + high) }, cost);
            }
        }
        // If the rate has a rounding error, the root may lie before the start.
        if point.t < 0.0 {
            self.go(point, 0.0, cost);
        }
        (point.t < self.horizon).then_some(side)
    }

    #[inline]
    fn go(&self, point: &mut Point, t: f64, cost: &mut Cost) {
        cost.evaluations += 1;
        self.signal.flight.go(point, t);
    }
}
