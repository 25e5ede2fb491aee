//! Row 11: play whose edges a transmission error moves. Flanks separate and meet at its steps, and where it varies smoothly.

use std::f64::consts::{PI, TAU};

use gearsim::run::Outcome;
use gearsim::scene::Scene;

use crate::case::{Case, largest};
use crate::common;
use crate::contact::K;
use crate::models::{end, residual};
use crate::noise::Noise;
use crate::rattle::{apart_by_steps, before, constants, rattling, rk4};

pub const CASES: &[Case] = &[
    Case {
        row: "11",
        name: "flanks that separate at a step of a transmission error",
        proves: "the spring's energy goes into the rotation; the flight until the next contact is ballistic, in closed form",
        tolerance: 1e-12,
        unit: "of the motion's sizes",
        reason: "rounding errors of closed forms",
        measure: |_| parted(),
    },
    Case {
        row: "11",
        name: "flanks that meet at a step of a transmission error, transmitted and reflected",
        proves: "the rotation gives the spring its energy, or is reflected, in closed form",
        tolerance: 1e-12,
        unit: "of the motion's sizes",
        reason: "rounding errors of closed forms",
        measure: |_| largest([met(1000.0), met(10.0)]),
    },
    Case {
        row: "11",
        name: "held at a step of a transmission error, until the flanks beyond it separate",
        proves: "theta rests while phi moves freely; when no spring would be strained beyond the step, theta moves on, in closed form",
        tolerance: 1e-12,
        unit: "of the motion's sizes",
        reason: "rounding errors of closed forms",
        measure: |_| held(),
    },
    Case {
        row: "11",
        name: "gear pairs with pitch errors that rattle: the energy account",
        proves: "the account closes where flanks separate and meet at steps",
        tolerance: 1e-12,
        unit: "of the energy at the start",
        reason: "about 1000 events, each with a few rounding errors",
        measure: accounted,
    },
    Case {
        row: "11",
        name: "gear pairs with pitch errors that rattle, by dop853",
        proves: "the step method gives the same contacts and the same end",
        tolerance: 1e-8,
        unit: "of the motion's sizes",
        reason: "the tolerance of the steps, 1e-13, times its growth by impacts and steps of stiffness",
        measure: by_steps,
    },
    Case {
        row: "11",
        name: "play with a harmonic transmission error, by dop853",
        proves: "an integration by small steps of a right-hand side with min and max gives the same motion",
        tolerance: 1e-9,
        unit: "of b, of v",
        reason: "the integration steps across the kinks of the force",
        measure: waves,
    },
];

/// Half the play [rad].
const HALF: f64 = 0.02;

/// Runs the gear pair without damping. `errors` [rad] are those of the tooth below theta = 2 pi and of the tooth above. `theta` and `phi`
/// each give the angle [rad] and the speed [rad/s] at the start.
fn pair(t0: f64, errors: [f64; 2], theta: [f64; 2], phi: [f64; 2], t_end: f64) -> Outcome {
    common::run(&common::scene(
        "backlash",
        &[
            r#"effects=["stiffness_step", "transmission_error", "backlash", "torques"]"#.into(),
            format!("laws.k.steps=[{{value=\"{K:?} N*m\"}}]"),
            format!("laws.e={{pitch_errors=[\"{:?} rad\", \"{:?} rad\"]}}", errors[0], errors[1]),
            format!("parameters.T0={t0:?} N*m"),
            format!("parameters.b={:?} rad", 2.0 * HALF),
            format!("start.theta={:?} rad", theta[0]),
            format!("start.theta_dot={:?} rad/s", theta[1]),
            format!("start.phi={:?} rad", phi[0]),
            format!("start.phi_dot={:?} rad/s", phi[1]),
            format!("run.t_end={t_end:?} s"),
        ],
    ))
}

