//! The search for a crossing if the phase may reverse. It advances by steps that are proved to contain no crossing, until one
//! simple root is proved to lie ahead, or the phase is at a boundary and passes it.

use super::departure::Departure;
use super::step::Approach;
use super::{Cost, Search, SearchError, Side};
use crate::engine::cell::Point;
use crate::tolerance::events::SEARCH_STEPS;

/// Time for which the motion is bounded [time until the horizon]. A root that is proved to be the only one of its bracket is then before the
/// horizon, or the bracket is within this time: it ends at most at 1 + sqrt(1.99) times its begin ([`Approach::single`]).
const SINGLE_SPAN: f64 = 2.5;

impl Search<'_> {
    /// Advances by steps that contain no crossing.
    pub(super) fn march(&self, point: &mut Point, cost: &mut Cost) -> Result<Option<Side>, SearchError> {
        match self.depart(point) {
            Some(Departure::Returns { side, t }) => {
                self.go(point, t, cost);
                return Ok((t < self.horizon).then_some(side));
            }
            Some(Departure::Clear { until }) => self.go(point, until, cost),
            None => {}
        }
        let tolerance = self.tolerance();
        let mut approached = [false; 2];
        for _ in 0..SEARCH_STEPS {
            cost.steps += 1;
            let t = point.t;
            let [moved, rates @ ..] = self.signal.derivatives(point);
            let bounds = self.signal.bounds(point, SINGLE_SPAN * (self.horizon - t));
            if bounds.iter().chain(&rates).any(|x| !x.is_finite()) {
                return Err(SearchError::Overflow);
            }
            let rounding = self.signal.rounding(point);
            let reach = self.signal.reach(point);
            let slack = 0.5 * tolerance.max(rounding.value);
            let mut h = f64::INFINITY;
            for (i, (side, full)) in self.sides().into_iter().enumerate() {
                if full.is_infinite() {
                    continue;
                }
                let sign = side.sign();
                let (r, a, j) = (sign * rates[0], sign * rates[1], sign * rates[2]);
                let gap = full - sign * moved;
                if gap <= tolerance && r >= 0.0 && (r > 0.0 || a > 0.0) {
                    // At the boundary, within the tolerance: the phase passes it, or reverses within the tolerance.
                    let turns = a + rounding.acceleration < 0.0;
                    if !turns || gap + r * r / (2.0 * a) <= -tolerance {
                        return Ok(self.at_boundary(side, full, [gap, r, a], rounding.value, point, cost));
                    }
                    cost.grazes += 1;
                    approached[i] = false;
                    h = h.min(2.0 * (r + (2.0 * tolerance * a.abs()).sqrt()) / a.abs());
                    continue;
                }
                // The phase reversed between two steps. If it came within the tolerance of the boundary, this was a graze.
                if approached[i] && r < 0.0 && gap <= tolerance + r * r / (2.0 * a.abs()) {
                    cost.grazes += 1;
                }
                approached[i] = r > 0.0;
                let approach = Approach { gap: gap.max(0.0), r, a, j, bounds, rounding };
                if let Some((earliest, latest)) = approach.single(tolerance) {
                    if earliest > self.horizon - t {
                        continue;
                    }
                    let bracket = (t + 0.5 * approach.gap / r, t + latest);
                    self.go(point, t + approach.gap / r, cost);
                    return Ok(self.newton(side, full, bracket, point, cost));
                }
                let safe = reach.time(approach.gap, sign);
                if safe < h {
                    h = h.min(safe.max(approach.clear(slack, self.horizon - t)));
                }
            }
            let next = t + h;
            if next >= self.horizon {
                return Ok(None);
            }
            self.go(point, if next > t { next } else { t.next_up() }, cost);
        }
        Err(SearchError::Stuck(SEARCH_STEPS))
    }

    fn sides(&self) -> [(Side, f64); 2] {
        [(Side::Upper, self.up), (Side::Lower, self.down)]
    }

    /// The crossing of a phase that is at the boundary within the tolerance, before it or beyond it.
    fn at_boundary(
        &self,
        side: Side,
        full: f64,
        [gap, r, a]: [f64; 3],
        rounding: f64,
        point: &mut Point,
        cost: &mut Cost,
    ) -> Option<Side> {
        let t = point.t;
        let off = gap.abs();
        let wide = 4.0 * off / (r + (r * r + 2.0 * a * gap).max(0.0).sqrt());
        if t == 0.0 || off <= rounding || !wide.is_finite() {
            return (t < self.horizon).then_some(side);
        }
        let bracket = if gap > 0.0 { (t, t + wide) } else { ((t - wide).max(0.0), t) };
        self.newton(side, full, bracket, point, cost)
    }
}
