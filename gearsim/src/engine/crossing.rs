//! The first crossing of a boundary, guaranteed.
//!
//! The phase s(t) = s_0 + sum c_i dxi_i(t) of a linear cell starts between two boundaries. Its first crossing is found
//! in one of two ways. If the steady part of its speed outweighs all that the oscillations can do, s is monotone: the
//! crossing is the only one, and Newton in a bracket finds it. Otherwise the search marches: with |s''| <= B from here
//! on, no boundary at distance f, approached at the rate r, is reached before the first root of f - r h - B h²/2. A
//! march by that step never passes a crossing, and leaves a boundary it starts on (f = 0, r < 0) by itself; leaving at
//! rest (r = 0), it goes by the higher derivatives. Where the oscillations cannot reach as far as the boundary, the march
//! goes at once to where they first could.
//!
//! Depth: a boundary touched to within [`Search::tolerance`] (a few roundings of s) without passing is a graze: no
//! event, counted.

use crate::engine::cell::Point;
use crate::engine::mode::NEAR;
use crate::engine::signal::Signal;

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

/// A signal between two boundaries.
#[derive(Debug)]
pub struct Search<'a, const N: usize> {
    /// What is watched.
    pub signal: Signal<'a, N>,
    /// Distance to the lower boundary, >= 0; may be infinite.
    pub down: f64,
    /// Distance to the upper boundary, >= 0; may be infinite.
    pub up: f64,
    /// No crossing at or after this time is sought [s].
    pub horizon: f64,
}

/// More steps than this mean that the search is stuck.
const MOST_STEPS: u64 = 1_000_000;
/// A bracket is halved to rounding in fewer steps than this.
const MOST_NEWTON: u64 = 200;

