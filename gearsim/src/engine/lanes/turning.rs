//! The first crossing of a phase that may turn back, where a single vibration takes part in it: s(t) = d t + c (y(t) - y(0)), with the
//! steady speed d and y'' + 2 sigma y' + omega² y = 0.
//!
//! Between two zeros of s'' the sign of s'' is constant. In this interval the phase bends away from one boundary. It crosses this boundary
//! at most once while it approaches it; Newton's method from the beginning of the interval does not overshoot this root. It crosses the
//! other boundary at most once, on the way back; Newton's method from the end of the interval does not overshoot that root. The first
//! crossing is therefore found with certainty, interval by interval. |y'| is largest at the zeros of y'', and decreases from one zero to
//! the next. If |y'| is smaller than |d|/|c| at such a zero, the phase is monotone from there on, and has one crossing left. Intervals in
//! which the steady motion is too far from both boundaries are skipped: the vibration does not grow, so the phase cannot reach a boundary
//! there. Cases that rounding errors could decide, and phases with several vibrations, are left to the general loop.

mod phase;
mod search;
#[cfg(test)]
mod tests;

use crate::engine::lanes::Lanes;
use crate::engine::lanes::cells::Cells;
use crate::engine::lanes::flight::Flight;
use crate::engine::lanes::locate::Target;
use crate::engine::lanes::pack::{Mask, Pack};
use phase::Phase;

impl<const N: usize, const L: usize> Lanes<N, L> {
    /// Finds the crossings of the lanes `unsure`, whose phases may turn back, and writes them to `target`.
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
        Some(Phase { drift, part, sigma, omega2, per_omega2, w, v, a, start })
    }
}
