//! The location of an event: the boundary that the phase meets, and the time of the crossing.

use crate::engine::lanes::Lanes;
use crate::engine::lanes::cells::Cells;
use crate::engine::lanes::expected::Expected;
use crate::engine::lanes::flight::{Flight, Point, responses};
use crate::engine::lanes::pack::{Mask, Pack};
use crate::tolerance::events::{BOUND_MARGIN, REVERSION_LIMIT, ROOT_ERROR};
use crate::tolerance::modes::{FAR_SHIFT_SPAN, KERNEL_ANGLE, SERIES_SPAN, SHIFT_SPAN};

/// The boundary that the phase of each lane meets.
pub struct Target<const L: usize> {
    /// Whether the boundary is certain: the phase is proved to be monotone, or its crossing was found.
    pub certain: Mask<L>,
    /// Whether the crossing was found for a phase that may turn back. `steady` is then its approximate time.
    pub found: Mask<L>,
    /// Whether the phase moves to the upper boundary.
    pub up: Mask<L>,
    /// 1 towards the upper boundary, -1 towards the lower one.
    pub sign: Pack<L>,
    pub boundary: Pack<L>,
    /// Distance to the boundary.
    pub gap: Pack<L>,
    /// Time to the boundary at the steady part of the speed [s].
    pub steady: Pack<L>,
}

/// Maximum number of evaluations of the motion. A lane that needs more is left to the general loop.
const MOST: usize = 3;

impl<const N: usize, const L: usize> Lanes<N, L> {
    /// The boundary to which the phase moves. It is certain if the phase is monotone. This is proved where the steady part of the speed
    /// exceeds an upper bound of the speed of the oscillations.
    #[inline(always)]
    pub(super) fn target(&self, cells: &Cells<N, L>, flight: &Flight<'_, N, L>) -> Target<L> {
        let (mut drift, mut oscillation, mut uniform) = (Pack::all(0.0), Pack::all(0.0), Mask::of(|_| true));
        for i in 0..N {
            let (c, v, a) = (cells.modes[i].part, flight.speed[i], flight.acceleration(i));
            if self.rigid[i] {
                drift = drift + c * v;
                uniform = uniform.and((c * a).compare(c, |a, _| a == 0.0));
            } else {
                oscillation = oscillation + c.abs() * (v.abs() + a.abs() * cells.modes[i].gain);
            }
        }
        let up = drift.compare(drift, |d, _| d > 0.0);
        let sign = Pack::all(1.0).or_uniform(up, Pack::all(-1.0));
        let boundary = cells.bounds[1].or_uniform(up, cells.bounds[0]);
        let gap = sign * (boundary - self.q[self.phase]);
        let monotone = uniform.and(drift.abs().compare(oscillation, |d, w| d > w * (1.0 + BOUND_MARGIN)));
        let found = Mask::of(|_| false);
        Target { certain: monotone, found, up, sign, boundary, gap, steady: gap / drift.abs() }
    }

