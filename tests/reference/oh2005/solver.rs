//! The six steps of Oh, Grosh & Barber for their own system: solve, locate, jump, solve, locate, jump.
//!
//! The first exit from a cell is found with the zeros of theta'', which have a closed form: one every pi/w. Between two neighbours of
//! these zeros theta' is monotone and has at most one zero. The zero of theta' divides this interval into two, in each of which theta is
//! monotone. So the values of theta at their ends decide whether it leaves the cell. Underdamped motion only.

use super::{GearPair, Jump, State};

/// What happened at the end of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// the step was crossed
    Transmit,
    /// the motion turned back
    Reflect,
}

/// An encounter with the end of a cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// time \[s\]
    pub t: f64,
    /// crossed or turned back
    pub kind: Kind,
    /// cell before, counted as in [`GearPair::k`]
    pub cell_from: i64,
    /// cell after; the same in a reflection
    pub cell_to: i64,
}

/// A motion from its start to its end time.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// encounters with ends of cells, in order
    pub events: Vec<Event>,
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
}

/// The motion within one cell from t = 0, with theta counted from the cell's lower end.
pub(super) struct Motion<'a> {
    pair: &'a GearPair,
    k: f64,
    width: f64,
    from: State,
}

impl<'a> Motion<'a> {
    pub(super) fn new(pair: &'a GearPair, k: f64, width: f64, from: State) -> Self {
        Self { pair, k, width, from }
    }

    pub(super) fn at(&self, t: f64) -> State {
        self.pair.closed_form(self.k, self.from, t)
    }

    /// The first zero of theta'' after t = 0, and the time between neighbouring zeros \[s\].
    fn inflections(&self) -> (f64, f64) {
        let p = self.pair;
        let sigma = p.zeta * p.w0();
        let w2 = p.m2() * self.k;
        let w = (w2 - sigma * sigma).sqrt();
        // phi'' e^{sigma t} = a cos(w t) + b sin(w t)
        let (x, v) = (self.from.phi - p.t0 / self.k, self.from.phi_dot);
        let a = -2.0 * sigma * v - w2 * x;
        let b = (-sigma * a - w2 * v) / w;
        let phase = (-a).atan2(b).rem_euclid(std::f64::consts::PI);
        (phase / w, std::f64::consts::PI / w)
    }

    /// The first time in (0, `t_max`\] \[s\] at which theta leaves the cell, and whether upwards.
    pub(super) fn exit(&self, t_max: f64) -> Option<(f64, bool)> {
        let (mut next, spacing) = self.inflections();
        let mut left = 0.0;
        let mut state = self.from;
        loop {
            let right = next.min(t_max);
            let end = self.at(right);
            if state.theta_dot * end.theta_dot < 0.0 {
                let turn = root(left, right, state.theta_dot < 0.0, |t| {
                    let s = self.at(t);
                    (s.theta_dot, self.pair.newtonian(self.k, s.phi, s.phi_dot).1)
                });
                if let Some(found) = self.leaves(left, turn, self.at(turn).theta, state.theta_dot > 0.0) {
                    return Some(found);
                }
                left = turn;
            }
            let rising = if end.theta_dot == 0.0 { state.theta_dot > 0.0 } else { end.theta_dot > 0.0 };
            if let Some(found) = self.leaves(left, right, end.theta, rising) {
                return Some(found);
            }
            if right >= t_max {
                return None;
            }
            (left, state, next) = (right, end, next + spacing);
        }
    }

    /// The exit between `left` and `right` \[s\], where theta is monotone and ends at `theta`.
    fn leaves(&self, left: f64, right: f64, theta: f64, rising: bool) -> Option<(f64, bool)> {
        let bound = match rising {
            true if theta > self.width => self.width,
            false if theta < 0.0 => 0.0,
            _ => return None,
        };
        let value = |t| {
            let s = self.at(t);
            (s.theta - bound, s.theta_dot)
        };
        Some((root(left, right, rising, value), rising))
    }
}

/// The root in \[`left`, `right`\] of a monotone function, given with its derivative. Newton's method, replaced by bisection where its
/// step leaves the interval.
fn root(mut left: f64, mut right: f64, rising: bool, f: impl Fn(f64) -> (f64, f64)) -> f64 {
    let mut t = 0.5 * (left + right);
    for _ in 0..200 {
        let (value, slope) = f(t);
        if value == 0.0 {
            return t;
        }
        if (value < 0.0) == rising {
            left = t
        } else {
            right = t
        }
        let newton = t - value / slope;
        let next = if newton > left && newton < right { newton } else { 0.5 * (left + right) };
        if (next - t).abs() <= 2.0 * f64::EPSILON * t.abs() || next <= left || next >= right {
            return next;
        }
        t = next;
    }
    t
}

impl GearPair {
    /// The motion over \[0, `t_end`\] \[s\] from theta, phi \[rad\] and theta', phi' \[rad/s\], every event recorded.
    ///
    /// A touch of the boundary without crossing it is no event. Panics unless every cell is underdamped.
    pub fn solve(&self, theta0: f64, theta_dot0: f64, phi0: f64, phi_dot0: f64, t_end: f64) -> Run {
        let sigma = self.zeta * self.w0();
        assert!(self.m2() * self.k1.min(self.k2) > sigma * sigma, "underdamped cells only: {self:?}");
        let (mut cell, theta) = self.locate(theta0);
        let mut state = State { theta, theta_dot: theta_dot0, phi: phi0, phi_dot: phi_dot0 };
        let (mut t, mut lost) = (0.0, 0.0);
        let mut run =
            Run { events: Vec::new(), end: state, end_cell: cell, end_local: theta, cell_changes: 0, reflections: 0 };
        loop {
            // solve
            let (k, width) = (self.k(cell), self.width(cell));
            let motion = Motion::new(self, k, width, state);
            // locate
            let left = (t_end - t) - lost;
            let Some((dt, upwards)) = motion.exit(left) else {
                run.end = motion.at(left);
                (run.end_cell, run.end_local) = (cell, run.end.theta);
                run.end.theta = self.unwrap(cell, run.end_local);
                return run;
            };
            state = motion.at(dt);
            // the time is t + lost, a compensated sum, because a long run adds millions of short cells
            let sum = t + (dt + lost);
            (t, lost) = (sum, (dt + lost) - (sum - t));
            // jump
            let beyond = if upwards { cell + 1 } else { cell - 1 };
            let (kind, cell_to) = match self.jump(self.k(beyond) - k, state.phi, state.theta_dot, state.phi_dot) {
                Jump::Transmit { theta_dot, phi_dot } => {
                    let theta = if upwards { 0.0 } else { self.width(beyond) };
                    state = State { theta, theta_dot, phi_dot, ..state };
                    run.cell_changes += 1;
                    (Kind::Transmit, beyond)
                }
                Jump::Reflect { theta_dot, phi_dot } => {
                    let theta = if upwards { width } else { 0.0 };
                    state = State { theta, theta_dot, phi_dot, ..state };
                    run.reflections += 1;
                    (Kind::Reflect, cell)
                }
            };
            run.events.push(Event { t, kind, cell_from: cell, cell_to });
            cell = cell_to;
        }
    }
}
