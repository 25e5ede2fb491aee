//! The motion with damping as the paper prints it: a term 2 zeta w0 phi' in Eq. (2) and none in Eq. (3). No energy function
//! gives these equations, so they are solved here by hand.
//!
//! Within a cell phi is that of Eq. (12), and, with c = 2 zeta w0, `theta'' = (M1/M2) (phi'' + c phi')`, integrated
//! twice with `M2 k (phi - T0/k) = -phi'' - c phi'`. The end of a cell is searched in steps of a fiftieth of a period: accurate
//! enough here, but without the engine's guarantee to find the first crossing.

use gearsim_tests::oh2005::{GearPair, Jump, PITCH, State};

/// Samples of a run, and its rises of energy.
pub struct Printed {
    /// phi [rad]
    pub phi: Vec<f64>,
    /// Sum of all rises of U = T + V - W from one sample to the next within a cell [J].
    pub rises: f64,
    /// theta' [rad/s]
    pub theta_dot: Vec<f64>,
}

/// The state `t` [s] after `from` in a cell of stiffness `k` [N m].
fn closed_form(pair: &GearPair, k: f64, from: &State, t: f64) -> State {
    let s = pair.closed_form(k, *from, t);
    let (ratio, c, rest) = (pair.m1() / pair.m2(), 2.0 * pair.zeta * pair.w0(), pair.t0 / k);
    let change = (s.phi_dot - from.phi_dot) + c * (s.phi - from.phi);
    let drift = from.theta_dot - ratio * (from.phi_dot + c * from.phi);
    let area = rest * t - change / (pair.m2() * k); // the integral of phi over time
    let theta = from.theta + drift * t + ratio * ((s.phi - from.phi) + c * area);
    State { theta, theta_dot: from.theta_dot + ratio * change, ..s }
}

/// Runs from theta = 0, phi at rest and `rpm` for `t_end` [s], with samples at `rate` [Hz].
pub fn run(pair: &GearPair, rpm: f64, t_end: f64, rate: f64) -> Printed {
    let mut out = Printed { phi: vec![], rises: 0.0, theta_dot: vec![] };
    let mut from = pair.start(rpm);
    let phi0 = from.phi;
    // theta is measured from the beginning of the pitch, which has the cells 0 and 1.
    let (mut cell, mut t, mut reflections) = (0, 0.0, 0);
    let step = 0.02 * std::f64::consts::TAU / (pair.m2() * pair.k2).sqrt();
    // A gear pressed against a step would bounce without end.
    while t < t_end && reflections < 1_000_000 {
        let k = pair.k(cell);
        let (low, high) = if cell == 0 { (0.0, pair.width1) } else { (pair.width1, PITCH) };
        let at = |tau: f64| closed_form(pair, k, &from, tau);
        let left = |tau: f64| !(low..=high).contains(&at(tau).theta);
        let (mut inside, mut end) = (0.0, step);
        while !left(end) && t + inside < t_end {
            (inside, end) = (end, end + step);
        }
        for _ in 0..80 {
            let middle = 0.5 * (inside + end);
            *(if left(middle) { &mut end } else { &mut inside }) = middle;
        }
        let stop = end.min(t_end - t);
        let mut u = pair.energy(k, &from, phi0);
        while (out.phi.len() as f64) / rate < t + stop {
            let s = at((out.phi.len() as f64 / rate - t).max(0.0));
            let next = pair.energy(k, &s, phi0);
            out.rises += (next - u).max(0.0);
            u = next;
            out.phi.push(s.phi);
            out.theta_dot.push(s.theta_dot);
        }
        from = at(stop);
        out.rises += (pair.energy(k, &from, phi0) - u).max(0.0);
        t += stop;
        if t >= t_end {
            break;
        }
        let upper = from.theta > 0.5 * (low + high);
        let beyond = 1 - cell;
        match pair.jump(pair.k(beyond) - k, from.phi, from.theta_dot, from.phi_dot) {
            Jump::Transmit { theta_dot, phi_dot } => {
                let theta = [[PITCH, pair.width1], [pair.width1, 0.0]][cell as usize][usize::from(upper)];
                from = State { theta, theta_dot, phi_dot, ..from };
                cell = beyond;
            }
            Jump::Reflect { theta_dot, phi_dot } => {
                from = State { theta: if upper { high } else { low }, theta_dot, phi_dot, ..from };
                reflections += 1;
            }
        }
    }
    out
}
