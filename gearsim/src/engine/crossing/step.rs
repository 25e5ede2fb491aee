//! Steps that are proved to contain no crossing.
//!
//! A boundary at the distance f is approached at the rate r, with the acceleration a and the jerk j. The derivatives are bounded
//! from here on: |s''| <= B2, |s'''| <= B3, |s''''| <= B4. The boundary is not reached after the time h while one of these is
//! positive:
//!
//! ```text
//! f - r h - B2 h²/2        f - r h - a h²/2 - B3 h³/6        f - r h - a h²/2 - j h³/6 - B4 h⁴/24
//! ```
//!
//! The first root of the first polynomial has a closed form. If the phase moves away (r <= 0), a lower bound of the first root of the
//! second (a < 0) and of the third (a <= 0, j < 0) has a closed form too. Beyond these times the third polynomial is proved to be positive
//! by its Bernstein coefficients ([`Bernstein`]), over up to [`REACH`] times this step. It gives long steps where the acceleration is far
//! below its bound. Its coefficients are lowered by the rounding errors of r, a and j. The proof then holds for the phase, to one rounding
//! error of s.

use super::super::signal::Rounding;
use super::bernstein::{Bernstein, First};
use crate::tolerance::events::SINGLE_ROOT;

/// Maximum length of the step proved by Bernstein coefficients, relative to the step in closed form.
const REACH: f64 = 64.0;
/// Maximum number of bisections of this length.
const HALVINGS: u32 = 8;

/// The approach to a boundary at one instant.
#[derive(Debug, Clone, Copy)]
pub(super) struct Approach {
    /// Distance f, >= 0.
    pub gap: f64,
    /// Rate, acceleration and jerk in the direction of the boundary.
    pub r: f64,
    pub a: f64,
    pub j: f64,
    /// Bounds B2, B3, B4 on the derivatives.
    pub bounds: [f64; 3],
    /// Rounding errors of r, a and j.
    pub rounding: Rounding,
}

impl Approach {
    /// The earliest and the latest time of the next root, if it is proved to be simple and the only one before the latest time. A
    /// rounding error of the gap does not count as a root.
    pub fn single(&self, tolerance: f64) -> Option<(f64, f64)> {
        let Approach { gap, r, a, j, bounds: [b2, _, b4], .. } = *self;
        if r <= 0.0 {
            return None;
        }
        // Bound on |s''| until the latest time.
        let span = 2.0 * (gap + tolerance) / r;
        let bound = b2.min(a.abs() + span * (j.abs() + 0.5 * span * b4));
        (2.0 * bound * (gap + tolerance) < SINGLE_ROOT * r * r)
            .then(|| (2.0 * gap / (r + (r * r + 2.0 * bound * gap).sqrt()), 2.0 * gap / r))
    }

    /// A time during which the boundary is not passed by more than `slack` [s]. A time longer than `enough` is not sought.
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
        // If the phase moves away, the second polynomial is positive up to h = 3 |a|/B3, and the third up to h = 4 |j|/B4.
        let leaving = |d: f64, bound: f64| if bound > 0.0 { -d / bound } else { f64::INFINITY };
        let third = if r <= 0.0 && a < 0.0 { 3.0 * leaving(a, b3) } else { 0.0 };
        let fourth = if r <= 0.0 && a <= 0.0 && j < 0.0 { 4.0 * leaving(j, b4) } else { 0.0 };
        let clear = second.max(third).max(fourth);
        if clear >= enough {
            return clear;
        }
        clear.max(Approach { gap, ..self }.further((REACH * clear).min(enough)))
    }

    /// The same by the Bernstein coefficients of the third polynomial, which has degree 4; at most `until`.
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
