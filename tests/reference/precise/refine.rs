//! One crossing in a bracket, to all digits, by Newton's method, or by bisection where Newton leaves the bracket.
//!
//! The motion is computed in full once, near the crossing. From there it is computed over the very short remaining times, for which the
//! power series of the responses need only a few terms.

use super::cell::Motion;
use super::crossing::Surface;
use super::number::{Real, Scalar};
use super::rough::Rough;

/// A crossing and the states at it.
#[derive(Debug, Clone)]
pub struct Found<const BITS: usize> {
    /// its time \[s\]
    pub t: Real<BITS>,
    /// the level is touched and not crossed
    pub tangency: bool,
    /// xi and xi' of each mode
    pub states: Vec<(Real<BITS>, Real<BITS>)>,
}

/// The modes with their states at a time near the crossing.
struct Around<const BITS: usize> {
    t: Real<BITS>,
    motions: Vec<Motion<Real<BITS>>>,
}

impl<const BITS: usize> Surface<'_, BITS> {
    fn around(&self, t: &Real<BITS>) -> Around<BITS> {
        Around { t: t.clone(), motions: self.motions.iter().map(|m| m.moved(t)).collect() }
    }

    /// The crossing at `t`, with the states at `t`.
    pub(super) fn found(&self, t: Real<BITS>, tangency: bool) -> Found<BITS> {
        let states = self.motions.iter().map(|m| m.state(&t)).collect();
        Found { t, tangency, states }
    }

    /// The only crossing in (a, b\], where gap > 0 just after a and gap(b) <= 0. The iteration starts at `t`.
    pub(super) fn refine(&self, rough: &Rough, a: f64, b: Real<BITS>, mut t: Real<BITS>) -> Found<BITS> {
        let (mut left, mut right) = (Real::exact(a), b);
        let digits = BITS as i64 - 16;
        let close = 2f64.powi(-20) / rough.rate();
        let mut around: Option<Around<BITS>> = None;
        for _ in 0..4 * BITS {
            if !(t > left && t <= right) {
                t = (left.clone() + right.clone()).scaled(-1);
            }
            let near = around.take().filter(|n| (t.clone() - n.t.clone()).approx().abs() < close);
            let near = near.unwrap_or_else(|| self.around(&t));
            let moved = Surface { motions: &near.motions, level: self.level.clone(), sign: self.sign };
            let [gap, slope, bend] = moved.exact(&(t.clone() - near.t.clone()));
            let ended = |t: Real<BITS>| Found { t: t.clone(), ..moved.found(t - near.t.clone(), false) };
            if gap.is_zero() {
                return ended(t);
            }
            if gap.is_negative() {
                right = t.clone()
            } else {
                left = t.clone()
            }
            let width = right.clone() - left.clone();
            if width.magnitude() < t.magnitude() - digits {
                return ended(t);
            }
            let mut next = right.clone() - width.scaled(-1);
            if !slope.is_zero() {
                let (bent, steep) = (bend.magnitude(), slope.magnitude());
                let change = gap / slope;
                next = t.clone() - change.clone();
                // an estimate of Newton's next change, for quadratic convergence
                let rest = 2 * change.magnitude() + (bent - steep).max(-t.magnitude());
                if next > left && next <= right && rest < t.magnitude() - digits {
                    return ended(next);
                }
            }
            (t, around) = (next, Some(near));
        }
        panic!("Newton's iteration did not end between {a} and {}", right.approx())
    }
}
