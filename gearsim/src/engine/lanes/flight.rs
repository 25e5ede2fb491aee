//! The motion in a cell, for all lanes at once: [`crate::engine::cell::Flight`] without its special cases. A lane that needs one
//! is left to the general loop.

use crate::engine::lanes::cells::{Cells, Modes};
use crate::engine::lanes::elementary::{exp_m1, sin_cos};
use crate::engine::lanes::pack::{Mask, Pack};

/// The motion from a given state on.
pub struct Flight<'a, const N: usize, const L: usize> {
    cells: &'a Cells<N, L>,
    /// Modal speeds at the start.
    pub speed: [Pack<L>; N],
    /// Modal forces at the start.
    force: [Pack<L>; N],
}

/// S1(t), S2(t) and e^{-sigma t} - 1 of one mode. They depend on the cell and the time, not on the state.
#[derive(Debug, Clone, Copy)]
pub struct Response<const L: usize> {
    pub s1: Pack<L>,
    pub s2: Pack<L>,
    pub decay: Pack<L>,
}

impl<const L: usize> Response<L> {
    /// The responses at the time 0.
    pub const NONE: Response<L> = {
        let zero = Pack([0.0; L]);
        Response { s1: zero, s2: zero, decay: zero }
    };

    /// Selects the lanes of `mask` from `self`, the others from `other`.
    #[inline(always)]
    pub fn or(self, mask: Mask<L>, other: &Response<L>) -> Response<L> {
        Response {
            s1: self.s1.or(mask, other.s1),
            s2: self.s2.or(mask, other.s2),
            decay: self.decay.or(mask, other.decay),
        }
    }
}

/// The responses of every mode after the time `t` [s]. It uses loops instead of `array::from_fn`, because a function that is not
/// inlined is compiled without the vector instructions of the processor at hand.
#[inline(always)]
pub fn responses<const N: usize, const L: usize>(
    cells: &Cells<N, L>,
    rigid: &[bool; N],
    t: Pack<L>,
) -> [Response<L>; N] {
    let mut all = [Response::NONE; N];
    for i in 0..N {
        if rigid[i] {
            all[i] = Response { s1: t, s2: 0.5 * t * t, decay: Pack::all(0.0) };
            continue;
        }
        let Modes { sigma, w, per_w, per_omega2, .. } = cells.modes[i];
        let decay = exp_m1(-(sigma * t));
        let (h, c) = sin_cos(0.5 * w * t);
        let e = 1.0 + decay;
        let s1 = 2.0 * h * c * e * per_w;
        all[i] = Response { s1, s2: (2.0 * h * h * e - decay - sigma * s1) * per_omega2, decay };
    }
    all
}

/// The responses of one mode, and its displacement and change of speed.
#[derive(Clone, Copy)]
pub struct Point<const L: usize> {
    s1: Pack<L>,
    s2: Pack<L>,
    decay: Pack<L>,
    /// xi(t) - xi(0).
    pub moved: Pack<L>,
    /// xi'(t) - xi'(0).
    pub gained: Pack<L>,
}

impl<const L: usize> Point<L> {
    /// Selects the lanes of `mask` from `self`, the others from `other`.
    #[inline(always)]
    pub fn or(self, mask: Mask<L>, other: &Point<L>) -> Point<L> {
        Point {
            s1: self.s1.or(mask, other.s1),
            s2: self.s2.or(mask, other.s2),
            decay: self.decay.or(mask, other.decay),
            moved: self.moved.or(mask, other.moved),
            gained: self.gained.or(mask, other.gained),
        }
    }

    /// The point at the start.
    pub const STILL: Point<L> = {
        let zero = Pack([0.0; L]);
        Point { s1: zero, s2: zero, decay: zero, moved: zero, gained: zero }
    };
}

