//! The return of a phase that leaves a boundary. The root s(0) = 0 is known and is divided out.
//!
//! The next root of s(t) is the first root of
//!
//! ```text
//! s(t)/t = s'(0) + s''(0) t/2 + s'''(0) t²/6 + ...
//! ```
//!
//! This is a polynomial with a bound on its remainder, over a time for which the remainder is small. Each coefficient has its own rounding
//! error, and s'(0) comes from the state. The time of the return is therefore as exact as 2 s'(0)/s''(0). A root of s itself would be less
//! exact, because s is a sum over modes, with the rounding errors of its largest term.

use super::bernstein::{Bernstein, First};
use super::{Search, Side};
use crate::engine::cell::Point;
use crate::engine::signal::{PowerSeries, TERMS};
use crate::tolerance::events::{self, BALANCED_RATES};

/// Result of the search for a return.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Departure {
    /// The phase returns to its boundary at the time `t` [s].
    Returns { side: Side, t: f64 },
    /// The phase reaches no boundary before the time `until` [s].
    Clear { until: f64 },
}

/// Maximum number of bisections that separate the return from later roots.
const HALVINGS: u32 = 60;
/// Maximum number of Newton steps to the return.
const MOST_NEWTON: u32 = 60;

impl Search<'_> {
    /// Searches for the return of a phase that leaves a boundary; `None` if it does not leave one, or cannot return soon.
    pub(super) fn depart(&self, start: &Point) -> Option<Departure> {
        let (side, other) = match self.rate {
            r if r > 0.0 && self.down == 0.0 => (Side::Lower, self.up),
            r if r < 0.0 && self.up == 0.0 => (Side::Upper, self.down),
            0.0 if self.signal.flight.driven().is_some() => return self.set_off(start),
            _ => return None,
        };
        let (r, bound) = (self.rate.abs(), self.signal.bounds(start, self.horizon)[0]);
        let until = self.stays_inside(r, bound, other);
        if !until.is_finite() || 2.0 * r / bound > until {
            return None;
        }
        let series = self.signal.series(self.horizon);
        Quotient::of(&series, (1, r), side.sign()).search(side, until)
    }

    /// The same for a phase that rests at a boundary, under a load that varies. Its first derivative beyond the rounding errors decides: a
    /// torque at the other end of a train moves it with the fifth power of time. It leaves, or passes the boundary at once.
    fn set_off(&self, start: &Point) -> Option<Departure> {
        let series = self.signal.series(self.horizon);
        let moves =
            |k: &usize| series.derivatives[*k].abs() > BALANCED_RATES / events::SIGNAL_ROUNDING * series.rounding[*k];
        let (side, other) = match (self.down == 0.0, self.up == 0.0) {
            (true, false) => (Side::Lower, self.up),
            (false, true) => (Side::Upper, self.down),
            _ => return None,
        };
        let until = self.stays_inside(0.0, self.signal.bounds(start, self.horizon)[0], other);
        let Some(first) = (0..TERMS).find(moves) else {
            return until.is_finite().then_some(Departure::Clear { until });
        };
        let leading = -side.sign() * series.derivatives[first];
        if leading < 0.0 {
            return Some(Departure::Returns { side, t: 0.0 });
        }
        if !until.is_finite() {
            return None;
        }
        Quotient::of(&series, (first + 2, leading), side.sign()).search(side, until)
    }

    /// A time within which a phase with the speed `r` reaches no boundary at the distance `other`, and the series converge.
    fn stays_inside(&self, r: f64, bound: f64, other: f64) -> f64 {
        let away = 2.0 * other / (r + (r * r + 2.0 * bound * other).sqrt());
        let until = (events::DEPARTURE_SPAN / self.signal.flight.rate()).min(self.horizon);
        until.min(if away.is_nan() { f64::INFINITY } else { away * (1.0 - events::BOUND_MARGIN) })
    }
}

fn clear(until: f64) -> Option<Departure> {
    (until > 0.0).then_some(Departure::Clear { until })
}

/// Coefficients of s(t)/tⁿ in the direction of the boundary, where n is the order of the first derivative that is not zero. The polynomial
/// is negative until the return.
struct Quotient {
    coefficients: [f64; TERMS + 1],
    /// Bounds on their rounding errors; the last one is that on the remainder.
    errors: [f64; TERMS + 2],
}

impl Quotient {
    /// That of `series`, whose derivative of order `first` has the size `leading`.
    fn of(series: &PowerSeries, (first, leading): (usize, f64), sign: f64) -> Self {
        let (mut coefficients, mut errors) = ([0.0; TERMS + 1], [0.0; TERMS + 2]);
        coefficients[0] = -leading / factorial(first);
        for k in first - 1..TERMS {
            coefficients[k + 2 - first] = sign * series.derivatives[k] / factorial(k + 2);
            errors[k + 2 - first] = series.rounding[k] / factorial(k + 2);
        }
        coefficients[0] = -leading / factorial(first);
        errors[0] = 0.0;
        errors[TERMS + 2 - first] = series.bound / factorial(TERMS + 2);
        Quotient { coefficients, errors }
    }

    /// The return within the time `until` \[s\].
    fn search(&self, side: Side, until: f64) -> Option<Departure> {
        let lowered = std::array::from_fn(|k| -self.coefficients.get(k).unwrap_or(&0.0) - self.errors[k]);
        match Bernstein::<{ TERMS + 2 }>::of(lowered, until).first(HALVINGS) {
            First::None => clear(until),
            First::Single(from, to) => match self.root(from * until, to * until) {
                // The remainder is below the rounding error of the quotient.
                Some(t) if self.remainder(t) <= events::DEPARTURE_REMAINDER * self.coefficients[0].abs() => {
                    Some(Departure::Returns { side, t })
                }
                _ => clear(from * until),
            },
            First::Open(from) => clear(from * until),
        }
    }

    /// Bound on the remainder at `t`.
    fn remainder(&self, t: f64) -> f64 {
        let last = self.errors.iter().rposition(|x| *x != 0.0).unwrap_or(0);
        self.errors[last] * t.powi(last as i32)
    }

    /// The quotient and its derivative.
    fn at(&self, t: f64) -> (f64, f64) {
        self.coefficients.iter().rev().fold((0.0, 0.0), |(y, slope), c| (y * t + c, slope * t + y))
    }

    /// The root in a bracket, by Newton's method; `None` if the polynomial has no sign change there.
    fn root(&self, mut low: f64, mut high: f64) -> Option<f64> {
        if self.at(high).0 <= 0.0 {
            return None;
        }
        let mut t = 0.5 * (low + high);
        for _ in 0..MOST_NEWTON {
            let (y, slope) = self.at(t);
            if y > 0.0 {
                high = t
            } else {
                low = t
            }
            let next = t - y / slope;
            if (next - t).abs() <= events::ROOT_ERROR * t {
                return Some(next);
            }
            let next = if next > low && next < high { next } else { 0.5 * (low + high) };
            t = next;
        }
        Some(t)
    }
}

fn factorial(n: usize) -> f64 {
    (1..=n).map(|i| i as f64).product()
}
