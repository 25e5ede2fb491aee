//! The first crossing of a boundary, guaranteed.
//!
//! The phase s(t) = s_0 + sum c_i dxi_i(t) of a linear cell starts between two boundaries. Its first crossing is found
//! in one of two ways. If the steady part of its speed outweighs all that the oscillations can do, s is monotone: the
//! crossing is the only one, and Newton in a bracket finds it. Otherwise the search marches, by steps that are proved not
//! to pass a crossing ([`step`]); where the oscillations cannot reach as far as the boundary, at once to where they first
//! could. It ends where one simple root is proved to lie ahead, and Newton finds that.
//!
//! A phase that starts on a boundary and leaves it has s(0) = 0 for a known root. It is divided out ([`departure`]), so
//! that the return is found to rounding of its own time, however short.
//!
//! Depth: a boundary touched to within [`Search::tolerance`] (a few roundings of s) without passing is a graze: no
//! event, counted.

mod bernstein;
mod departure;
mod lateness;
mod march;
mod step;

use crate::engine::cell::Point;
use crate::engine::signal::Signal;
use crate::tolerance::events;
use crate::tolerance::modes::SHIFT_SPAN;

pub use lateness::Lateness;

/// Which boundary.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The one at smaller phase.
    Lower,
    /// The one at larger phase.
    Upper,
}

impl Side {
    /// The direction in which it lies.
    #[inline]
    pub fn sign(self) -> f64 {
        if self == Side::Upper { 1.0 } else { -1.0 }
    }

    /// The other one.
    pub fn opposite(self) -> Side {
        if self == Side::Upper { Side::Lower } else { Side::Upper }
    }
}

/// What a search costs.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Cost {
    /// Evaluations of the motion.
    pub evaluations: u64,
    /// Steps of the search, Newton's and the march's.
    pub steps: u64,
    /// Touches without passing.
    pub grazes: u64,
}

/// Why a search has no answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum Lost {
    /// It did not end.
    #[error("the search did not end in {0} steps")]
    Stuck(u64),
    /// It left the numbers.
    #[error("a bound on the motion is beyond what numbers can hold")]
    Overflow,
}

/// A signal between two boundaries.
#[derive(Debug)]
pub struct Search<'a> {
    /// What is watched.
    pub signal: Signal<'a>,
    /// Its rate at the start, as exactly as it is known.
    pub rate: f64,
    /// Distance to the lower boundary, >= 0; may be infinite.
    pub down: f64,
    /// Distance to the upper boundary, >= 0; may be infinite.
    pub up: f64,
    /// No crossing at or after this time is sought [s].
    pub horizon: f64,
}

/// A bracket is halved to rounding in fewer steps than this.
const MOST_NEWTON: u64 = 200;

impl Search<'_> {
    /// The first boundary met before the horizon, with `point` moved there; else `point` is anywhere. `point` is to be at
    /// the start.
    ///
    /// # Errors
    /// Where the search does not end, or leaves the numbers.
    #[inline]
    pub fn first(&self, point: &mut Point, cost: &mut Cost) -> Result<Option<Side>, Lost> {
        self.first_near(&mut Lateness::default(), point, cost)
    }

    /// The same, beginning where the phase is expected; notes how late it is.
    ///
    /// # Errors
    /// Those of [`Search::first`].
    #[inline]
    pub fn first_near(
        &self,
        lateness: &mut Lateness,
        point: &mut Point,
        cost: &mut Cost,
    ) -> Result<Option<Side>, Lost> {
        let (drift, wobble) = self.signal.drift_and_wobble();
        if drift.abs() > wobble * (1.0 + events::BOUND_MARGIN) {
            return Ok(self.monotone(drift, wobble, lateness, point, cost));
        }
        self.march(point, cost)
    }

    /// The crossing that Newton's method alone leads to, from the same guess: no bound, no certificate that it is the first,
    /// no bracket that binds. For measuring what the guarantee costs.
    pub fn newton_alone(&self, lateness: &mut Lateness, point: &mut Point, cost: &mut Cost) -> Option<Side> {
        let drift = self.signal.drift_and_wobble().0;
        let (side, gap) = if drift > 0.0 { (Side::Upper, self.up) } else { (Side::Lower, self.down) };
        let steady = gap / drift.abs();
        self.go(point, lateness.guess(side, steady), cost);
        let met = self.newton(side, gap, (0.0, 4.0 * steady), point, cost);
        lateness.note(side, steady, point.t);
        met
    }

    /// Depth to which a touch is told from a crossing [unit of the signal].
    pub fn tolerance(&self) -> f64 {
        let width = [self.up, self.down].into_iter().filter(|x| x.is_finite()).sum::<f64>();
        events::GRAZE_DEPTH * width
    }

    /// The only crossing of a monotone phase: Newton from where it is expected, in a bracket.
    #[inline]
    fn monotone(
        &self,
        drift: f64,
        wobble: f64,
        lateness: &mut Lateness,
        point: &mut Point,
        cost: &mut Cost,
    ) -> Option<Side> {
        let (side, gap) = if drift > 0.0 { (Side::Upper, self.up) } else { (Side::Lower, self.down) };
        let (slowest, fastest) = (drift.abs() - wobble, drift.abs() + wobble);
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

    /// Newton's method from `point` for the one root in a bracket; it counts if it lies before the horizon.
    ///
    /// Once the root of the local Taylor polynomial is near, the motion is carried there by its series: one evaluation of the
    /// motion in full is mostly enough, two nearly always.
    #[inline]
    fn newton(&self, side: Side, gap: f64, bracket: (f64, f64), point: &mut Point, cost: &mut Cost) -> Option<Side> {
        let sign = side.sign();
        let (mut low, mut high) = bracket;
        for _ in 0..MOST_NEWTON {
            cost.steps += 1;
            let t = point.t;
            let [s, r, a, j, snap] = self.signal.derivatives(point).map(|x| sign * x);
            let f = gap - s;
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
                // What the next terms of the series could add is below rounding.
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
        // A rounding of the rate may put it before the start.
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