/// The edge rises by 4e-3 above a contact of depth x: v+² = v² + M2 k x².
fn parted() -> f64 {
    let (m1, m2, _) = constants(0.0);
    let (t0, error, v) = (20.0, 4e-3, 300.0);
    let outcome = pair(t0, [0.0, error], [TAU - 1e-7, v], [HALF + 2e-3, 0.0], 2e-3);
    let run = &outcome.trajectory;
    let [step, edge, ..] = before(run).collect::<Vec<_>>()[..] else { return f64::INFINITY };
    let (x, v) = (run.q[1][step] - HALF, run.q_dot[0][step]);
    let after = (v * v + m2 * K * x * x).sqrt();
    let kick = m1 / m2 * (after - v);
    let (phi, speed) = (run.q[1][step], run.q_dot[1][step] + kick);
    let t = run.t[edge] - run.t[step];
    let expected = [
        (run.q_dot[0][step + 1], after, v),
        (run.q_dot[1][step + 1], speed, speed.abs()),
        (run.q[1][edge], HALF + error, HALF),
        (run.q[1][edge], phi + speed * t + 0.5 * m2 * t0 * t * t, HALF),
        (run.q_dot[1][edge], speed + m2 * t0 * t, speed.abs()),
        (run.q_dot[0][edge], after + m1 * t0 * t, v),
    ];
    if outcome.counts.impacts == 0 || residual(&outcome) > 1e-14 {
        return f64::INFINITY;
    }
    largest(expected.map(|(ours, closed, size)| (ours - closed).abs() / size))
}

/// The edge falls by 4e-3. The deflection is then beyond the edge by the depth x, about 1e-3: v+² = v² - M2 k x² if this is not negative;
/// otherwise theta is reflected.
fn met(start: f64) -> f64 {
    let (m1, m2, _) = constants(0.0);
    let (t0, theta, after) = (5.0, TAU - 1e-6, 2e-5);
    // The free flight to the boundary.
    let way = TAU - theta;
    let early = 2.0 * way / (start + (start * start + 2.0 * m1 * t0 * way).sqrt());
    let v = start + m1 * t0 * early;
    let (x, before) = (1e-3 + 0.5 * m2 * t0 * early * early, m2 * t0 * early);
    let outcome = pair(t0, [4e-3, 0.0], [theta, start], [HALF + 1e-3, 0.0], early + after);
    let reflected = v * v < m2 * K * x * x;
    let beyond = if reflected { -v } else { (v * v - m2 * K * x * x).sqrt() };
    let kick = before + m1 / m2 * (beyond - v);
    let (phi, speed) = if reflected {
        (HALF + x + kick * after + 0.5 * m2 * t0 * after * after, kick + m2 * t0 * after)
    } else {
        let (w, rest) = ((m2 * K).sqrt(), t0 / K);
        let (s, c) = (w * after).sin_cos();
        (HALF + rest + (x - rest) * c + kick / w * s, kick * c - (x - rest) * w * s)
    };
    // Only the force of phi acts on theta: theta'' = (M1/M2) phi''.
    let theta_dot = beyond + m1 / m2 * (speed - kick);
    let passed = u64::from(!reflected);
    let counts = &outcome.counts;
    if (counts.reflections, counts.cell_changes, counts.impacts) != (1 - passed, passed, passed)
        || residual(&outcome) > 1e-14
    {
        return f64::INFINITY;
    }
    let (q, q_dot) = end(&outcome);
    let expected = [(q[1], phi, HALF), (q_dot[1], speed, kick.abs()), (q_dot[0], theta_dot, v)];
    largest(expected.map(|(ours, closed, size)| (ours - closed).abs() / size))
}

/// theta is at rest and is driven downwards against the step, below which the contact would have the depth x. phi moves back freely:
/// x - v t - A t²/2.
fn held() -> f64 {
    let (m1, m2, _) = constants(0.0);
    let inertia: f64 = 2890e-6 / 576.0 + 740200e-6 / 9216.0;
    let (t0, x, v) = (-10.0, 1e-3, 40.0);
    let a = -2.0 * t0 / inertia;
    let met = 2.0 * x / (v + (v * v + 2.0 * a * x).sqrt());
    let (speed, after) = (-v - a * met, 1e-5);
    let outcome = pair(t0, [0.0, 4e-3], [TAU, 0.0], [HALF + x, -v], met + after);
    let (q, q_dot) = end(&outcome);
    let expected = [
        (q[0] - TAU, 0.5 * m1 * t0 * after * after, HALF),
        (q[1], HALF + speed * after + 0.5 * m2 * t0 * after * after, HALF),
        (q_dot[0], m1 * t0 * after, v),
        (q_dot[1], speed + m2 * t0 * after, v),
    ];
    if (outcome.counts.holds, outcome.counts.cell_changes) != (1, 1) || residual(&outcome) > 1e-14 {
        return f64::INFINITY;
    }
    largest(expected.map(|(ours, closed, size)| (ours - closed).abs() / size))
}

