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

/// Which boundary.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The one at smaller phase.
    Lower,
    /// The one at larger phase.
    Upper,
}

/// A crossing.
#[derive(Debug, Clone, Copy)]
pub struct Crossing<const N: usize> {
    /// Time from the start of the flight [s].
    pub t: f64,
    /// Boundary that is met.
    pub side: Side,
    /// The modes there.
    pub point: Point<N>,
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

impl<const N: usize> Search<'_, N> {
    /// The first crossing before the horizon.
    ///
    /// # Errors
    /// The number of steps taken, where the search does not end.
    pub fn first(&self, cost: &mut Cost) -> Result<Option<Crossing<N>>, u64> {
        let (drift, wobble) = self.drift_and_wobble();
        if drift.abs() > wobble * (1.0 + 1e-12) {
            return Ok(self.monotone(drift, wobble, cost));
        }
        self.march(cost)
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
            let (v, a) = self.flight.rates(i, None);
            if mode.is_rigid() && a == 0.0 {
                drift += c * v;
            } else if c != 0.0 {
                wobble += c.abs() * mode.bound(v, a);
            }
        }
        (drift, wobble)
    }

    /// The only crossing of a monotone phase: Newton from the steady guess, in a bracket.
    fn monotone(&self, drift: f64, wobble: f64, cost: &mut Cost) -> Option<Crossing<N>> {
        let (side, gap) = if drift > 0.0 { (Side::Upper, self.up) } else { (Side::Lower, self.down) };
        let (slowest, fastest) = (drift.abs() - wobble, drift.abs() + wobble);
        let bracket = (gap / fastest * (1.0 - 1e-15), gap / slowest * (1.0 + 1e-15));
        if bracket.0 >= self.horizon {
            return None;
        }
        self.newton(side, gap, gap / drift.abs(), bracket, cost)
    }

    /// Newton's method for the one root in a bracket; the root counts if it lies before the horizon.
    fn newton(&self, side: Side, gap: f64, guess: f64, bracket: (f64, f64), cost: &mut Cost) -> Option<Crossing<N>> {
        let sign = if side == Side::Upper { 1.0 } else { -1.0 };
        let (mut low, mut high) = bracket;
        let mut t = guess.clamp(low, high);
        for _ in 0..100 {
            let point = self.at(t, cost);
            let (f, r) = (gap - sign * self.moved(&point), sign * self.rate(&point));
            if f > 0.0 {
                low = t
            } else {
                high = t
            }
            let newton = t + f / r;
            let next = if newton > low && newton < high {
                newton
            } else if f == 0.0 {
                t
            } else {
                0.5 * (low + high)
            };
            if (next - t).abs() <= 4.0 * f64::EPSILON * t || f == 0.0 {
                return (t < self.horizon).then_some(Crossing { t, side, point });
            }
            t = next;
        }
        let point = self.at(t, cost);
        (t < self.horizon).then_some(Crossing { t, side, point })
    }

    /// Marches by steps that cannot pass a crossing.
    fn march(&self, cost: &mut Cost) -> Result<Option<Crossing<N>>, u64> {
        let tolerance = self.tolerance();
        let mut t = 0.0;
        let mut point = None;
        for _ in 0..MOST_STEPS {
            cost.steps += 1;
            let moved = point.as_ref().map_or(0.0, |p| self.moved(p));
            let (rate, acceleration, bound) = self.rates(point.as_ref());
            let reach = self.reach(point.as_ref());
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
                        let point = point.unwrap_or_else(|| self.at(0.0, cost));
                        return Ok((t < self.horizon).then_some(Crossing { t, side, point }));
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
                    return Ok(self.newton(side, full, t + gap / r, bracket, cost));
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
            t = if next > t { next } else { t.next_up() };
            point = Some(self.at(t, cost));
        }
        Err(MOST_STEPS)
    }

    /// Rate and acceleration of the phase, and a bound on the latter from here on.
    #[inline]
    fn rates(&self, point: Option<&Point<N>>) -> (f64, f64, f64) {
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
    fn reach(&self, point: Option<&Point<N>>) -> Reach {
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
    fn at(&self, t: f64, cost: &mut Cost) -> Point<N> {
        cost.evaluations += 1;
        self.flight.at(t)
    }

    #[inline]
    fn moved(&self, point: &Point<N>) -> f64 {
        self.participation.dot(&point.moved)
    }

    #[inline]
    fn rate(&self, point: &Point<N>) -> f64 {
        let mut rate = 0.0;
        for i in 0..N {
            rate += self.participation[i] * self.flight.rates(i, Some(point)).0;
        }
        rate
    }
}
