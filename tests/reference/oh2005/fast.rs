//! The gear pair written by hand for speed, with no record of events. The cost of a cell change in gearsim is compared with it.
//!
//! In a cell, with x = phi - T0/k and r = M1/M2: x = e^{-sigma t} (a cos wt + b sin wt), phi' = e^{-sigma t} (v cos wt + q sin wt),
//! theta = theta_0 + (theta'_0 - r phi'_0) t + r (x - a). One event evaluates sin, cos and exp once, at the time of the boundary
//! estimated from the mean speed. The reversed Taylor series of theta corrects this time. Taylor series in the small time step then
//! give sin, cos and exp at the corrected time. `tests/peers/c/gear_pair.c` is the same program in C.

use std::f64::consts::PI;

use super::{GearPair, State};

/// End of a motion and its counts, without a record of events.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fast {
    /// state at the end time
    pub end: State,
    /// cell at the end time
    pub end_cell: i64,
    /// theta beyond the lower end of that cell \[rad\]
    pub end_local: f64,
    /// number of transmissions
    pub cell_changes: u64,
    /// number of reflections
    pub reflections: u64,
    /// number of cells in which theta could turn, so that the exit had to be searched for
    pub safe: u64,
}

/// Constants of a cell and of the pair.
struct Cell {
    ratio: f64,
    sigma: f64,
    /// T0/k \[rad\]
    rest: f64,
    /// M2 k \[1/s^2\]
    w2: f64,
    w: f64,
    per_w: f64,
    width: f64,
    /// M2 (k of the other cells - k) \[1/s^2\]
    step: f64,
    /// e^{-sigma pi/w}: decay from one zero of theta'' to the next
    half_period: f64,
}

/// A motion in a cell: x = a c + b s, phi' = v c + q s.
struct Motion<'c> {
    cell: &'c Cell,
    a: f64,
    b: f64,
    v: f64,
    q: f64,
    /// theta' - r phi' \[rad/s\], constant
    drift: f64,
    theta: f64,
}

/// A time \[s\], and c, s = e^{-sigma t} (cos wt, sin wt) there.
#[derive(Clone, Copy)]
struct Point {
    t: f64,
    c: f64,
    s: f64,
}

impl<'c> Motion<'c> {
    #[inline(always)]
    fn new(cell: &'c Cell, from: &State) -> Self {
        let (a, v) = (from.phi - cell.rest, from.phi_dot);
        let b = (v + cell.sigma * a) * cell.per_w;
        let q = -(cell.sigma * v + cell.w2 * a) * cell.per_w;
        Motion { cell, a, b, v, q, drift: from.theta_dot - cell.ratio * v, theta: from.theta }
    }

    #[inline(always)]
    fn at(&self, t: f64) -> Point {
        let (sin, cos) = (self.cell.w * t).sin_cos();
        let decay = (-self.cell.sigma * t).exp();
        Point { t, c: decay * cos, s: decay * sin }
    }

    #[inline(always)]
    fn state(&self, Point { t, c, s }: Point) -> State {
        let (x, phi_dot) = (self.a * c + self.b * s, self.v * c + self.q * s);
        let theta = self.theta + (self.drift * t + self.cell.ratio * (x - self.a));
        State { theta, theta_dot: self.drift + self.cell.ratio * phi_dot, phi: self.cell.rest + x, phi_dot }
    }

    /// The point where theta = `bound`, searched from the near point `from`. `None` if theta turns before it, or if its time would be
    /// after `last` \[s\].
    #[inline(always)]
    fn meet(&self, bound: f64, last: f64, from: Point) -> Option<Point> {
        let Cell { ratio, sigma, w2, w, .. } = *self.cell;
        let (Point { mut t, mut c, mut s }, distance, mut first) = (from, bound - self.theta, 0.0);
        for _ in 0..50 {
            let (x, v) = (self.a * c + self.b * s, self.v * c + self.q * s);
            let acceleration = -2.0 * sigma * v - w2 * x;
            let jerk = -2.0 * sigma * acceleration - w2 * v;
            let snap = -2.0 * sigma * jerk - w2 * acceleration;
            let lacking = distance - self.drift * t - ratio * (x - self.a);
            let per_slope = 1.0 / (self.drift + ratio * v);
            if first * per_slope < 0.0 || t > last {
                return None;
            }
            first = per_slope;
            // The root of the Taylor polynomial by reversion where it is near, else Newton's step.
            let h = lacking * per_slope;
            let g = ratio * per_slope * h;
            let (a2, a3, a4) = (acceleration * 0.5 * g, jerk * (1.0 / 6.0) * g * h, snap * (1.0 / 24.0) * g * h * h);
            let small = a2 * a2 + a3.abs();
            let series = h * (1.0 - a2 + (2.0 * a2 * a2 - a3) - (5.0 * a2 * (a2 * a2 - a3) + a4));
            let dt = if small < 1e-2 { series } else { h };
            t += dt;
            let (y, z) = (w * dt, sigma * dt);
            let (y2, z2) = (y * y, z * z);
            if y2 >= 2e-2 {
                Point { c, s, .. } = self.at(t);
                continue;
            }
            let (cos, sin, decay) = if y2 < 4e-4 {
                let cos = 1.0 - y2 * (0.5 - y2 * (1.0 / 24.0 - y2 * (1.0 / 720.0)));
                let sin = y * (1.0 - y2 * (1.0 / 6.0 - y2 * (1.0 / 120.0 - y2 * (1.0 / 5040.0))));
                (cos, sin, 1.0 - z + z2 * ((0.5 - z * (1.0 / 6.0)) + z2 * (1.0 / 24.0 - z * (1.0 / 120.0))))
            } else {
                let cos = y2 * (1.0 / 720.0 - y2 * (1.0 / 40_320.0 - y2 * (1.0 / 3_628_800.0)));
                let sin = y2 * (1.0 / 5040.0 - y2 * (1.0 / 362_880.0));
                let cos = 1.0 - y2 * (0.5 - y2 * (1.0 / 24.0 - cos));
                (cos, y * (1.0 - y2 * (1.0 / 6.0 - y2 * (1.0 / 120.0 - sin))), (-z).exp())
            };
            (c, s) = (decay * (c * cos - s * sin), decay * (s * cos + c * sin));
            let beyond = 14.0 * small * small + a4.abs() * (y.abs() + 6.0 * a2.abs());
            if y2 < 4e-4 && beyond * dt.abs() <= f64::EPSILON * t {
                break;
            }
        }
        Some(Point { t, c, s })
    }

