//! The six-step solver again, written for speed: the yardstick for the cost of a cell change.
//!
//! theta' = u + (M1/M2) phi', u = theta'_0 - (M1/M2) phi'_0, and |phi'| never exceeds its envelope of the cell's start.
//! Where |u| exceeds that by a margin, theta is monotone and only one end of the cell can be met: Halley's iteration
//! from the linear guess, with sin, cos and exp evaluated once and then turned by the small corrections. Anything
//! else takes the safe path of [`super::solver`].

use super::solver::Motion;
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
    /// number of cells that needed the safe path
    pub safe: u64,
}

/// What a cell of one stiffness needs, computed once.
#[derive(Clone, Copy)]
struct Constants {
    k: f64,
    rest: f64,
    w2: f64,
    w: f64,
    per_w: f64,
    width: f64,
    /// M2 (k of the other cells - k)
    step: f64,
}

/// The exit of a monotone cell.
struct Exit {
    t: f64,
    upwards: bool,
    state: State,
}

/// e^{-s} (cos y, sin y) for |s|, |y| < 1/8, to rounding.
fn small_turn(s: f64, y: f64) -> (f64, f64) {
    let z = y * y;
    let sin = y * (1.0 - z / 6.0 * (1.0 - z / 20.0 * (1.0 - z / 42.0 * (1.0 - z / 72.0 * (1.0 - z / 110.0)))));
    let cos = 1.0 - z / 2.0 * (1.0 - z / 12.0 * (1.0 - z / 30.0 * (1.0 - z / 56.0 * (1.0 - z / 90.0))));
    let low = 1.0 - s / 5.0 * (1.0 - s / 6.0 * (1.0 - s / 7.0 * (1.0 - s / 8.0 * (1.0 - s / 9.0))));
    let exp = 1.0 - s * (1.0 - s / 2.0 * (1.0 - s / 3.0 * (1.0 - s / 4.0 * low)));
    (exp * cos, exp * sin)
}

impl Constants {
    /// The exit of a cell in which theta is certain to be monotone; `None` where that is not certain.
    #[inline]
    fn exit(&self, sigma: f64, ratio: f64, from: &State) -> Option<Exit> {
        let (a, v) = (from.phi - self.rest, from.phi_dot);
        let b = (v + sigma * a) * self.per_w;
        let q = -(sigma * v + self.w2 * a) * self.per_w;
        let drift = from.theta_dot - ratio * v;
        if drift * drift < 1.5 * ratio * ratio * (v * v + q * q) {
            return None;
        }
        let upwards = drift > 0.0;
        let distance = if upwards { self.width - from.theta } else { -from.theta };
        let mut t = distance / drift;
        let (sin, cos) = (self.w * t).sin_cos();
        let decay = if sigma == 0.0 { 1.0 } else { (-sigma * t).exp() };
        let (mut c, mut s) = (decay * cos, decay * sin);
        for _ in 0..6 {
            let (x, phi_dot) = (a * c + b * s, v * c + q * s);
            let gap = drift * t + ratio * (x - a) - distance;
            let slope = drift + ratio * phi_dot;
            let curvature = -ratio * (2.0 * sigma * phi_dot + self.w2 * x);
            // Halley
            let dt = -2.0 * gap * slope / (2.0 * slope * slope - gap * curvature);
            t += dt;
            let (turn, small) = (self.w * dt, self.w.max(sigma) * dt.abs());
            if small < 1e-5 {
                // the next correction would be of order turn^3: below rounding
                let (dc, ds) =
                    (1.0 - sigma * dt * (1.0 - sigma * dt / 2.0) - turn * turn / 2.0, turn * (1.0 - sigma * dt));
                (c, s) = (c * dc - s * ds, s * dc + c * ds);
                let phi_dot = v * c + q * s;
                let theta = if upwards { self.width } else { 0.0 };
                let state =
                    State { theta, theta_dot: drift + ratio * phi_dot, phi: self.rest + a * c + b * s, phi_dot };
                return Some(Exit { t, upwards, state });
            }
            if small < 0.125 {
                let (dc, ds) = small_turn(sigma * dt, turn);
                (c, s) = (c * dc - s * ds, s * dc + c * ds);
            } else {
                let (sin, cos) = (self.w * t).sin_cos();
                let decay = (-sigma * t).exp();
                (c, s) = (decay * cos, decay * sin);
            }
        }
        None
    }
}

impl GearPair {
    /// The motion of [`GearPair::solve`] without its record: end and counts alone.
    pub fn solve_fast(&self, theta0: f64, theta_dot0: f64, phi0: f64, phi_dot0: f64, t_end: f64) -> Fast {
        let (m2, ratio, sigma) = (self.m2(), self.m1() / self.m2(), self.zeta * self.w0());
        assert!(m2 * self.k1.min(self.k2) > sigma * sigma, "underdamped cells only: {self:?}");
        let constants = |cell: i64| {
            let k = self.k(cell);
            let w = (m2 * k - sigma * sigma).sqrt();
            let step = m2 * (self.k(cell + 1) - k);
            Constants { k, rest: self.t0 / k, w2: m2 * k, w, per_w: 1.0 / w, width: self.width(cell), step }
        };
        let cells = [constants(0), constants(1)];
        let (mut cell, theta) = self.locate(theta0);
        let mut state = State { theta, theta_dot: theta_dot0, phi: phi0, phi_dot: phi_dot0 };
        let mut left = t_end;
        let (mut cell_changes, mut reflections, mut safe) = (0, 0, 0);
        loop {
            let here = &cells[(cell & 1) as usize];
            let exit = match here.exit(sigma, ratio, &state) {
                Some(exit) => Some(exit).filter(|e| e.t <= left),
                None => {
                    safe += 1;
                    let motion = Motion::new(self, here.k, here.width, state);
                    motion.exit(left).map(|(t, upwards)| Exit { t, upwards, state: motion.at(t) })
                }
            };
            let Some(exit) = exit else {
                let mut end = self.closed_form(here.k, state, left);
                let end_local = end.theta;
                end.theta = self.unwrap(cell, end_local);
                return Fast { end, end_cell: cell, end_local, cell_changes, reflections, safe };
            };
            left -= exit.t;
            let before = exit.state;
            let work = here.step * before.phi * before.phi;
            let square = before.theta_dot * before.theta_dot - work;
            state = before;
            if square < 0.0 {
                reflections += 1;
                state.theta = if exit.upwards { here.width } else { 0.0 };
                state.theta_dot = -before.theta_dot;
                state.phi_dot -= 2.0 * ratio * before.theta_dot;
                continue;
            }
            cell_changes += 1;
            cell += if exit.upwards { 1 } else { -1 };
            state.theta = if exit.upwards { 0.0 } else { cells[(cell & 1) as usize].width };
            state.theta_dot = square.sqrt().copysign(before.theta_dot);
            let sum = state.theta_dot + before.theta_dot;
            state.phi_dot -= if sum == 0.0 { 0.0 } else { ratio * work / sum };
        }
    }
}