impl<'a, const N: usize, const L: usize> Flight<'a, N, L> {
    #[inline(always)]
    pub fn new(cells: &'a Cells<N, L>, q: &[Pack<L>; N], q_dot: &[Pack<L>; N]) -> Self {
        let (mut speed, mut force) = ([Pack::all(0.0); N], cells.load);
        for i in 0..N {
            for j in 0..N {
                speed[i] = speed[i] + cells.momentum[i][j] * q_dot[j];
                force[i] = force[i] - cells.springs[i][j] * q[j];
            }
        }
        Flight { cells, speed, force }
    }

    /// Acceleration of mode `i` at the start.
    #[inline(always)]
    pub fn acceleration(&self, i: usize) -> Pack<L> {
        self.force[i] - 2.0 * self.cells.modes[i].sigma * self.speed[i]
    }

    /// Every mode at the time of the given responses.
    #[inline(always)]
    pub fn all_after(&self, responses: &[Response<L>; N]) -> [Point<L>; N] {
        let mut points = [Point::STILL; N];
        for i in 0..N {
            let Response { s1, s2, decay } = responses[i];
            points[i] = self.point(i, s1, s2, decay);
        }
        points
    }

    /// Every mode at a short time `dt` [s] after the time `t` of the points `from`, by the series of S1(dt) and S2(dt).
    #[inline(always)]
    pub fn all_shifted(&self, rigid: &[bool; N], from: &[Point<L>; N], t: Pack<L>, dt: Pack<L>) -> [Point<L>; N] {
        let mut points = [Point::STILL; N];
        for i in 0..N {
            points[i] = self.shifted(i, rigid[i], &from[i], t, dt);
        }
        points
    }

    /// The same for longer times: up to [`FAR_SHIFT_SPAN`](crate::tolerance::modes::FAR_SHIFT_SPAN) divided by the rate of the cell.
    #[inline(always)]
    pub fn all_shifted_far(&self, rigid: &[bool; N], from: &[Point<L>; N], t: Pack<L>, dt: Pack<L>) -> [Point<L>; N] {
        let mut points = [Point::STILL; N];
        for i in 0..N {
            points[i] = self.shifted_far(i, rigid[i], &from[i], t, dt);
        }
        points
    }

    #[inline(always)]
    fn shifted(&self, i: usize, rigid: bool, at: &Point<L>, t: Pack<L>, dt: Pack<L>) -> Point<L> {
        if rigid {
            return self.moved_on(i, t + dt);
        }
        let Modes { sigma, series: [c2, c3, c4, c5, c6], .. } = self.cells.modes[i];
        // Evaluate in pairs, which the processor computes in parallel. With one lane, all that follows waits for this result.
        let dt2 = dt * dt;
        let s1 = dt * ((1.0 + dt * c2) + dt2 * ((c3 + dt * c4) + dt2 * (c5 + dt * c6)));
        let (low, middle) = (0.5 + dt * (c2 * (1.0 / 3.0)), c3 * 0.25 + dt * (c4 * 0.2));
        let s2 = dt2 * (low + dt2 * (middle + dt2 * (c5 * (1.0 / 6.0) + dt * (c6 * (1.0 / 7.0)))));
        let x = -(sigma * dt);
        let x2 = x * x;
        let decay = x * ((1.0 + x * 0.5) + x2 * ((1.0 / 6.0 + x * (1.0 / 24.0)) + x2 * (1.0 / 120.0)));
        self.followed(i, at, &Response { s1, s2, decay })
    }

