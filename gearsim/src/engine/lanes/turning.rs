//! The first crossing of a phase that may turn back, where a single vibration takes part in it: s(t) = d t + c (y(t) - y(0)), with the
//! steady speed d and y'' + 2 sigma y' + omega² y = 0.
//!
//! Between two zeros of s'' the sign of s'' is constant. There the phase crosses the boundary from which it bends away at most once, on the
//! way to it; Newton's method from the beginning of the interval does not overshoot this root. It crosses the other boundary at most once,
//! on the way back; Newton's method from the end of the interval does not overshoot that root. The first crossing is therefore found with
//! certainty, interval by interval. |y'| is largest at the zeros of y'', and falls from one to the next: as soon as it is smaller than |d|/|c|
//! there, the phase is monotone from then on, and has one crossing left. Cases that rounding errors could decide, and phases with several
//! vibrations, are left to the general loop.

use crate::engine::lanes::Lanes;
use crate::engine::lanes::cells::Cells;
use crate::engine::lanes::elementary::{exp_m1, sin_cos};
use crate::engine::lanes::flight::Flight;
use crate::engine::lanes::locate::Target;
use crate::engine::lanes::pack::{Mask, Pack};
use crate::tolerance::events::{BOUND_MARGIN, TURN_NEAR, TURN_STEP};
use crate::tolerance::modes::KERNEL_ANGLE;

#[cfg(test)]
mod tests;

/// Most intervals, and most steps of Newton's method in one. Phases that need more are left to the general loop.
const MOST: (u32, u32) = (16, 16);

/// The phase from the start of a flight on.
struct Phase {
    /// d.
    drift: f64,
    /// c.
    part: f64,
    sigma: f64,
    /// 1/omega².
    per_omega2: f64,
    w: f64,
    /// y' = e (v C + v_s S) and y'' = e (a C + a_s S), with e = e^{-sigma t}, C = cos wt, S = sin wt.
    v: [f64; 2],
    a: [f64; 2],
    /// y(0).
    start: f64,
}

/// A time, s and s' there, and the size of the terms of s.
#[derive(Clone, Copy)]
struct Place {
    t: f64,
    s: f64,
    rate: f64,
    size: f64,
}

impl<const N: usize, const L: usize> Lanes<N, L> {
    /// Finds the crossings of the lanes `unsure`, whose phases may turn back, and notes them in the target.
    #[inline(always)]
    pub(super) fn turn(&self, cells: &Cells<N, L>, flight: &Flight<'_, N, L>, target: &mut Target<L>, unsure: Mask<L>) {
        for lane in (0..L).filter(|lane| unsure.is_set(*lane)) {
            let place = self.q[self.phase].0[lane];
            let gaps = [place - cells.bounds[0].0[lane], cells.bounds[1].0[lane] - place];
            let left = self.end.0[lane] - self.clock[0].0[lane];
            let Some(phase) = self.turning(cells, flight, lane) else { continue };
            let here = Mask::of(|i| i == lane);
            if phase.is_monotone() {
                target.certain = target.certain.with(here);
                continue;
            }
            let Some((up, t)) = phase.first(gaps, cells.rate.0[lane], left) else { continue };
            let side = usize::from(up);
            target.certain = target.certain.with(here);
            target.found = target.found.with(here);
            target.up = if up { target.up.with(here) } else { target.up.without(here) };
            target.sign.0[lane] = if up { 1.0 } else { -1.0 };
            target.boundary.0[lane] = cells.bounds[side].0[lane];
            target.gap.0[lane] = gaps[side];
            target.steady.0[lane] = t;
        }
    }

    /// The phase of a lane; `None` if it does not have one vibration beside the steady motion.
    #[inline(always)]
    fn turning(&self, cells: &Cells<N, L>, flight: &Flight<'_, N, L>, lane: usize) -> Option<Phase> {
        let (mut drift, mut only) = (0.0, None);
        for i in 0..N {
            let (c, v) = (cells.modes[i].part.0[lane], flight.speed[i].0[lane]);
            let a = flight.acceleration(i).0[lane];
            if c == 0.0 {
                continue;
            }
            match (self.rigid[i], only) {
                (true, _) if a == 0.0 => drift += c * v,
                (false, None) => only = Some((i, c, v, a)),
                _ => return None,
            }
        }
        let (i, part, v, a) = only?;
        let mode = &cells.modes[i];
        let of = |x: &Pack<L>| x.0[lane];
        let (sigma, omega2, per_omega2) = (of(&mode.sigma), of(&mode.omega2), of(&mode.per_omega2));
        let (w, per_w) = (of(&mode.w), of(&mode.per_w));
        let jerk = -2.0 * sigma * a - omega2 * v;
        let (v, a) = ([v, (a + sigma * v) * per_w], [a, (jerk + sigma * a) * per_w]);
        let start = -(a[0] + 2.0 * sigma * v[0]) * per_omega2;
        Some(Phase { drift, part, sigma, per_omega2, w, v, a, start })
    }
}

