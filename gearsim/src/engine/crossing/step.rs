//! Steps that are proved not to pass a crossing.
//!
//! A boundary at distance f is approached at the rate r, with acceleration a and jerk j. With |s''| <= B2, |s'''| <= B3,
//! |s''''| <= B4 from here on, it is not reached while one of these is positive:
//!
//! ```text
//! f - r h - B2 h²/2        f - r h - a h²/2 - B3 h³/6        f - r h - a h²/2 - j h³/6 - B4 h⁴/24
//! ```
//!
//! The first root of the first has a closed form, of the second where the phase leaves at once (f = r = 0, a < 0). The last is
//! shown to be positive by its Bernstein coefficients ([`Bernstein`]), over up to [`REACH`] times the step that the others
//! give: where the actual acceleration is far below its bound it is what makes the march fast. It is lowered by what r, a
//! and j may be off by rounding, so that a proof that holds for the numbers holds for the phase, to a rounding of s.

use super::super::signal::Rounding;
use super::bernstein::{Bernstein, First};
use crate::tolerance::events::SINGLE_ROOT;

/// The last step is sought up to so many times the others.
const REACH: f64 = 64.0;
/// Halvings of that reach.
const HALVINGS: u32 = 8;

/// A boundary as it is approached.
#[derive(Debug, Clone, Copy)]
pub(super) struct Approach {
    /// Distance f, >= 0.
    pub gap: f64,
    /// Rate, acceleration and jerk towards it.
    pub r: f64,
    pub a: f64,
    pub j: f64,
    /// Bounds B2, B3, B4.
    pub bounds: [f64; 3],
    /// What r, a, j may be off.
    pub rounding: Rounding,
}

impl Approach {
    /// The earliest and latest time of the one root ahead, if there is proved to be one, simple, before anything else can
    /// happen; rounding of the gap does not make it one.
    pub fn single(&self, tolerance: f64) -> Option<(f64, f64)> {
        let Approach { gap, r, a, j, bounds: [b2, _, b4], .. } = *self;
        if r <= 0.0 {
            return None;
        }
        // Until the latest time |s''| is below this.
        let span = 2.0 * (gap + tolerance) / r;
        let bound = b2.min(a.abs() + span * (j.abs() + 0.5 * span * b4));
        (2.0 * bound * (gap + tolerance) < SINGLE_ROOT * r * r)
            .then(|| (2.0 * gap / (r + (r * r + 2.0 * bound * gap).sqrt()), 2.0 * gap / r))
    }

    /// A time for which it is not passed by more than `slack`; more than `enough` is not asked for.
    pub fn clear(self, slack: f64, enough: f64) -> f64 {
        let gap = self.gap + slack;
        let Approach { r, a, j, bounds: [b2, b3, b4], .. } = self;
        let root = (r * r + 2.0 * b2 * gap).sqrt();
        let second = if r > 0.0 {
            2.0 * gap / (r + root)
        } else if b2 > 0.0 {
            (root - r) / b2
        } else {
            f64::INFINITY
        };
        // Leaving it: what the first derivatives give outweighs the bound on the next.
        let leaving = |d: f64, bound: f64| if bound > 0.0 { -d / bound } else { f64::INFINITY };
        let third = if r <= 0.0 && a < 0.0 { 3.0 * leaving(a, b3) } else { 0.0 };
        let fourth = if r <= 0.0 && a <= 0.0 && j < 0.0 { 4.0 * leaving(j, b4) } else { 0.0 };
        let clear = second.max(third).max(fourth);
        if clear >= enough {
            return clear;
        }
        clear.max(Approach { gap, ..self }.further((REACH * clear).min(enough)))
    }

    /// The same by the polynomial of fourth order, at most `until`.
    fn further(&self, until: f64) -> f64 {
        let Approach { gap, r, a, j, bounds: [.., b4], rounding } = *self;
        let lowered =
            [gap, -r - rounding.rate, (-a - rounding.acceleration) / 2.0, (-j - rounding.jerk) / 6.0, -b4 / 24.0];
        match Bernstein::of(lowered, until).first(HALVINGS) {
            First::None => until,
            First::Single(from, _) | First::Open(from) => from * until,
        }
    }
}