    /// The time of the crossing, the modes at that time, and the number of evaluations: Newton's method from the predicted time.
    /// The result of a lane is that of its first converged step; further steps of other lanes do not change it.
    #[inline(always)]
    pub(super) fn locate(
        &self,
        cells: &Cells<N, L>,
        flight: &Flight<'_, N, L>,
        target: &Target<L>,
        expected: &Expected<N, L>,
        sure: Mask<L>,
    ) -> (Mask<L>, Pack<L>, [Point<L>; N], usize) {
        let guess =
            (target.steady + expected.lateness).zip(target.steady, |t, steady| if t > 0.0 { t } else { steady });
        let guess = target.steady.or(target.found, guess);
        let (mut t, mut near) = (expected.t, flight.all_after(&expected.responses));
        let away = guess - t;
        // The condition is also false for NaN.
        let near_enough = (away * cells.rate).compare(away, |angle, _| angle.abs() <= SHIFT_SPAN);
        let elsewhere = Mask::of(|_| true).without(near_enough.without(target.found));
        if elsewhere.intersects(sure) {
            near = self.moved(cells, flight, (t, &near), away, elsewhere, sure);
            t = (t + away).or(elsewhere, t);
        }
        let (mut points, mut taken, mut done, mut evaluations) = (near, t, Mask::of(|_| false), 0);
        for round in 1..=MOST {
            evaluations = round;
            let [s, r, a, jerk, snap] = self.signal(cells, flight, &near, target.sign);
            let f = target.gap - s;
            // The root of f - r dt - a dt²/2 - jerk dt³/6 - snap dt⁴/24 by reversion of the series.
            let inverse = 1.0 / r;
            let h = f * inverse;
            let (a, j) = (0.5 * a * inverse * h, (1.0 / 6.0) * jerk * inverse * h * h);
            let snap = (1.0 / 24.0) * snap * inverse * h * h * h;
            let dt = h * (1.0 - a + (2.0 * a * a - j) - (5.0 * a * (a * a - j) + snap));
            let angle = dt.abs() * cells.rate;
            let next = a * a + j.abs();
            let lacking = (14.0 * next * next + snap.abs() * (angle + 6.0 * a.abs())) * dt.abs();
            let good = angle
                .compare(a, |angle, a| (angle <= SHIFT_SPAN) & (a.abs() < REVERSION_LIMIT))
                .and(r.compare(r, |r, _| r > 0.0));
            let good = good.and(lacking.compare(t, |l, t| l <= ROOT_ERROR * t)).without(done);
            let shifted = flight.all_shifted(&self.rigid, &near, t, dt);
            for i in 0..N {
                points[i] = shifted[i].or(good, &points[i]);
            }
            taken = (t + dt).or(good, taken);
            done = done.with(good);
            if done.covers(sure) || round == MOST {
                break;
            }
            let dt = dt.zip(t, |dt, t| dt.max(-0.5 * t).min(t));
            near = self.moved(cells, flight, (t, &near), dt, Mask::of(|_| true), sure.without(done));
            t = t + dt;
        }
        let in_time = taken.compare(self.end - self.clock[0] - self.clock[1], |t, left| t < left);
        let angle = cells.rate * taken;
        let resolved = angle.compare(angle, |angle, _| (angle >= SERIES_SPAN) & (angle < KERNEL_ANGLE));
        // Newton's method must converge to the crossing that was found, not to another one.
        let beside = ((taken - guess) * cells.rate).compare(guess, |angle, _| angle.abs() <= 2.0 * SHIFT_SPAN);
        let sure = sure.and(done).and(in_time).and(resolved);
        (sure.without(target.found.without(beside)), taken, points, evaluations)
    }

    /// The modes in the lanes `moving` at the time `dt` [s] after a known time: by the series of the motion if `dt` is short, otherwise by
    /// its closed form. The choice is made for each lane separately. A form that none of the lanes `sure` needs is not computed.
    #[inline(always)]
    fn moved(
        &self,
        cells: &Cells<N, L>,
        flight: &Flight<'_, N, L>,
        (t, known): (Pack<L>, &[Point<L>; N]),
        dt: Pack<L>,
        moving: Mask<L>,
        sure: Mask<L>,
    ) -> [Point<L>; N] {
        // The condition is also false for NaN.
        let near = (dt * cells.rate).compare(dt, |angle, _| angle.abs() <= FAR_SHIFT_SPAN);
        let (by_series, anew) = (moving.and(near), moving.without(near));
        let mut points = *known;
        if by_series.intersects(sure) {
            let shifted = flight.all_shifted_far(&self.rigid, known, t, dt);
            for i in 0..N {
                points[i] = shifted[i].or(by_series, &points[i]);
            }
        }
        if anew.intersects(sure) {
            let evaluated = flight.all_after(&responses(cells, &self.rigid, t + dt));
            for i in 0..N {
                points[i] = evaluated[i].or(anew, &points[i]);
            }
        }
        points
    }

    /// Displacement of the phase towards its boundary, and its first four derivatives.
    #[inline(always)]
    fn signal(
        &self,
        cells: &Cells<N, L>,
        flight: &Flight<'_, N, L>,
        points: &[Point<L>; N],
        sign: Pack<L>,
    ) -> [Pack<L>; 5] {
        let mut sum = [Pack::all(0.0); 5];
        for i in 0..N {
            let c = sign * cells.modes[i].part;
            let [v, a, jerk, snap] = flight.derivatives(i, &points[i]);
            for (sum, x) in sum.iter_mut().zip([points[i].moved, v, a, jerk, snap]) {
                *sum = *sum + c * x;
            }
        }
        sum
    }
}
