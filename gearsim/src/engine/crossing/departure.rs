//! The return of a phase that has just left a boundary. The root s(0) = 0 is known and is divided out.
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
use crate::tolerance::events;

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
            _ => return None,
        };
        let (r, bound) = (self.rate.abs(), self.signal.bounds(start)[0]);
        // Before this time the phase cannot reach the other boundary.
        let away = 2.0 * other / (r + (r * r + 2.0 * bound * other).sqrt());
        let until = (events::DEPARTURE_SPAN / self.signal.flight.rate())
            .min(self.horizon)
            .min(away * (1.0 - events::BOUND_MARGIN));
        if !until.is_finite() || 2.0 * r / bound > until {
            return None;
        }
        let series = self.signal.series();
        let quotient = Quotient::new(-r, side.sign(), &series);
        match Bernstein::of(quotient.lowered(&series), until).first(HALVINGS) {
            First::None => Some(Departure::Clear { until }),
            First::Single(from, to) => match quotient.root(from * until, to * until) {
                // The remainder is below the rounding error of s/t.
                Some(t) if quotient.remainder(&series, t) <= events::DEPARTURE_REMAINDER * r => {
                    Some(Departure::Returns { side, t })
                }
                _ => clear(from * until),
            },
            First::Open(from) => clear(from * until),
        }
    }
}

fn clear(until: f64) -> Option<Departure> {
    (until > 0.0).then_some(Departure::Clear { until })
}

/// Coefficients of s(t)/t in the direction of the boundary. The polynomial is negative until the return.
struct Quotient([f64; TERMS + 1]);

impl Quotient {
    fn new(r: f64, sign: f64, series: &PowerSeries) -> Self {
        Quotient(std::array::from_fn(|k| if k == 0 { r } else { sign * series.derivatives[k - 1] / factorial(k + 1) }))
    }

    /// The coefficients of -s(t)/t, lowered by their rounding errors and by the remainder.
    fn lowered(&self, series: &PowerSeries) -> [f64; TERMS + 2] {
        std::array::from_fn(|k| match k {
            0 => -self.0[0],
            k if k <= TERMS => -self.0[k] - series.rounding[k - 1] / factorial(k + 1),
            _ => -series.bound / factorial(k + 1),
        })
    }

    /// Bound on the remainder of s(t)/t at `t`.
    fn remainder(&self, series: &PowerSeries, t: f64) -> f64 {
        series.bound / factorial(TERMS + 2) * t.powi(TERMS as i32 + 1)
    }

    /// s(t)/t and its derivative.
    fn at(&self, t: f64) -> (f64, f64) {
        self.0.iter().rev().fold((0.0, 0.0), |(y, slope), c| (y * t + c, slope * t + y))
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
