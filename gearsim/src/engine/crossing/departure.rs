//! A phase that leaves a boundary, and may be back soon: s(0) = 0 is a known root, and is divided out.
//!
//! The next root of s(t) is the first of
//!
//! ```text
//! s(t)/t = s'(0) + s''(0) t/2 + s'''(0) t²/6 + ...
//! ```
//!
//! as a polynomial with a bound on its remainder, over a time in which that is small. Its coefficients are known to roundings of
//! their own, s'(0) from the state: the return of a bounce is as exact as 2 s'(0)/s''(0) is, though the phase itself, the
//! sum of what its modes contribute, is known to roundings of these only.

use super::bernstein::{Bernstein, First};
use super::{Search, Side};
use crate::engine::cell::Point;
use crate::engine::signal::{Series, TERMS};
use crate::tolerance::events;

/// What becomes of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Departure {
    /// It is back.
    Back { side: Side, t: f64 },
    /// It meets nothing before this time.
    Clear { until: f64 },
}

/// Halvings to separate the return from what comes after.
const HALVINGS: u32 = 60;
/// Newton's steps to the return, at most.
const MOST_NEWTON: u32 = 60;

impl Search<'_> {
    /// Whether a phase that leaves a boundary is back soon; `None` where it does not leave one, or cannot be.
    pub(super) fn depart(&self, start: &Point) -> Option<Departure> {
        let (side, other) = match self.rate {
            r if r > 0.0 && self.down == 0.0 => (Side::Lower, self.up),
            r if r < 0.0 && self.up == 0.0 => (Side::Upper, self.down),
            _ => return None,
        };
        let (r, bound) = (self.rate.abs(), self.signal.bounds(start)[0]);
        // Before this it meets neither boundary.
        let away = 2.0 * other / (r + (r * r + 2.0 * bound * other).sqrt());
        let until = (events::DEPARTURE_SPAN / self.signal.flight.rate())
            .min(self.horizon)
            .min(away * (1.0 - events::BOUND_MARGIN));
        if !until.is_finite() || 2.0 * r / bound > until {
            return None;
        }
        let series = self.signal.series();
        let away = Away::new(-r, side.sign(), &series);
        match Bernstein::of(away.lowered(&series), until).first(HALVINGS) {
            First::None => Some(Departure::Clear { until }),
            First::Single(from, to) => match away.root(from * until, to * until) {
                // Beside what a rounding of the modes makes of s/t the remainder is nothing.
                Some(t) if away.remainder(&series, t) <= events::DEPARTURE_REMAINDER * r => {
                    Some(Departure::Back { side, t })
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

/// Coefficients of s(t)/t towards the boundary, negative until it is back.
struct Away([f64; TERMS + 1]);

impl Away {
    fn new(r: f64, sign: f64, series: &Series) -> Self {
        Away(std::array::from_fn(|k| if k == 0 { r } else { sign * series.derivatives[k - 1] / factorial(k + 1) }))
    }

    /// Those of -s(t)/t, lowered by what rounding and the remainder could take off.
    fn lowered(&self, series: &Series) -> [f64; TERMS + 2] {
        std::array::from_fn(|k| match k {
            0 => -self.0[0],
            k if k <= TERMS => -self.0[k] - series.rounding[k - 1] / factorial(k + 1),
            _ => -series.bound / factorial(k + 1),
        })
    }

    /// What the remainder may add at `t`.
    fn remainder(&self, series: &Series, t: f64) -> f64 {
        series.bound / factorial(TERMS + 2) * t.powi(TERMS as i32 + 1)
    }

    /// s(t)/t and its derivative.
    fn at(&self, t: f64) -> (f64, f64) {
        self.0.iter().rev().fold((0.0, 0.0), |(y, slope), c| (y * t + c, slope * t + y))
    }

    /// The root in a bracket, by Newton's method.
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
