//! Row 3: a phase at rest against a step of a transmission error, held, let go, let through.

use gearsim::engine::Outcome;

use crate::case::{Case, largest};
use crate::common;
use crate::models::{end, residual};

pub const CASES: &[Case] = &[
    Case {
        row: "3",
        name: "held at a step of a transmission error, until the reaction pulls",
        proves: "held until phi has come to T0/k, then free: both in closed form",
        tolerance: 1e-13,
        unit: "of the motion's sizes",
        reason: "roundings; that it is let go when the reaction pulls by 1e-9 of its forces counts by its square",
        measure: |_| release(),
    },
    Case {
        row: "3",
        name: "held at a step of a transmission error, which vanishes",
        proves: "phi half-way between the errors makes dV = 0: theta slips through without loss, in closed form",
        tolerance: 1e-13,
        unit: "of the motion's sizes",
        reason: "roundings of closed forms and of the frequencies",
        measure: |_| slip(),
    },
];

/// Stiffness [N m], and the error of the tooth below theta = 0; that above it has none.
const K: f64 = 1430.0;
const BELOW: f64 = -4e-3;
/// phi at rest under 10 N m.
const REST: f64 = 10.0 / K;

/// The gear pair at rest at the boundary between the teeth.
fn at_rest(t0: f64, phi: f64, t_end: f64) -> Outcome {
    let overrides = [
        r#"effects=["stiffness_step", "transmission_error", "torques"]"#.into(),
        format!("laws.k.steps=[{{value=\"{K:?} N*m\"}}]"),
        format!("laws.e={{pitch_errors=[\"0 rad\", \"{BELOW:?} rad\"]}}"),
        format!("parameters.T0={t0:?} N*m"),
        "start.speed=0 rpm".into(),
        format!("start.phi={phi:?} rad"),
        format!("run.t_end={t_end:?} s"),
    ];
    common::run(&common::scene("oh2005/energy_300rpm", &overrides))
}

/// Angular frequencies of phi with theta free and with theta held; M1/M2.
fn frequencies() -> (f64, f64, f64) {
    let (a, b) = (0.00289 / 24f64.powi(2), 0.7402 / 96f64.powi(2));
    let (m1, m2) = ((1.0 / a - 1.0 / b) / 2.0, (1.0 / a + 1.0 / b) / 2.0);
    ((m2 * K).sqrt(), (2.0 * K / (a + b)).sqrt(), m1 / m2)
}

/// How far the motion is off at its end that goes on freely from `phi` with `speed` about `rest` for the time `after`, in units
/// of REST and of the speed; infinite where events are others, or energy is lost.
fn off(outcome: &Outcome, events: (u64, u64), phi: f64, speed: f64, rest: f64, after: f64) -> f64 {
    if (outcome.counts.holds, outcome.counts.cell_changes) != events || residual(outcome) > 1e-14 {
        return f64::INFINITY;
    }
    let (w, _, ratio) = frequencies();
    let (s, c) = (w * after).sin_cos();
    let (x, v) = (rest + (phi - rest) * c + speed / w * s, -(phi - rest) * w * s + speed * c);
    let expected = [ratio * (x - phi - speed * after), x, ratio * (v - speed), v];
    let (q, q_dot) = end(outcome);
    let sizes = [REST, REST, speed.abs(), speed.abs()];
    largest([q[0], q[1], q_dot[0], q_dot[1]].iter().zip(expected).zip(sizes).map(|((x, e), size)| (x - e).abs() / size))
}

/// phi = 3 T0/k presses theta down, where the error is lower and the spring's energy higher: held, until phi = T0/k.
fn release() -> f64 {
    let (free, held, _) = frequencies();
    let after = 0.3 / free;
    let outcome = at_rest(10.0, 3.0 * REST, std::f64::consts::FRAC_PI_2 / held + after);
    off(&outcome, (1, 0), REST, -2.0 * REST * held, REST, after)
}

/// phi swings about -REST, the rest under -10 N m, and meets the middle of the errors before theta would leave.
fn slip() -> f64 {
    let (free, held, _) = frequencies();
    let (start, middle, after) = (1e-2, BELOW / 2.0, 0.2 / free);
    let size = start + REST;
    let cos = (middle + REST) / size;
    let outcome = at_rest(-10.0, start, cos.acos() / held + after);
    off(&outcome, (1, 1), middle, -size * held * (1.0 - cos * cos).sqrt(), BELOW - REST, after)
}