impl<const N: usize> Search<'_, N> {
    /// The first boundary met before the horizon, with `point` moved there; else `point` is anywhere. `point` is to be at
    /// the start.
    ///
    /// # Errors
    /// The number of steps taken, where the search does not end.
    #[inline]
    pub fn first(&self, point: &mut Point<N>, cost: &mut Cost) -> Result<Option<Side>, u64> {
        let (drift, wobble) = self.signal.drift_and_wobble();
        if drift.abs() > wobble * (1.0 + 1e-12) {
            return Ok(self.monotone(drift, wobble, point, cost));
        }
        self.march(point, cost)
    }

    /// The crossing that Newton's method alone leads to, from the same guess: no bound, no certificate that it is the first,
    /// no bracket that binds. For measuring what the guarantee costs.
    pub(super) fn unguarded(&self, point: &mut Point<N>, cost: &mut Cost) -> Option<Side> {
        let drift = self.signal.drift_and_wobble().0;
        let (side, gap) = if drift > 0.0 { (Side::Upper, self.up) } else { (Side::Lower, self.down) };
        let guess = gap / drift.abs();
        self.go(point, guess, cost);
        self.newton(side, gap, (0.0, 4.0 * guess), point, cost)
    }

    /// Depth to which a touch is told from a crossing [unit of the signal].
    pub fn tolerance(&self) -> f64 {
        let width = [self.up, self.down].into_iter().filter(|x| x.is_finite()).sum::<f64>();
        4.0 * f64::EPSILON * width
    }

    /// The only crossing of a monotone phase: Newton from the steady guess, in a bracket.
    fn monotone(&self, drift: f64, wobble: f64, point: &mut Point<N>, cost: &mut Cost) -> Option<Side> {
        let (side, gap) = if drift > 0.0 { (Side::Upper, self.up) } else { (Side::Lower, self.down) };
        let (slowest, fastest) = (drift.abs() - wobble, drift.abs() + wobble);
        let bracket = (gap / fastest * (1.0 - 1e-15), gap / slowest * (1.0 + 1e-15));
        if bracket.0 >= self.horizon {
            return None;
        }
        self.go(point, gap / drift.abs(), cost);
        self.newton(side, gap, bracket, point, cost)
    }

    /// Newton's method from `point` for the one root in a bracket; it counts if it lies before the horizon.
    ///
    /// Once the root of the local Taylor polynomial is near, the motion is carried there by its series: one evaluation of the
    /// motion in full is mostly enough, two nearly always.
    #[inline]
    fn newton(&self, side: Side, gap: f64, bracket: (f64, f64), point: &mut Point<N>, cost: &mut Cost) -> Option<Side> {
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
            let inside = t + dt >= low && t + dt <= high && a.abs() < 0.1;
            let angle = dt.abs() * self.signal.flight.rate();
            if inside && angle <= NEAR {
                self.signal.flight.shift(point, dt);
                // What the next terms of the series could add is below rounding.
                let next = a * a + j.abs();
                if (14.0 * next * next + snap.abs() * (angle + 6.0 * a.abs())) * dt.abs() <= f64::EPSILON * t {
                    break;
                }
            } else if high - low <= 4.0 * f64::EPSILON * high {
                break;
            } else {
                self.go(point, if inside { t + dt } else { 0.5 * (low + high) }, cost);
            }
        }
        (point.t < self.horizon).then_some(side)
    }

    /// Marches by steps that cannot pass a crossing.
    fn march(&self, point: &mut Point<N>, cost: &mut Cost) -> Result<Option<Side>, u64> {
        let tolerance = self.tolerance();
        let mut approached = [false; 2];
        for _ in 0..MOST_STEPS {
            cost.steps += 1;
            let t = point.t;
            let [moved, rate, acceleration, jerk, _] = self.signal.derivatives(point);
            let bounds = self.signal.bounds(point);
            let reach = self.signal.reach(point);
            let mut h = f64::INFINITY;
            for (i, (side, full)) in [(Side::Upper, self.up), (Side::Lower, self.down)].into_iter().enumerate() {
                if full.is_infinite() {
                    continue;
                }
                let sign = side.sign();
                let (gap, r, a, j) = (full - sign * moved, sign * rate, sign * acceleration, sign * jerk);
                if gap <= tolerance && r >= 0.0 && (r > 0.0 || a > 0.0) {
                    // Here or hereabouts: does it pass, or turn within the tolerance?
                    let depth = if a < 0.0 { gap + r * r / (2.0 * a) } else { f64::NEG_INFINITY };
                    if depth <= -tolerance || a >= 0.0 {
                        return Ok((t < self.horizon).then_some(side));
                    }
                    cost.grazes += 1;
                    approached[i] = false;
                    h = h.min(2.0 * (r + (2.0 * tolerance * a.abs()).sqrt()) / a.abs());
                    continue;
                }
                // Turned between two steps: was that a touch?
                if approached[i] && r < 0.0 && gap <= tolerance + r * r / (2.0 * a.abs()) {
                    cost.grazes += 1;
                }
                approached[i] = r > 0.0;
                let (gap, bound) = (gap.max(0.0), bounds[0]);
                if r > 0.0 && 2.0 * bound * (gap + tolerance) < 0.99 * r * r {
                    // One root, simple, before anything else can happen; rounding of the gap does not make it one.
                    if gap / (r + (2.0 * bound * gap).sqrt()) > self.horizon - t {
                        continue;
                    }
                    let bracket = (t + 0.5 * gap / r, t + 2.0 * gap / r);
                    self.go(point, t + gap / r, cost);
                    return Ok(self.newton(side, full, bracket, point, cost));
                }
                let clear = clear_of(gap, r, a, j, bounds, tolerance);
                h = h.min(clear.max(reach.time(gap, sign)));
            }
            let next = t + h;
            if next >= self.horizon || next.is_nan() {
                return Ok(None);
            }
            self.go(point, if next > t { next } else { t.next_up() }, cost);
        }
        Err(MOST_STEPS)
    }

    #[inline]
    fn go(&self, point: &mut Point<N>, t: f64, cost: &mut Cost) {
        cost.evaluations += 1;
        self.signal.flight.go(point, t);
    }
}

/// A time for which a boundary at distance `gap`, approached at rate `r`, acceleration `a` and jerk `j`, is not met;
/// `bounds` are those on the second, third and fourth derivative.
fn clear_of(gap: f64, r: f64, a: f64, j: f64, bounds: [f64; 3], tolerance: f64) -> f64 {
    // The first root of gap - r h - B h²/2.
    let root = (r * r + 2.0 * bounds[0] * gap).sqrt();
    let second = if r > 0.0 {
        2.0 * gap / (r + root)
    } else if bounds[0] > 0.0 {
        (root - r) / bounds[0]
    } else {
        f64::INFINITY
    };
    // Leaving it: what the first derivatives give outweighs the bound on the next.
    let leaving = |d: f64, bound: f64| if bound > 0.0 { -d / bound } else { f64::INFINITY };
    let third = if r <= 0.0 && a < 0.0 { 3.0 * leaving(a, bounds[1]) } else { 0.0 };
    let fourth = if r <= 0.0 && a <= 0.0 && j < 0.0 { 4.0 * leaving(j, bounds[2]) } else { 0.0 };
    let clear = second.max(third).max(fourth);
    // At rest on the boundary: nothing else bounds the step; a tolerance's worth is safe.
    if clear == 0.0 { (2.0 * tolerance / bounds[0]).sqrt() } else { clear }
}