/// A gear pair that rattles, with errors of three teeth of the size of its play.
fn uneven(noise: &mut Noise) -> Scene {
    let errors: Vec<_> = (0..3).map(|_| format!("\"{:?} rad\"", 2e-2 * noise.even())).collect();
    let more = [
        r#"effects=["stiffness_step", "transmission_error", "backlash", "damping", "torques"]"#.into(),
        format!("laws.e={{pitch_errors=[{}]}}", errors.join(", ")),
    ];
    rattling(noise, &more)
}

fn accounted(note: &mut String) -> f64 {
    let mut noise = Noise::new(1105);
    let outcomes: Vec<_> = (0..60).map(|_| common::run(&uneven(&mut noise))).collect();
    let total = |of: fn(&gearsim::run::Counts) -> u64| outcomes.iter().map(|o| of(&o.counts)).sum::<u64>();
    let (impacts, changes, reflections) = (total(|c| c.impacts), total(|c| c.cell_changes), total(|c| c.reflections));
    *note = format!("60 scenes, {impacts} impacts, {changes} cell changes, {reflections} reflections");
    largest(outcomes.iter().map(residual))
}

fn by_steps(note: &mut String) -> f64 {
    let mut noise = Noise::new(1106);
    apart_by_steps((0..20).map(|_| uneven(&mut noise)), note)
}

fn waves(note: &mut String) -> f64 {
    let (zeta, half, t0, k, size, t_end) = (0.05, 0.005, 2.0, 2105.0, 4e-3, 4e-3);
    let scene = common::scene(
        "backlash",
        &[
            r#"effects=["stiffness_step", "transmission_error", "backlash", "damping", "torques"]"#.into(),
            format!("laws.k.steps=[{{value=\"{k:?} N*m\"}}]"),
            format!("laws.e.harmonics=[{{order=1, amplitude=\"{size:?} rad\"}}]"),
            format!("parameters.zeta={zeta:?}"),
            format!("parameters.T0={t0:?} N*m"),
            format!("parameters.b={:?} rad", 2.0 * half),
            "start={theta=0, theta_dot=\"3000 rad/s\", phi=0, phi_dot=\"-150 rad/s\"}".into(),
            format!("run={{t_end=\"{t_end:?} s\", method=\"dop853\", tolerance=1e-12}}"),
        ],
    );
    let outcome = common::run(&scene);
    *note = format!("{} impacts", outcome.counts.impacts);
    if outcome.counts.impacts < 6 {
        return f64::INFINITY;
    }
    let (m1, m2, c) = constants(zeta);
    let rate = |[theta, phi, theta_dot, v]: [f64; 4]| {
        let (error, slope) = (size * theta.cos(), -size * theta.sin());
        let (x, side) = ((phi - error).abs() - half, (phi - error).signum());
        let spring = if x > 0.0 { k * x * side } else { 0.0 };
        let damper = (c * v).clamp(-spring.abs(), spring.abs());
        let (push, force) = (spring * slope, spring + damper);
        [theta_dot, v, m1 * (t0 - force) + m2 * push, m2 * (t0 - force) + m1 * push]
    };
    let y = rk4(rate, [0.0, 0.0, 3000.0, -150.0], t_end, 2_000_000);
    let (q, v) = end(&outcome);
    let theta = (q[0] - y[0] + PI).rem_euclid(TAU) - PI;
    largest([theta.abs() / TAU, (q[1] - y[1]).abs() / (2.0 * half), (v[1] - y[3]).abs() / 150.0, residual(&outcome)])
}
