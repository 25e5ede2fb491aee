//! The first crossing of a boundary, guaranteed.
//!
//! The phase s(t) = s_0 + sum c_i dxi_i(t) of a linear cell starts between two boundaries. Its first crossing is found
//! in one of two ways. If the steady part of its speed outweighs all that the oscillations can do, s is monotone: the
//! crossing is the only one, and Newton in a bracket finds it. Otherwise the search marches: with |s''| <= B from here
//! on, no boundary at distance f, approached at the rate r, is reached before the first root of f - r h - B h²/2. A
//! march by that step never passes a crossing, and leaves a boundary it starts on (f = 0, r < 0) by itself. Where the
//! oscillations cannot reach as far as the boundary, the march goes at once to where they first could.
//!
//! Depth: a boundary touched to within [`Search::tolerance`] (a few roundings of s) without passing is a graze: no
//! event, counted.

use nalgebra::SVector;

use crate::engine::cell::{Flight, Point};
use crate::engine::mode::NEAR;

/// Which boundary.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The one at smaller phase.
    Lower,
    /// The one at larger phase.
    Upper,
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

/// The phase of one law along a flight, between two boundaries.
#[derive(Debug)]
pub struct Search<'a, const N: usize> {
    /// The motion.
    pub flight: &'a Flight<'a, N>,
    /// Participation of the modes in the phase, c (N).
    pub participation: &'a SVector<f64, N>,
    /// Distance to the lower boundary, >= 0.
    pub down: f64,
    /// Distance to the upper boundary, >= 0.
    pub up: f64,
    /// No crossing at or after this time is sought [s].
    pub horizon: f64,
}

/// The phase as a steady course and what swings about it.
struct Reach {
    /// Speed of the course.
    drift: f64,
    /// Bound on the swing.
    amplitude: f64,
    /// The swing now.
    deviation: f64,
}

impl Reach {
    /// Time before which a boundary at distance `gap` in the direction `sign` is out of reach.
    fn time(&self, gap: f64, sign: f64) -> f64 {
        let clear = (gap + sign * self.deviation - self.amplitude) * (1.0 - 1e-12);
        match (clear > 0.0, sign * self.drift > 0.0) {
            (true, true) => clear / self.drift.abs(),
            (true, false) => f64::INFINITY,
            _ => 0.0,
        }
    }
}

/// More steps than this mean that the search is stuck.
const MOST_STEPS: u64 = 1_000_000;
/// A bracket is halved to rounding in fewer steps than this.
const MOST_NEWTON: u64 = 200;