    #[inline(always)]
    fn shifted_far(&self, i: usize, rigid: bool, at: &Point<L>, t: Pack<L>, dt: Pack<L>) -> Point<L> {
        if rigid {
            return self.moved_on(i, t + dt);
        }
        let Modes { sigma, omega2, series: [c2, c3, c4, c5, c6], .. } = self.cells.modes[i];
        // From S1'' + 2 sigma S1' + omega² S1 = 0.
        let c7 = (-12.0 * sigma * c6 - omega2 * c5) * (1.0 / 42.0);
        let c8 = (-14.0 * sigma * c7 - omega2 * c6) * (1.0 / 56.0);
        let dt2 = dt * dt;
        let dt4 = dt2 * dt2;
        let s1 = dt * (((1.0 + dt * c2) + dt2 * (c3 + dt * c4)) + dt4 * ((c5 + dt * c6) + dt2 * (c7 + dt * c8)));
        let low = (0.5 + dt * (c2 * (1.0 / 3.0))) + dt2 * (c3 * 0.25 + dt * (c4 * 0.2));
        let high = (c5 * (1.0 / 6.0) + dt * (c6 * (1.0 / 7.0))) + dt2 * (c7 * 0.125 + dt * (c8 * (1.0 / 9.0)));
        let s2 = dt2 * (low + dt4 * high);
        self.followed(i, at, &Response { s1, s2, decay: exp_m1(-(sigma * dt)) })
    }

    /// A rigid mode at the time `t` [s].
    #[inline(always)]
    fn moved_on(&self, i: usize, t: Pack<L>) -> Point<L> {
        self.point(i, t, 0.5 * t * t, Pack::all(0.0))
    }

    /// Mode `i` a further time after the point `at`; `after` are the responses at this further time.
    #[inline(always)]
    fn followed(&self, i: usize, at: &Point<L>, after: &Response<L>) -> Point<L> {
        let Modes { sigma, omega2, .. } = self.cells.modes[i];
        let (a, b) = (2.0 * sigma, omega2);
        let (speed, force) = (1.0 - a * at.s1 - b * at.s2, -(b * at.s1));
        self.point(
            i,
            at.s1 + speed * after.s1 + force * after.s2,
            at.s2 + at.s1 * after.s1 + (1.0 - b * at.s2) * after.s2,
            at.decay + (1.0 + at.decay) * after.decay,
        )
    }

    #[inline(always)]
    fn point(&self, i: usize, s1: Pack<L>, s2: Pack<L>, decay: Pack<L>) -> Point<L> {
        let (v, f, mode) = (self.speed[i], self.force[i], &self.cells.modes[i]);
        let gained = (f - 2.0 * mode.sigma * v) * s1 - mode.omega2 * v * s2;
        Point { s1, s2, decay, moved: v * s1 + f * s2, gained }
    }

    /// Speed, acceleration, jerk and snap of mode `i` at a point.
    #[inline(always)]
    pub fn derivatives(&self, i: usize, point: &Point<L>) -> [Pack<L>; 4] {
        let Modes { sigma, omega2, .. } = self.cells.modes[i];
        let next = |y: Pack<L>, y_dot: Pack<L>| -(2.0 * sigma * y_dot) - omega2 * y;
        let v = self.speed[i] + point.gained;
        let a = self.force[i] - omega2 * point.moved - 2.0 * sigma * v;
        let jerk = next(v, a);
        [v, a, jerk, next(a, jerk)]
    }

    /// Energy dissipated in mode `i` from the start to a point [J]. The formula is that of
    /// [`crate::engine::mode::Mode::dissipated`].
    #[inline(always)]
    pub fn dissipated(&self, i: usize, point: &Point<L>) -> Pack<L> {
        let Modes { sigma, omega2, per_omega2, w, per_w, .. } = self.cells.modes[i];
        let v = self.speed[i];
        let b = (self.acceleration(i) + sigma * v) * per_w;
        let (sine, lacking) = (w * point.s1, omega2 * point.s2 + sigma * point.s1);
        let (x1, x2) = (2.0 * sine * (1.0 - lacking), lacking * (2.0 - lacking) + sine * sine);
        let flat = -(point.decay * (2.0 + point.decay));
        let cosines = sigma * (sigma * x2 + w * x1) * per_omega2;
        let sines = sigma * (w * x2 - sigma * x1) * per_omega2;
        0.5 * (v * v + b * b) * flat + 0.5 * (v * v - b * b) * cosines + v * b * sines
    }
}
