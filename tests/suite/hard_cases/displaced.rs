//! Row 3: a phase at rest against a step of a transmission error: held, released, passed.

use gearsim::run::Outcome;

use crate::case::{Case, WRONG, count};
use crate::common;
use crate::contact::{Freed, K, REST, frequencies, pair_at_rest};
use crate::noise::Noise;

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
    Case {
        row: "3",
        name: "a train without a load at rest exactly at a step of a transmission error, by exact cells and dop853",
        proves: "it stays there, bit for bit, and meets no step in 20 random scenes: no force acts, so that none has a rounding error",
        tolerance: 0.0,
        unit: WRONG,
        reason: "its springs are not strained",
        measure: |_| unloaded(),
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

fn unloaded() -> f64 {
    let mut noise = Noise::new(7422);
    let scenes = [(); 20].map(|()| {
        let error = noise.power(-1.0, 2.0);
        let mut set = vec![
            r#"effects=["stiffness_step", "transmission_error"]"#.to_string(),
            format!(r#"meshes.12.error={{steps=[{{value="{error:?} um", width="2.5 rad"}}, {{value="0 um"}}]}}"#),
            format!("start.s12={error:?} um"),
            "start.speed=0 rpm".into(),
            "run.t_end=1 ms".into(),
        ];
        let rotors = ["1", "2", "motor", "a", "b"];
        set.extend(rotors.map(|rotor| format!("rotors.{rotor}={:?} kg*m^2", noise.power(-5.0, -1.0))));
        set
    });
    let methods: [&[String]; 2] = [&[], &["run.method=dop853".into()]];
    let sets = scenes.iter().flat_map(|scene| methods.map(|method| [scene, method].concat()));
    count(sets.map(|set| {
        let Outcome { trajectory, counts, .. } = common::run(&common::scene("train_branches", &set));
        let rests = |x: &Vec<f64>| x.first() == x.last();
        !(trajectory.q.iter().all(rests)
            && trajectory.q_dot.iter().flatten().all(|v| *v == 0.0)
            && counts.cell_changes == 0)
    }))
}
