//! Row 3: a phase at rest against a step of a transmission error: held, released, passed.

use gearsim::run::Outcome;

use crate::case::Case;
use crate::contact::{Freed, K, REST, frequencies, pair_at_rest};

pub const CASES: &[Case] = &[
    Case {
        row: "3",
        name: "held at a step of a transmission error, until the reaction pulls",
        proves: "held until phi = T0/k, then free: both in closed form",
        tolerance: 1e-13,
        unit: "of the motion's sizes",
        reason: "rounding errors; the release is late, at a pull of 1e-9 of the forces, and this delay counts squared",
        measure: |_| release(),
    },
    Case {
        row: "3",
        name: "held at a step of a transmission error, until dV vanishes",
        proves: "dV = 0 when phi is half-way between the errors: theta passes the step without loss, in closed form",
        tolerance: 1e-13,
        unit: "of the motion's sizes",
        reason: "rounding errors of closed forms and of the frequencies",
        measure: |_| slip(),
    },
];

/// The error [rad] of the tooth below theta = 0. The tooth above has none.
const BELOW: f64 = -4e-3;

/// Runs the gear pair with one stiffness from rest at the boundary between the teeth.
fn at_rest(t0: f64, phi: f64, t_end: f64) -> Outcome {
    let others = [
        r#"effects=["stiffness_step", "transmission_error", "torques"]"#,
        &format!("laws.k.steps=[{{value=\"{K:?} N*m\"}}]"),
        &format!("laws.e={{pitch_errors=[\"0 rad\", \"{BELOW:?} rad\"]}}"),
    ];
    pair_at_rest(t0, phi, t_end, &others)
}

/// phi = 3 T0/k presses theta downwards, where the error is lower and the spring's energy higher. theta is held until phi = T0/k.
fn release() -> f64 {
    let (free, held, _) = frequencies(K);
    let after = 0.3 / free;
    let outcome = at_rest(10.0, 3.0 * REST, std::f64::consts::FRAC_PI_2 / held + after);
    Freed { phi: REST, speed: -2.0 * REST * held, k: K, rest: REST, after }.off(&outcome, (1, 0), 1e-14)
}

/// phi swings about -REST, the static deflection under -10 N m, and reaches the middle of the two errors before the reaction pulls.
fn slip() -> f64 {
    let (free, held, _) = frequencies(K);
    let (start, middle, after) = (1e-2, BELOW / 2.0, 0.2 / free);
    let size = start + REST;
    let cos = (middle + REST) / size;
    let outcome = at_rest(-10.0, start, cos.acos() / held + after);
    let speed = -size * held * (1.0 - cos * cos).sqrt();
    Freed { phi: middle, speed, k: K, rest: BELOW - REST, after }.off(&outcome, (1, 1), 1e-14)
}
