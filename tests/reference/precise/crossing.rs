//! The first time at which a sum of modes reaches a level. Bounds and convexity guarantee that no crossing is missed.
//!
//! gap(t) = level - sum weight_i xi_i(t) is positive at the start, or 0 and rising. The time interval is bisected, the earlier
//! half first, until in each piece \[a, b\] with midpoint m and half width r the Taylor form
//!
//! ```text
//! gap(m + s) in gap(m) + gap'(m) s + gap''(m) s^2/2 +- M3 r^3/6,   |s| <= r,   |gap'''| <= M3
//! ```
//!
//! (and the same for gap', gap'') shows that gap is positive, monotone, convex or concave. Then the values of gap at the ends, and at
//! its only minimum, decide. M3 is valid for all times after a, because (xi''')^2 + omega2 (xi'')^2 never grows in a damped mode.
//! Values are `f64` with a bound on their rounding errors. Where that bound leaves the decision open, they are computed with `BITS` bits.

use super::cell::{Law, Mode, Motion};
use super::judge::{Local, Verdict, judge};
use super::number::{Real, Scalar};
use super::refine::Found;
use super::rough::Rough;

/// A first crossing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Root {
    /// its time \[s\], as a sum of two numbers
    pub t: (f64, f64),
    /// gap' at the crossing
    pub slope: f64,
    /// the level is touched, to all computed digits, and not crossed
    pub tangency: bool,
    /// the smallest minimum of the gap before the crossing, to 1 %: how narrowly an earlier crossing was missed. Minima that were
    /// excluded at once do not count. Infinite if there was none
    pub near_miss: f64,
}

/// The first crossing in all digits, if there is one, and the smallest minimum of the gap before it.
#[derive(Debug, Clone)]
pub struct Crossing<const BITS: usize> {
    /// the crossing: time, states, whether it is a tangency
    pub root: Option<Found<BITS>>,
    /// see [`Root::near_miss`]
    pub near_miss: f64,
}

/// The gap of one surface.
pub struct Surface<'a, const BITS: usize> {
    /// the modes
    pub motions: &'a [Motion<Real<BITS>>],
    /// the level they are compared with
    pub level: Real<BITS>,
    /// 1: gap = level - sum, -1: gap = sum - level
    pub sign: f64,
}

impl<const BITS: usize> Surface<'_, BITS> {
    /// gap, gap', gap'' at time `t` in all digits.
    pub(super) fn exact(&self, t: &Real<BITS>) -> [Real<BITS>; 3] {
        let zero = || Real::exact(0.0);
        let mut sum = [self.level.clone(), zero(), zero()];
        for m in self.motions {
            let [x, v, a] = m.at(t);
            for (sum, term) in sum.iter_mut().zip([x, v, a]) {
                *sum = sum.clone() - m.weight.clone() * term;
            }
        }
        if self.sign < 0.0 { sum.map(|x| -x) } else { sum }
    }

    fn exact_local(&self, t: f64) -> Local {
        let gap = self.exact(&Real::exact(t)).map(|x| x.approx());
        Local { gap, error: gap.map(|x| x.abs() * 1e-15) }
    }

    /// The first crossing in \[0, `t_max`\] \[s\].
    pub fn first_crossing(&self, t_max: f64) -> Crossing<BITS> {
        let rough = Rough::new(self);
        let mut search = Search { surface: self, rough, near_miss: f64::INFINITY };
        let root = search.run(t_max);
        Crossing { root, near_miss: search.near_miss }
    }
}

struct Search<'a, const BITS: usize> {
    surface: &'a Surface<'a, BITS>,
    rough: Rough,
    near_miss: f64,
}

