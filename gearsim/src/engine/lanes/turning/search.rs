//! The search for the first crossing, interval by interval.

use super::phase::{Phase, PhasePoint};
use crate::tolerance::events::{BOUND_MARGIN, TURN_NEAR};
use crate::tolerance::modes::KERNEL_ANGLE;

/// The largest number of intervals, and of steps of Newton's method in one interval. Phases that need more are left to the general loop.
const MOST: (u32, u32) = (16, 16);

impl Phase {
    /// The first crossing: whether it is at the upper boundary, and its approximate time \[s\]. `gaps` are the distances to the lower and
    /// the upper boundary, `fastest` bounds the rates, and the run ends after the time `left` \[s\].
    #[inline(never)]
    pub(super) fn first(&self, gaps: [f64; 2], fastest: f64, left: f64) -> Option<(bool, f64)> {
        let size = (self.a[0] * self.a[0] + self.a[1] * self.a[1]).sqrt();
        let bends = self.part * if self.a[0] == 0.0 { self.a[1] } else { self.a[0] };
        if !(size > 0.0 && size.is_finite() && bends != 0.0) {
            return None;
        }
        // cos wt and sin wt at the first zero of y''.
        let turn = if self.a[0] == 0.0 {
            [-1.0, 0.0]
        } else {
            [-self.a[1] * self.a[0].signum() / size, self.a[0].abs() / size]
        };
        let half = std::f64::consts::PI / self.w;
        let (rate, v, a) = (self.drift + self.part * self.v[0], self.v[0], self.a[0]);
        let mut from = PhasePoint { t: 0.0, s: 0.0, rate, v, a, size: 0.0, decay: 1.0 };
        let (mut t, mut sign, mut up) = (turn[1].atan2(turn[0]) / self.w, 1.0, bends < 0.0);
        for _ in 0..MOST.0 {
            if fastest * t > KERNEL_ANGLE {
                return None;
            }
            let to = self.bent(t, sign * turn[0], sign * turn[1]);
            match self.within(from, to, (up, size * self.part.abs()), gaps, fastest)? {
                Some(found) => return Some(found),
                None if to.t > left => return None,
                None if self.drift.abs() > (to.rate - self.drift).abs() * (1.0 + BOUND_MARGIN) => {
                    return self.last(to, gaps, fastest);
                }
                None => {}
            }
            from = to;
            let halves = self.halves_out_of_reach(&to, gaps, half);
            if halves > 0.0 {
                t += halves * half;
                if halves % 2.0 == 1.0 {
                    (sign, up) = (-sign, !up);
                }
                from = self.bent(t, sign * turn[0], sign * turn[1]);
            }
            (t, sign, up) = (t + half, -sign, !up);
        }
        None
    }

    /// Number of half vibrations after `here` in which the phase cannot reach a boundary. The vibration does not grow: its amplitude here
    /// is an upper bound for all later times.
    #[inline(always)]
    fn halves_out_of_reach(&self, here: &PhasePoint, gaps: [f64; 2], half: f64) -> f64 {
        // y = e (start C - lag S).
        let lag = (self.a[1] + 2.0 * self.sigma * self.v[1]) * self.per_omega2;
        let swing = self.part.abs() * here.decay * (self.start * self.start + lag * lag).sqrt();
        let margin = swing + TURN_NEAR * (gaps[0] + gaps[1] + here.size);
        let up = self.drift > 0.0;
        let (mirror, way) = (if up { 1.0 } else { -1.0 }, self.drift.abs());
        let [ahead, behind] = if up { [gaps[1], gaps[0]] } else { gaps };
        let centre = -mirror * self.part * self.start;
        if behind + centre + way * here.t <= margin {
            return 0.0;
        }
        (((ahead - centre - margin) / way - here.t) / half).floor().max(0.0)
    }

    /// The crossing of a phase that is monotone after `from`, which lies between the boundaries.
    #[inline(always)]
    fn last(&self, from: PhasePoint, gaps: [f64; 2], fastest: f64) -> Option<(bool, f64)> {
        let up = self.drift > 0.0;
        let mirror = if up { 1.0 } else { -1.0 };
        let edge = gaps[usize::from(up)];
        let mut t = from.t + (edge - mirror * from.s) / self.drift.abs();
        for _ in 0..MOST.1 {
            if !(from.t..=KERNEL_ANGLE / fastest).contains(&t) {
                return None;
            }
            let place = self.at(t);
            let step = self.step(&place, mirror * edge, fastest);
            if let Some(root) = step.root {
                return Some((up, t + root));
            }
            t += step.newton;
        }
        None
    }

    /// The crossing within an interval in which the phase bends away from the upper boundary (`up`) or from the lower one, with |s''| <=
    /// `bend`. `None` if rounding errors could decide it; `Some(None)` if there is no crossing.
    #[inline(always)]
    fn within(
        &self,
        from: PhasePoint,
        to: PhasePoint,
        (up, bend): (bool, f64),
        gaps: [f64; 2],
        fastest: f64,
    ) -> Option<Option<(bool, f64)>> {
        let mirror = if up { 1.0 } else { -1.0 };
        let [edge, other] = if up { [gaps[1], gaps[0]] } else { gaps };
        let near = TURN_NEAR * (gaps[0] + gaps[1] + to.size);
        let (end, rate) = (mirror * to.s, mirror * from.rate);
        if (end - edge).abs() <= near || (end + other).abs() <= near {
            return None;
        }
        // The phase does not go beyond `peak`, where the tangents at both ends of the interval intersect.
        let start = mirror * from.s;
        let peak = start + rate * (end - start - mirror * to.rate * (to.t - from.t)) / (rate - mirror * to.rate);
        if rate > 0.0 && (end > edge || peak > edge - near) {
            // The phase moves towards the edge and bends away from it. It crosses the edge if the interval ends beyond the edge, or if
            // Newton's method finds a root.
            let mut place = from;
            for i in 0.. {
                let speed = mirror * place.rate;
                let gap = edge - mirror * place.s;
                if speed <= 0.0 || place.t > to.t {
                    break;
                }
                let step = self.step(&place, mirror * edge, fastest);
                // With |s''| <= `bend` the phase still rises by speed²/(2 bend) or more.
                if let Some(root) = step.root
                    && (end > edge || speed * speed >= 4.0 * gap * bend)
                {
                    return Some(Some((up, place.t + root)));
                }
                if i == MOST.1 {
                    return None;
                }
                place = self.at(place.t + step.newton);
            }
        }
        if end > -other {
            // The interval ends before the other boundary. A crossing of the edge was found above.
            return if end > edge { None } else { Some(None) };
        }
        let mut place = to;
        for _ in 0..MOST.1 {
            let speed = mirror * place.rate;
            let beyond = mirror * place.s + other;
            if speed >= 0.0 || beyond > near {
                return None;
            }
            let step = self.step(&place, -mirror * other, fastest);
            if let Some(root) = step.root {
                return Some(Some((!up, place.t + root)));
            }
            place = self.at(place.t + step.newton);
        }
        None
    }
}
