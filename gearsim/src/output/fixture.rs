//! A trajectory for tests: an oscillator phi whose stiffness steps. The rotation theta supplies the energy of each step.

use crate::model::{Coordinate, Model, Output, Start, Torque};
use crate::trajectory::{Moment, Trajectory};

/// A model that has only the coordinates and torques of a gear pair.
pub(crate) static MODEL: Model = Model {
    name: "oscillator",
    title: "An oscillator with a stepped stiffness",
    source: "none",
    coordinates: &[
        Coordinate { name: "theta", unit: "rad", doc: "mean rotation", start: Start::At(0.0) },
        Coordinate { name: "phi", unit: "rad", doc: "relative deflection", start: Start::Static },
    ],
    parameters: &[],
    laws: &[],
    motions: &[],
    effects: &[],
    outputs: &[
        Output { name: "rotor_speed", unit: "rad/s", with: None, known: false, doc: "rotational speed" },
        Output { name: "dte", unit: "rad", with: None, known: false, doc: "transmission error" },
    ],
    switches: &[],
    nonlinear: "",
    nonlinear_with: &[],
    torques: &[
        Torque { name: "drive", with: &[], doc: "on the driving gear" },
        Torque { name: "load", with: &[], doc: "on the driven gear" },
    ],
    equations: "",
    elements: &[],
    latex: "",
    relative: &[],
};

/// Damped natural angular frequency at the mean stiffness [rad/s].
pub(crate) const REFERENCE: f64 = 7000.0;
/// Recording rate of [`oscillator`] [1/s].
pub(crate) const RATE: f64 = 2e4;

const MASS: f64 = 4.3e-5;
const FORCE: f64 = 20.0;
const DAMPING: f64 = 2.0 * 0.05 * REFERENCE * MASS;
const INERTIA: f64 = 4.3e-4;
const SPEED: f64 = 754.0;

/// `n` samples at [`RATE`], with the rows before and after every step of the stiffness (two steps per period of 8.33 ms).
///
/// T = (INERTIA theta'^2 + MASS phi'^2)/2, V = k phi^2/2, W = FORCE (phi - phi_0), D = DAMPING phi'^2/2.
pub(crate) fn oscillator(n: usize) -> Trajectory {
    let levels = [1.33 * MASS * REFERENCE.powi(2), 0.67 * MASS * REFERENCE.powi(2)];
    let (dt, mut level, mut next) = (1.0 / RATE, 0, 6.04e-3);
    let phi_0 = FORCE / levels[0];
    let mut x = [0.0, SPEED, phi_0, 0.0, 0.0];
    let mut run = Trajectory::new(&MODEL, &[0, 1], &[0, 1]);
    let mut push = |t: f64, moment, k: f64, x: &[f64; 5]| {
        let kinetic = 0.5 * (INERTIA * x[1] * x[1] + MASS * x[3] * x[3]);
        let (strain, work) = (0.5 * k * x[2] * x[2], FORCE * (x[2] - phi_0));
        run.t.push(t);
        run.moment.push(moment);
        for i in 0..2 {
            run.q[i].push(x[2 * i]);
            run.q_dot[i].push(x[2 * i + 1]);
        }
        run.outputs[0].1.push(x[1]);
        run.outputs[1].1.push(x[2]);
        run.kinetic.push(kinetic);
        run.strain.push(strain);
        run.work.push(work);
        run.torque_work[0].1.push(0.5 * work);
        run.torque_work[1].1.push(0.5 * work);
        run.dissipated.push(x[4]);
        let start = run.kinetic[0] + run.strain[0];
        run.residual.push(kinetic + strain - work + x[4] - start);
    };
    push(0.0, Moment::Sample, levels[0], &x);
    let mut t = 0.0;
    for i in 1..n {
        let end = i as f64 * dt;
        if next < end {
            advance(&mut x, levels[level], next - t);
            push(next, Moment::Before, levels[level], &x);
            let dv = 0.5 * (levels[1 - level] - levels[level]) * x[2] * x[2];
            x[1] = (x[1] * x[1] - 2.0 * dv / INERTIA).sqrt();
            level = 1 - level;
            push(next, Moment::After, levels[level], &x);
            t = next;
            next += if level == 0 { 6.04e-3 } else { 2.29e-3 };
        }
        advance(&mut x, levels[level], end - t);
        t = end;
        push(t, Moment::Sample, levels[level], &x);
    }
    run
}

/// Runge-Kutta steps of order 4 over `duration`, so short that only rounding errors remain in the residual.
fn advance(x: &mut [f64; 5], k: f64, duration: f64) {
    let rate = |x: &[f64; 5]| {
        let force = FORCE - DAMPING * x[3] - k * x[2];
        [x[1], 0.0, x[3], force / MASS, DAMPING * x[3] * x[3]]
    };
    let shifted = |x: &[f64; 5], f: &[f64; 5], h: f64| std::array::from_fn(|i| x[i] + h * f[i]);
    let steps = 16;
    let h = duration / steps as f64;
    for _ in 0..steps {
        let a = rate(x);
        let b = rate(&shifted(x, &a, 0.5 * h));
        let c = rate(&shifted(x, &b, 0.5 * h));
        let d = rate(&shifted(x, &c, h));
        for i in 0..5 {
            x[i] += h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
        }
    }
}