    /// The exit of a cell in which theta may turn, and whether it is upwards; `None` if there is none until `left` \[s\]. Between two
    /// zeros of theta'' theta is convex or concave. Newton's method from the right one of the two zeros therefore never passes the root.
    fn search(&self, left: f64) -> Option<(Point, bool)> {
        let cell = self.cell;
        let a = -2.0 * cell.sigma * self.v - cell.w2 * self.a;
        let b = -(cell.sigma * a + cell.w2 * self.v) * cell.per_w;
        let phase = (-a).atan2(b);
        let mut from = Point { t: 0.0, c: 1.0, s: 0.0 };
        let mut to = self.at(if phase <= 0.0 { phase + PI } else { phase } * cell.per_w);
        let mut bends = if a > 0.0 || (a == 0.0 && b > 0.0) { 1.0 } else { -1.0 };
        let mut first = self.state(from);
        loop {
            let last = self.state(to);
            let (edge, other) = if bends < 0.0 { (cell.width, 0.0) } else { (0.0, cell.width) };
            if first.theta_dot * bends < 0.0 {
                // theta moves towards `edge` and turns back. It goes no further than the intersection of the tangents at both ends.
                let rise = last.theta - first.theta - last.theta_dot * (to.t - from.t);
                let peak = first.theta + first.theta_dot * rise / (first.theta_dot - last.theta_dot);
                let found = if (peak - edge) * bends < 0.0 { self.meet(edge, to.t, from) } else { None };
                if let Some(point) = found {
                    return Some((point, bends < 0.0));
                }
            }
            if (last.theta - other) * bends > 0.0 {
                return self.meet(other, f64::INFINITY, to).map(|point| (point, bends > 0.0));
            }
            if to.t > left {
                return None;
            }
            (from, first, bends) = (to, last, -bends);
            to = Point { t: to.t + PI * cell.per_w, c: -cell.half_period * to.c, s: -cell.half_period * to.s };
        }
    }
}

impl GearPair {
    /// The motion of [`GearPair::solve`] without the record of events: only the end and the counts.
    pub fn solve_fast(&self, theta0: f64, theta_dot0: f64, phi0: f64, phi_dot0: f64, t_end: f64) -> Fast {
        let (m2, ratio, sigma) = (self.m2(), self.m1() / self.m2(), self.zeta * self.w0());
        assert!(m2 * self.k1.min(self.k2) > sigma * sigma, "underdamped cells only: {self:?}");
        let cells = [0, 1].map(|i| {
            let (k, w2) = (self.k(i), m2 * self.k(i));
            let (w, step) = ((w2 - sigma * sigma).sqrt(), m2 * (self.k(i + 1) - k));
            let (per_w, half_period) = (1.0 / w, (-sigma * PI / w).exp());
            Cell { ratio, sigma, rest: self.t0 / k, w2, w, per_w, width: self.width(i), step, half_period }
        });
        let (mut cell, theta) = self.locate(theta0);
        let mut now = State { theta, theta_dot: theta_dot0, phi: phi0, phi_dot: phi_dot0 };
        let mut left = t_end;
        let (mut cell_changes, mut reflections, mut safe) = (0, 0, 0);
        loop {
            // Solve.
            let here = &cells[(cell & 1) as usize];
            let motion = Motion::new(here, &now);
            let Motion { v, q, drift, .. } = motion;
            // Locate: theta is monotone where |drift| exceeds the largest possible |r phi'|.
            let exit = if drift * drift > 1.001 * ratio * ratio * (v * v + q * q) {
                let bound = if drift > 0.0 { here.width } else { 0.0 };
                let guess = motion.at((bound - now.theta) / drift);
                motion.meet(bound, f64::INFINITY, guess).map(|point| (point, drift > 0.0))
            } else {
                safe += 1;
                motion.search(left)
            };
            let Some((point, up)) = exit.filter(|(point, _)| point.t <= left) else {
                let mut end = motion.state(motion.at(left));
                let end_local = end.theta;
                end.theta = self.unwrap(cell, end_local);
                return Fast { end, end_cell: cell, end_local, cell_changes, reflections, safe };
            };
            left -= point.t;
            // Jump, Eqs. (9), (11), or back where the energy does not suffice.
            let State { theta_dot, phi, phi_dot, .. } = motion.state(point);
            let work = here.step * phi * phi;
            let square = theta_dot * theta_dot - work;
            if square < 0.0 {
                reflections += 1;
                let theta = if up { here.width } else { 0.0 };
                now = State { theta, theta_dot: -theta_dot, phi, phi_dot: phi_dot - 2.0 * ratio * theta_dot };
                continue;
            }
            cell_changes += 1;
            cell += if up { 1 } else { -1 };
            let beyond = square.sqrt().copysign(theta_dot);
            let theta = if up { 0.0 } else { cells[(cell & 1) as usize].width };
            now = State { theta, theta_dot: beyond, phi, phi_dot: phi_dot - ratio * work / (beyond + theta_dot) };
        }
    }
}
