//! Row 16: an effect that is absent, compared with the effect at zero strength.

use gearsim::run::Outcome;
use gearsim::scene::Scene;

use crate::case::{Case, NONE, WRONG, count, largest};
use crate::common;

pub const CASES: &[Case] = &[
    Case {
        row: "16",
        name: "no damping and no torques, compared with zeta = 0 and T0 = 0",
        proves: "the same bits, for all forms of the equations",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: bits,
    },
    Case {
        row: "16",
        name: "no step, compared with a step of height zero",
        proves: "the same motion, although it is divided into cells",
        tolerance: 1e-12,
        unit: "of the largest of a column",
        reason: "rounding errors of a hundred cells",
        measure: steps,
    },
    Case {
        row: "16",
        name: "evaluations of the motion without steps",
        proves: "an absent effect costs nothing: one evaluation per run, whatever boundaries are passed",
        tolerance: 1.0,
        unit: "evaluations",
        reason: "the run is one flight",
        measure: |_| flat("effects=[]").counts.cost.evaluations as f64,
    },
];

fn scene(overrides: &[&str]) -> Scene {
    let usual =
        ["parameters.T0=0 N*m", "parameters.zeta=0", "start.phi=static", "output.rate=10 kHz", "run.t_end=0.1 s"];
    let all: Vec<String> = usual.iter().chain(overrides).map(|s| s.to_string()).collect();
    common::scene("oh2005/energy_300rpm", &all)
}

fn bits(note: &mut String) -> f64 {
    let mut rows = 0;
    let wrong = ["", "\"rigid_kinematics\"", "\"frozen_phase\""].into_iter().flat_map(|equations| {
        let run = |effects: &str| {
            let effects = format!("effects=[\"stiffness_step\", {equations} {effects}]");
            common::run(&scene(&[&effects.replace(",  ", ", "), "start.phi_dot=20 rad/s"])).trajectory
        };
        let comma = if equations.is_empty() { "" } else { "," };
        let without = run("");
        rows += without.len();
        ["\"damping\"", "\"torques\"", "\"damping\", \"torques\""].map(|zero| {
            let with = run(&format!("{comma} {zero}"));
            let same = |a: &[f64], b: &[f64]| a.iter().map(|x| x.to_bits()).eq(b.iter().map(|x| x.to_bits()));
            let columns = |t: &gearsim::trajectory::Trajectory| {
                [&t.t, &t.q[0], &t.q[1], &t.q_dot[0], &t.q_dot[1], &t.kinetic, &t.strain].map(|c| c.clone())
            };
            count(columns(&without).iter().zip(&columns(&with)).map(|(a, b)| !same(a, b)))
        })
    });
    let wrong = wrong.sum();
    *note = format!("{rows} rows");
    wrong
}

/// A run with these effects, whose stiffness has the same level everywhere.
fn flat(effects: &str) -> Outcome {
    let steps = "laws.k.steps=[{ value = \"2 kN*m\", width = \"1.73 rad\" }, { value = \"2 kN*m\" }]";
    common::run(&scene(&[effects, steps, "start.phi_dot=20 rad/s", "output.events=false"]))
}

fn steps(note: &mut String) -> f64 {
    let (without, with) = (flat("effects=[]"), flat("effects=[\"stiffness_step\"]"));
    *note = format!("{} cells", with.counts.cell_changes);
    let (a, b) = (without.trajectory, with.trajectory);
    let differ = |a: &[f64], b: &[f64]| {
        let size = largest(a.iter().map(|x| x.abs()));
        largest(a.iter().zip(b).map(|(a, b)| (a - b).abs() / size))
    };
    largest((0..2).flat_map(|i| [differ(&a.q[i], &b.q[i]), differ(&a.q_dot[i], &b.q_dot[i])]))
}
