//! Row 21: a damaged tooth, whose pair carries less once a turn of its gear.

use std::f64::consts::TAU;

use crate::case::{Case, largest};
use crate::common;

pub const CASES: &[Case] = &[
    Case {
        row: "21",
        name: "a damaged tooth at creeping speed",
        proves: "phi = T0/k at every place of the turn, k less by the lost part of the share of the damaged pair",
        tolerance: 1e-9,
        unit: "of T0/k",
        reason: "the vibration after a step has decayed to exp(-22) at each sample taken",
        measure: |_| creeping(),
    },
    Case {
        row: "21",
        name: "a damaged tooth has sidebands at the speed of its gear",
        proves: "lines at the mesh order plus and minus one speed of the pinion, below 1e-6 of these without damage",
        tolerance: 1e-6,
        unit: "of the lines with damage",
        reason: "the transient of the start, at the end of the window",
        measure: sidebands,
    },
    Case {
        row: "21",
        name: "a damaged tooth: exact cells and steps",
        proves: "the same end of the run by both, after 15 turns of the damaged gear",
        tolerance: 1e-9,
        unit: "of the deflection",
        reason: "the tolerance of the steps, 1e-12, over 720 steps of the stiffness",
        measure: |_| two_methods(),
    },
];

fn run(others: &[&str]) -> gearsim::run::Outcome {
    let others: Vec<String> = others.iter().map(|s| s.to_string()).collect();
    common::run(&common::scene("damaged_tooth", &others))
}

const FROZEN: &str = r#"effects=["stiffness_step", "frozen_phase", "damping", "torques"]"#;

/// At 6 rpm the mesh passes a pitch in 0.42 s, and the vibration decays within 0.03 s.
fn creeping() -> f64 {
    let outcome = run(&[FROZEN, "start.speed=6 rpm", "run.t_end=10 s", "output.rate=600 Hz"]);
    let (mut worst, mut taken) = (0.0f64, 0);
    for i in outcome.trajectory.samples() {
        let phase = outcome.trajectory.t[i] * 6.0 / 60.0 * 24.0;
        let (pitch, s) = (phase.floor(), phase.fract() * TAU);
        let since_a_step = if s < 1.73 { s } else { s - 1.73 };
        // 0.03 s, in radians of the phase.
        if since_a_step < 0.03 * 2.4 * TAU {
            continue;
        }
        let pairs = if s < 1.73 { 1.0 } else { 2.0 };
        let sound = if s < 1.73 { 1430.0 } else { 2780.0 };
        let damaged = (pitch == 4.0 && pairs == 2.0) || pitch == 5.0;
        let k = if damaged { sound * (1.0 - 0.33 / pairs) } else { sound };
        worst = largest([worst, (outcome.trajectory.q[1][i] * k / 10.0 - 1.0).abs()]);
        taken += 1;
    }
    if taken > 3000 { worst } else { f64::NAN }
}

/// The amplitude of phi [rad] at this order of the pinion, over the last ten turns.
fn line(outcome: &gearsim::run::Outcome, order: f64) -> f64 {
    let samples: Vec<usize> = outcome.trajectory.samples().collect();
    let last = &samples[samples.len() - 7201..samples.len() - 1];
    let sum = last.iter().enumerate().fold((0.0, 0.0), |(a, b), (n, &i)| {
        let (sin, cos) = (TAU * order * n as f64 / 720.0).sin_cos();
        (a + outcome.trajectory.q[1][i] * cos, b + outcome.trajectory.q[1][i] * sin)
    });
    2.0 * f64::hypot(sum.0, sum.1) / 7200.0
}

fn sidebands(note: &mut String) -> f64 {
    let all = [FROZEN, "output.rate=54 kHz"];
    let (damaged, sound) = (run(&all), run(&[&all[..], &["laws.k.damage=[]"]].concat()));
    let orders = [1.0, 23.0, 25.0, 47.0, 49.0];
    *note = format!(
        "beside the mesh order {:.1e} rad, the order itself {:.1e}",
        line(&damaged, 23.0),
        line(&damaged, 24.0)
    );
    largest(orders.map(|order| line(&sound, order) / line(&damaged, order)))
}

fn two_methods() -> f64 {
    let [exact, steps] =
        [run(&["run.t_end=0.2 s"]), run(&["run.t_end=0.2 s", "run.method=dop853", "run.tolerance=1e-12"])];
    if exact.counts.cell_changes != steps.counts.cell_changes {
        return f64::INFINITY;
    }
    let last = |outcome: &gearsim::run::Outcome, i: usize| *outcome.trajectory.q[i].last().expect("a row");
    let apart = |i: usize, size: f64| (last(&exact, i) - last(&steps, i)).abs() / size;
    // The error of the rotation is relative to one pitch, because whole pitches are counted separately.
    largest([apart(1, 10.0 / 1430.0), apart(0, TAU)])
}
