//! The undamped gear pair with pitch errors, by hand: cells in closed form, boundaries found by small steps and bisection, the jump
//! rule for k and e together. The cells of pitch p are 2 p and 2 p + 1, independent of how the engine counts them.

use std::f64::consts::TAU;

/// Levels of k [N m] and the width of the first [rad], pitch errors [rad], torque [N m].
pub struct Pair<'a> {
    pub k: [f64; 2],
    pub width: f64,
    pub errors: &'a [f64],
    pub t0: f64,
}

/// theta, phi [rad], theta', phi' [rad/s].
pub type State = [f64; 4];

impl Pair<'_> {
    fn boundary(&self, cell: i64) -> f64 {
        TAU * cell.div_euclid(2) as f64 + if cell.rem_euclid(2) == 0 { 0.0 } else { self.width }
    }

    fn level(&self, cell: i64) -> (f64, f64) {
        let tooth = cell.div_euclid(2).rem_euclid(self.errors.len() as i64);
        (self.k[cell.rem_euclid(2) as usize], self.errors[tooth as usize])
    }

    fn after(&self, cell: i64, [theta, phi, theta_dot, phi_dot]: State, t: f64) -> State {
        let (m1, m2) = super::mobilities();
        let (k, e) = self.level(cell);
        let (w, rest) = ((m2 * k).sqrt(), e + self.t0 / k);
        let (s, c) = (w * t).sin_cos();
        let moved = (phi - rest) * (c - 1.0) + phi_dot / w * s;
        let gained = -(phi - rest) * w * s + phi_dot * (c - 1.0);
        // theta'' = (M1/M2) phi'', because the same forces act on both.
        [
            theta + theta_dot * t + m1 / m2 * (moved - phi_dot * t),
            phi + moved,
            theta_dot + m1 / m2 * gained,
            phi_dot + gained,
        ]
    }

    /// The state after `t_end` [s], and the numbers of steps transmitted and reflected.
    pub fn run(&self, mut state: State, mut cell: i64, t_end: f64) -> (State, [u64; 2]) {
        let (m1, m2) = super::mobilities();
        let (mut t, mut counts) = (0.0, [0, 0]);
        loop {
            let (low, high) = (self.boundary(cell), self.boundary(cell + 1));
            let outside = |dt: f64| {
                let theta = self.after(cell, state, dt)[0];
                theta < low || theta > high
            };
            let step = 1e-7;
            // Just after an event the phase is on a boundary within a rounding error, so the search starts a little later.
            let mut dt = 1e-10;
            while t + dt < t_end && !outside(dt) {
                dt += step;
            }
            if t + dt >= t_end {
                return (self.after(cell, state, t_end - t), counts);
            }
            let (mut a, mut b) = ((dt - step).max(0.0), dt);
            for _ in 0..60 {
                let middle = 0.5 * (a + b);
                if outside(middle) { b = middle } else { a = middle }
            }
            (t, state) = (t + b, self.after(cell, state, b));
            let next = if state[2] > 0.0 { cell + 1 } else { cell - 1 };
            let ((k, e), (k_next, e_next)) = (self.level(cell), self.level(next));
            let dv = k_next * (state[1] - e_next).powi(2) - k * (state[1] - e).powi(2);
            let square = state[2] * state[2] - m2 * dv;
            let speed = if square >= 0.0 { square.sqrt() * state[2].signum() } else { -state[2] };
            (state[3], state[2]) = (state[3] + m1 / m2 * (speed - state[2]), speed);
            counts[usize::from(square < 0.0)] += 1;
            cell = if square >= 0.0 { next } else { cell };
        }
    }
}
