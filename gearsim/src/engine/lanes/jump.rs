//! The jump: the state after the event.

use crate::engine::lanes::Lanes;
use crate::engine::lanes::cells::Cells;
use crate::engine::lanes::flight::{Flight, Point};
use crate::engine::lanes::locate::Target;
use crate::engine::lanes::pack::{Mask, Pack, two_sum};
use crate::tolerance::events::SHORT_BOUNCE;

/// The next event of each lane: located and passed, but not yet stored in the lanes.
#[derive(Clone, Copy)]
pub struct Attempt<const N: usize, const L: usize> {
    /// The lanes whose event is plain.
    pub sure: Mask<L>,
    /// Time to the event [s].
    pub t: Pack<L>,
    /// Whether the event is at the upper boundary of the cell.
    pub(super) up: Mask<L>,
    /// Whether the motion is reflected.
    pub(super) turned: Mask<L>,
    /// Whether the phase may have reversed within the flight. The time of the event then does not predict the next one.
    pub(super) found: Mask<L>,
    /// Number of evaluations of the motion.
    pub evaluations: usize,
    /// Time to the event at the steady part of the speed [s].
    pub(super) steady: Pack<L>,
    /// Coordinates and speeds just before the event.
    pub arrival: [[Pack<L>; N]; 2],
    /// The state after the event.
    pub(super) q: [Pack<L>; N],
    pub(super) q_dot: [Pack<L>; N],
    pub(super) lost: [Pack<L>; N],
    pub(super) dissipated: Pack<L>,
    /// The cell of all active lanes; `None` if they are in different cells.
    pub(super) common: Option<usize>,
}

/// The located events of the lanes.
pub struct Located<const L: usize> {
    /// The lanes that are proved to reach their boundary.
    pub sure: Mask<L>,
    /// Time to the event [s].
    pub t: Pack<L>,
    /// Number of evaluations of the motion.
    pub evaluations: usize,
    /// The cell of all active lanes; `None` if they are in different cells.
    pub common: Option<usize>,
}

impl<const N: usize, const L: usize> Lanes<N, L> {
    /// The state after the event, in the lanes with a transmission or a reflection.
    #[inline(always)]
    pub(super) fn jump(
        &self,
        cells: &Cells<N, L>,
        flight: &Flight<'_, N, L>,
        target: &Target<L>,
        points: &[Point<L>; N],
        Located { sure, t, evaluations, common }: Located<L>,
    ) -> Attempt<N, L> {
        let (mut q, mut q_dot, mut lost, mut dissipated) = (self.q, self.q_dot, self.lost, self.dissipated);
        let mut gained = [Pack::all(0.0); N];
        for j in 0..N {
            for i in 0..N {
                q[i] = q[i] + cells.shapes[i][j] * points[j].moved;
                gained[i] = gained[i] + cells.shapes[i][j] * points[j].gained;
            }
            if !self.rigid[j] {
                for i in 0..N {
                    lost[i] = lost[i] - cells.excess[i][j] * points[j].gained;
                }
                dissipated = dissipated + flight.dissipated(j, &points[j]);
            }
        }
        self.put(&mut q, target.boundary);
        let mut arrival = [q, q_dot];
        for i in 0..N {
            arrival[1][i] = q_dot[i] + (gained[i] + lost[i]);
        }
        let mut dv = Pack::all(0.0);
        for i in 0..N {
            for j in 0..N {
                dv = dv + cells.step[1][i][j].or_uniform(target.up, cells.step[0][i][j]) * q[i] * q[j];
            }
        }
        let v = self.of_phase(&q_dot) + self.of_phase(&gained);
        let lowered = 2.0 * self.compliance * dv;
        let square = v * v - lowered;
        let gain = -(target.sign * lowered) / (square.sqrt() + v.abs());
        let passes = square.compare(v, |square, v| (square > 0.0) & v.is_finite());
        let turned = square.compare(v, |square, v| (square < 0.0) & v.is_finite());
        let (mut gain, mut goes_on) = (gain, passes);
        if turned.intersects(sure) {
            gain = (-2.0 * v).or(turned, gain);
            goes_on = goes_on.with(turned.and(self.is_free(cells, flight, points, v)));
        }
        for i in 0..N {
            [q_dot[i], lost[i]] = two_sum(q_dot[i], (gained[i] + lost[i]) + self.direction[i] * gain);
        }
        let entered = cells.entered[1].or_uniform(target.up, cells.entered[0]);
        self.put(&mut q, target.boundary.or_uniform(turned, entered));
        let (sure, up, steady, found) = (sure.and(goes_on), target.up, target.steady, target.found);
        Attempt { sure, t, up, turned, found, evaluations, steady, arrival, q, q_dot, lost, dissipated, common }
    }

    /// Sets the coordinate that is the phase. It is a loop, because a variable index would force the array into memory, and the next access
    /// would wait for it.
    #[inline(always)]
    fn put(&self, q: &mut [Pack<L>; N], place: Pack<L>) {
        for i in 0..N {
            q[i] = if i == self.phase { place } else { q[i] };
        }
    }

    /// The entry of `all` that belongs to the phase.
    #[inline(always)]
    fn of_phase(&self, all: &[Pack<L>; N]) -> Pack<L> {
        let mut value = all[0];
        for i in 1..N {
            value = if i == self.phase { all[i] } else { value };
        }
        value
    }

    /// Whether a reflected motion with the normal speed `v` is certainly not pressed against the step: its bounce is too long for
    /// [`presses`]. The acceleration after the impulse is at most that before it plus what the dampers add.
    ///
    /// [`presses`]: crate::engine::contact::presses
    #[inline(always)]
    fn is_free(&self, cells: &Cells<N, L>, flight: &Flight<'_, N, L>, points: &[Point<L>; N], v: Pack<L>) -> Mask<L> {
        let mut acceleration = Pack::all(0.0);
        for i in 0..N {
            acceleration = acceleration + cells.modes[i].part * flight.derivatives(i, &points[i])[1];
        }
        let bounce = 2.0 * v.abs() * cells.rate;
        bounce.compare(acceleration, |bounce, a| bounce > SHORT_BOUNCE * (a.abs() + bounce))
    }
}