impl Phase {
    /// Whether the steady speed exceeds the largest speed of the vibration: then the phase never turns back.
    #[inline(always)]
    fn is_monotone(&self) -> bool {
        let fastest = (self.v[0] * self.v[0] + self.v[1] * self.v[1]).sqrt();
        self.drift.abs() > self.part.abs() * fastest * (1.0 + BOUND_MARGIN)
    }

    /// The first crossing: whether it is at the upper boundary, and its approximate time \[s\]. `gaps` are the distances to the lower and
    /// the upper boundary, `fastest` bounds the rates, and the run ends after the time `left` \[s\].
    #[inline(never)]
    fn first(&self, gaps: [f64; 2], fastest: f64, left: f64) -> Option<(bool, f64)> {
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
        let mut from = Place { t: 0.0, s: 0.0, rate: self.drift + self.part * self.v[0], size: 0.0 };
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
                None => (from, t, sign, up) = (to, t + half, -sign, !up),
            }
        }
        None
    }

    /// The crossing of a phase that is monotone after `from`, which lies between the boundaries.
    #[inline(always)]
    fn last(&self, from: Place, gaps: [f64; 2], fastest: f64) -> Option<(bool, f64)> {
        let up = self.drift > 0.0;
        let mirror = if up { 1.0 } else { -1.0 };
        let edge = gaps[usize::from(up)];
        let mut t = from.t + (edge - mirror * from.s) / self.drift.abs();
        for _ in 0..MOST.1 {
            if !(from.t..=KERNEL_ANGLE / fastest).contains(&t) {
                return None;
            }
            let place = self.at(t);
            let step = (edge - mirror * place.s) / (mirror * place.rate);
            t += step;
            if step.abs() * fastest <= TURN_STEP {
                return Some((up, t));
            }
        }
        None
    }

    /// The crossing within an interval in which the phase bends away from the upper boundary (`up`) or from the lower one, with |s''| <=
    /// `bend`. `None` if rounding errors could decide it.
    #[inline(always)]
    fn within(
        &self,
        from: Place,
        to: Place,
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
        if rate > 0.0 {
            // Towards the edge, from which the phase bends away. The phase crosses it if the interval ends beyond it, or if Newton's method
            // finds a root.
            let mut place = from;
            for i in 0.. {
                let speed = mirror * place.rate;
                let gap = edge - mirror * place.s;
                if speed <= 0.0 || place.t > to.t {
                    break;
                }
                let step = gap / speed;
                // With |s''| <= `bend` the phase still rises by speed²/(2 bend) or more.
                if step.abs() * fastest <= TURN_STEP && (end > edge || speed * speed >= 4.0 * gap * bend) {
                    return Some(Some((up, place.t + step)));
                }
                if i == MOST.1 {
                    return None;
                }
                place = self.at(place.t + step);
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
            let step = -beyond / speed;
            if -step * fastest <= TURN_STEP {
                return Some(Some((!up, place.t + step)));
            }
            place = self.at(place.t + step);
        }
        None
    }

    /// The phase at a time.
    #[inline(always)]
    fn at(&self, t: f64) -> Place {
        let (sine, cosine) = sin_cos(Pack([self.w * t]));
        self.placed(t, cosine.0[0], sine.0[0], self.a)
    }

    /// The phase at a zero of y'', where cos wt and sin wt are known.
    #[inline(always)]
    fn bent(&self, t: f64, cosine: f64, sine: f64) -> Place {
        self.placed(t, cosine, sine, [0.0; 2])
    }

    #[inline(always)]
    fn placed(&self, t: f64, cosine: f64, sine: f64, a: [f64; 2]) -> Place {
        let e = 1.0 + exp_m1(Pack([-(self.sigma * t)])).0[0];
        let v = e * (self.v[0] * cosine + self.v[1] * sine);
        let a = e * (a[0] * cosine + a[1] * sine);
        let y = -(a + 2.0 * self.sigma * v) * self.per_omega2;
        let way = self.drift * t;
        Place {
            t,
            s: way + self.part * (y - self.start),
            rate: self.drift + self.part * v,
            size: way.abs() + self.part.abs() * (y.abs() + self.start.abs()),
        }
    }
}