impl<const BITS: usize> Search<'_, BITS> {
    fn run(&mut self, t_max: f64) -> Option<Found<BITS>> {
        let start = self.surface.exact(&Real::exact(0.0));
        let leading = start.iter().find(|x| !x.is_zero());
        if leading.is_some_and(Real::is_negative) {
            return Some(self.surface.found(Real::exact(0.0), false));
        }
        if t_max <= 0.0 || self.rough.rises(t_max) {
            return None;
        }
        if self.rough.falls(t_max) {
            return self.end(0.0, t_max);
        }
        let mut pieces = vec![(0.0, t_max, self.rough.third(0.0))];
        while let Some((a, b, third)) = pieces.pop() {
            let (m, r) = (0.5 * (a + b), 0.5 * (b - a) * (1.0 + 1e-15));
            let rough = self.rough.local(m);
            let mut verdict = judge(&rough, third, r);
            let exhausted = m <= a || m >= b;
            if matches!(verdict, Verdict::Open) && (third * r < rough.error[2] || exhausted) {
                verdict = judge(&self.surface.exact_local(m), third, r);
            }
            let found = match verdict {
                Verdict::Positive => None,
                Verdict::Falling | Verdict::Concave => self.end(a, b),
                Verdict::Convex => self.minimum(a, b),
                Verdict::Open => {
                    assert!(!exhausted, "undecided at t = {a}: {:?}", self.surface.exact_local(m));
                    pieces.push((m, b, self.rough.third(m).min(third)));
                    pieces.push((a, m, third));
                    None
                }
            };
            if found.is_some() {
                return found;
            }
        }
        None
    }

    /// The crossing in (a, b] of a gap that is positive just after a, and that has one crossing if and only if it is negative at b.
    fn end(&mut self, a: f64, b: f64) -> Option<Found<BITS>> {
        let rough = self.rough.local(b);
        let below = match rough.gap[0] {
            g if g > rough.error[0] => false,
            g if g < -rough.error[0] => true,
            _ => self.surface.exact(&Real::exact(b))[0] <= Real::exact(0.0),
        };
        below.then(|| self.refine(a, Real::exact(b), None))
    }

    /// The crossing in (a, b] of a convex gap that is positive just after a.
    fn minimum(&mut self, a: f64, b: f64) -> Option<Found<BITS>> {
        let (mut left, mut right, mut t) = (a, b, 0.5 * (a + b));
        for _ in 0..60 {
            let at = self.rough.local(t);
            if at.gap[0] < -at.error[0] {
                return Some(self.refine(a, Real::exact(t), None));
            }
            // a convex gap lies above its tangent
            let slope = at.gap[1].abs() + at.error[1];
            if at.gap[0] - at.error[0] - slope * (b - a) > 0.99 * at.gap[0] {
                self.near_miss = self.near_miss.min(at.gap[0]);
                return None;
            }
            if at.gap[1].abs() <= at.error[1] {
                break;
            }
            if at.gap[1] < 0.0 {
                left = t
            } else {
                right = t
            }
            let newton = t - at.gap[1] / at.gap[2];
            let next = if newton >= left && newton <= right { newton } else { 0.5 * (left + right) };
            if next == t {
                break;
            }
            t = next;
        }
        self.exact_minimum(a, b, t)
    }

    fn exact_minimum(&mut self, a: f64, b: f64, guess: f64) -> Option<Found<BITS>> {
        let zero = Real::exact(0.0);
        let (mut left, mut right) = (Real::exact(a), Real::exact(b));
        if self.surface.exact(&left)[1] >= zero {
            return None;
        }
        if self.surface.exact(&right)[1] <= zero {
            return self.end(a, b);
        }
        let mut t = Real::exact(guess);
        let digits = BITS as i64 - 30;
        loop {
            let [gap, slope, bend] = self.surface.exact(&t);
            if gap.is_negative() && gap.magnitude() > self.rough.magnitude() - digits {
                let near = (gap.scaled(1) / bend).abs().root();
                let start = if slope.is_negative() { t.clone() - near.clone() } else { t.clone() - near };
                return Some(self.refine(a, t, Some(start)));
            }
            if slope.is_negative() {
                left = t.clone()
            } else {
                right = t.clone()
            }
            let mut next = t.clone() - slope / bend;
            if !(next >= left && next <= right) {
                next = (left.clone() + right.clone()).scaled(-1);
            }
            let change = next.clone() - t.clone();
            // the minimum is flat: with half of the digits of its time the height has all digits
            if change.is_zero() || change.magnitude() < t.magnitude() - digits / 2 - 10 {
                let gap = self.surface.exact(&next)[0].clone();
                if gap.magnitude() <= self.rough.magnitude() - digits {
                    return Some(self.surface.found(next, true));
                }
                if gap.is_negative() {
                    return Some(self.refine(a, next, None));
                }
                self.near_miss = self.near_miss.min(gap.approx());
                return None;
            }
            t = next;
        }
    }

    fn refine(&self, a: f64, b: Real<BITS>, guess: Option<Real<BITS>>) -> Found<BITS> {
        let guess = guess.unwrap_or_else(|| Real::exact(self.rough.root(a, b.approx())));
        self.surface.refine(&self.rough, a, b, guess)
    }
}

/// A mode in all digits.
pub(super) fn prepared<const BITS: usize>(m: &Mode) -> Motion<Real<BITS>> {
    let law = Law::new(Real::exact(m.sigma), Real::exact(m.omega2));
    let [force, x, v, weight] = [m.force, m.x, m.v, m.weight].map(Real::exact);
    Motion::new(law, force, x, v, weight)
}

/// The first time in \[0, `t_max`\] \[s\] at which sum weight_i xi_i reaches `level` from below, to `BITS` bits.
///
/// A start beyond the level, or on it and moving beyond it, is a crossing at 0. Panics unless sigma and omega2 are at least
/// 0 and all numbers are finite.
pub fn first_crossing_with<const BITS: usize>(modes: &[Mode], level: f64, t_max: f64) -> Crossing<BITS> {
    let motions = modes.iter().map(prepared::<BITS>).collect::<Vec<_>>();
    Surface { motions: &motions, level: Real::exact(level), sign: 1.0 }.first_crossing(t_max)
}

/// [`first_crossing_with`] 50 digits. The inputs are taken as exact binary numbers.
pub fn first_crossing(modes: &[Mode], level: f64, t_max: f64) -> Option<Root> {
    let found = first_crossing_with::<192>(modes, level, t_max);
    let Found { t, tangency, states } = found.root?;
    let slope = -modes.iter().zip(states).map(|(m, (_, v))| m.weight * v.approx()).sum::<f64>();
    Some(Root { t: t.pair(), slope, tangency, near_miss: found.near_miss })
}