impl<const N: usize> Search<'_, N> {
    /// The first boundary met before the horizon, with `point` moved there; else `point` at the horizon. `point` is to be
    /// at the start.
    ///
    /// # Errors
    /// The number of steps taken, where the search does not end.
    pub fn first(&self, point: &mut Point<N>, cost: &mut Cost) -> Result<Option<Side>, u64> {
        let (drift, wobble) = self.drift_and_wobble();
        let met = if drift.abs() > wobble * (1.0 + 1e-12) {
            self.monotone(drift, wobble, point, cost)
        } else {
            self.march(point, cost)?
        };
        if met.is_none() {
            self.go(point, self.horizon, cost);
        }
        Ok(met)
    }

    /// The crossing that Newton's method alone leads to, from the same guess: no bound, no certificate that it is the first,
    /// no bracket that binds. For measuring what the guarantee costs.
    pub(super) fn unguarded(&self, point: &mut Point<N>, cost: &mut Cost) -> Option<Side> {
        let modes = self.flight.modes().iter().enumerate();
        let drift: f64 = modes
            .filter(|(_, mode)| mode.is_rigid())
            .map(|(i, _)| self.participation[i] * self.flight.rates_at_start(i).0)
            .sum();
        let (side, gap) = if drift > 0.0 { (Side::Upper, self.up) } else { (Side::Lower, self.down) };
        let guess = gap / drift.abs();
        self.go(point, guess, cost);
        let met = self.newton(side, gap, (0.0, 4.0 * guess), point, cost);
        if met.is_none() {
            self.go(point, self.horizon, cost);
        }
        met
    }

    /// Depth to which a touch is told from a crossing [unit of the phase].
    pub fn tolerance(&self) -> f64 {
        4.0 * f64::EPSILON * (self.up + self.down)
    }

    /// Steady part of the phase's speed, and a bound on the rest.
    #[inline]
    fn drift_and_wobble(&self) -> (f64, f64) {
        let (mut drift, mut wobble) = (0.0, 0.0);
        for (i, mode) in self.flight.modes().iter().enumerate() {
            let c = self.participation[i];
            let (v, a) = self.flight.rates_at_start(i);
            if mode.is_rigid() && a == 0.0 {
                drift += c * v;
            } else if c != 0.0 {
                wobble += c.abs() * mode.rough_bound(v, a);
            }
        }
        (drift, wobble)
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
        let sign = if side == Side::Upper { 1.0 } else { -1.0 };
        let (mut low, mut high) = bracket;
        for _ in 0..MOST_NEWTON {
            cost.steps += 1;
            let t = point.t;
            let [s, r, a, j, snap] = self.derivatives(point).map(|x| sign * x);
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
            let angle = dt.abs() * self.flight.rate();
            if inside && angle <= NEAR {
                self.flight.shift(point, dt);
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
        for _ in 0..MOST_STEPS {
            cost.steps += 1;
            let (t, moved) = (point.t, self.moved(point));
            let (rate, acceleration, bound) = self.rates(point);
            let reach = self.reach(point);
            let sides = [
                (Side::Upper, self.up - moved, rate, acceleration),
                (Side::Lower, self.down + moved, -rate, -acceleration),
            ];
            let mut h = f64::INFINITY;
            for (side, gap, r, a) in sides {
                if gap <= tolerance && r >= 0.0 && (r > 0.0 || a > 0.0) {
                    // Here or hereabouts: does it pass, or turn within the tolerance?
                    let depth = if a < 0.0 { gap + r * r / (2.0 * a) } else { f64::NEG_INFINITY };
                    if depth <= -tolerance || a >= 0.0 {
                        return Ok((t < self.horizon).then_some(side));
                    }
                    cost.grazes += 1;
                    h = h.min(2.0 * (r + (2.0 * tolerance * a.abs()).sqrt()) / a.abs());
                    continue;
                }
                let gap = gap.max(0.0);
                if r > 0.0 && 2.0 * bound * gap < 0.99 * r * r {
                    // One root, simple, before anything else can happen.
                    if gap / (r + (2.0 * bound * gap).sqrt()) > self.horizon - t {
                        continue;
                    }
                    let bracket = (t + 0.5 * gap / r, t + 2.0 * gap / r);
                    let full = if side == Side::Upper { self.up } else { self.down };
                    self.go(point, t + gap / r, cost);
                    return Ok(self.newton(side, full, bracket, point, cost));
                }
                let root = (r * r + 2.0 * bound * gap).sqrt();
                let safe = if r > 0.0 {
                    2.0 * gap / (r + root)
                } else if bound > 0.0 {
                    (root - r) / bound
                } else {
                    f64::INFINITY
                };
                // At rest on the boundary: nothing bounds the step but the jerk; a tolerance's worth is safe.
                let safe = if safe == 0.0 { (2.0 * tolerance / bound).sqrt() } else { safe };
                let sign = if side == Side::Upper { 1.0 } else { -1.0 };
                h = h.min(safe.max(reach.time(gap, sign)));
            }
            let next = t + h;
            if next >= self.horizon || next.is_nan() {
                return Ok(None);
            }
            self.go(point, if next > t { next } else { t.next_up() }, cost);
        }
        Err(MOST_STEPS)
    }

    /// Rate and acceleration of the phase, and a bound on the latter from here on.
    #[inline]
    fn rates(&self, point: &Point<N>) -> (f64, f64, f64) {
        let (mut rate, mut acceleration, mut bound) = (0.0, 0.0, 0.0);
        for (i, mode) in self.flight.modes().iter().enumerate() {
            let c = self.participation[i];
            if c == 0.0 {
                continue;
            }
            let (v, a) = self.flight.rates(i, point);
            rate += c * v;
            acceleration += c * a;
            bound += c.abs() * mode.bound(a, -2.0 * mode.sigma * a - mode.omega2 * v);
        }
        (rate, acceleration, bound * (1.0 + 1e-12))
    }

    /// How far the oscillations carry the phase about its steady course, from here on.
    fn reach(&self, point: &Point<N>) -> Reach {
        let mut reach = Reach { drift: 0.0, amplitude: 0.0, deviation: 0.0 };
        for (i, mode) in self.flight.modes().iter().enumerate() {
            let c = self.participation[i];
            if c == 0.0 {
                continue;
            }
            let (v, a) = self.flight.rates(i, point);
            if mode.is_rigid() && a == 0.0 {
                reach.drift += c * v;
            } else if mode.omega2 > 0.0 {
                // Deviation from equilibrium, -(spring force)/omega², with the spring force a + 2 sigma v.
                let y = -(a + 2.0 * mode.sigma * v) / mode.omega2;
                reach.deviation += c * y;
                reach.amplitude += c.abs() * mode.bound(y, v);
            } else {
                reach.amplitude = f64::INFINITY;
            }
        }
        reach
    }

    #[inline]
    fn go(&self, point: &mut Point<N>, t: f64, cost: &mut Cost) {
        cost.evaluations += 1;
        self.flight.go(point, t);
    }

    #[inline]
    fn moved(&self, point: &Point<N>) -> f64 {
        self.participation.dot(&point.moved)
    }

    /// The phase's way so far, and its first four derivatives.
    #[inline]
    fn derivatives(&self, point: &Point<N>) -> [f64; 5] {
        let mut sum = [0.0; 5];
        for (i, mode) in self.flight.modes().iter().enumerate() {
            let c = self.participation[i];
            let (v, a) = self.flight.rates(i, point);
            let j = -2.0 * mode.sigma * a - mode.omega2 * v;
            let snap = -2.0 * mode.sigma * j - mode.omega2 * a;
            for (sum, x) in sum.iter_mut().zip([point.moved[i], v, a, j, snap]) {
                *sum += c * x;
            }
        }
        sum
    }
}
