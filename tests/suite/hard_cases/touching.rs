//! Row 11: flanks that just touch. Without a load they rest there. Under a load that rises from zero, the contact force rises slowly.

use gearsim::__private::{digits, error};
use gearsim::scene::Scene;
use gearsim::scene::solver::{Method, Solver};
use gearsim::trajectory::Moment;

use crate::case::{Case, WRONG, count, largest};
use crate::common;
use crate::noise::Noise;

pub const CASES: &[Case] = &[
    Case {
        row: "11",
        name: "a flank that rests at its edge without a load, beside gears that turn",
        proves: "no flank parts and none is met, by exact cells and by dop853: forces that are zero have no rounding error",
        tolerance: 0.0,
        unit: WRONG,
        reason: "the flank is exactly at the edge, and no force acts on it",
        measure: rests,
    },
    Case {
        row: "11",
        name: "a train that starts from rest under a torque that rises from zero, by dop853 and radau",
        proves: "the steps of a start-up, where the flanks touch and the first motions are below every rounding error: as many as its vibrations need",
        tolerance: 500.0,
        unit: "steps",
        reason: "0.1 ms are three periods of the fastest vibration, and a step is at least a hundredth of one once it moves",
        measure: starts,
    },
    Case {
        row: "11",
        name: "a loaded flank at rest beside gears that turn: exact cells and dop853",
        proves: "the speed of the deflection is zero except for rounding errors of the long steps of dop853, which its claimed error contains",
        tolerance: 10.0,
        unit: "of the claimed error",
        reason: "the claim is the distance to one other run; the error may be several times as large",
        measure: loaded,
    },
];

fn rests(note: &mut String) -> f64 {
    let mut noise = Noise::new(1120);
    let (mut scenes, mut wrong) = (0, 0.0);
    for _ in 0..60 {
        let play = noise.power(-4.0, -1.0);
        let set = [
            r#"effects=["backlash"]"#.into(),
            format!("parameters.b={play:?} rad"),
            format!("parameters.I1={:?} kg*m^2", noise.power(-4.0, 0.0)),
            format!("start.theta={:?} rad", noise.even()),
            format!("start.speed={:?} rad/s", noise.power(0.5, 3.0)),
            "start.phi=static".into(),
            "run.t_end=1 ms".into(),
        ];
        let methods: [&[String]; 2] = [&[], &["run.method=dop853".into()]];
        let runs = methods.map(|method| common::run(&common::scene("backlash", &[&set, method].concat())));
        // If the equilibrium is a rounding error beyond the edge, the spring is pressed, and the flank swings back.
        if runs[0].trajectory.q[1][0] > play / 2.0 {
            continue;
        }
        scenes += 1;
        wrong += count(runs.map(|run| {
            let events = run.trajectory.moment.iter().any(|moment| *moment != Moment::Sample);
            events || run.counts.impacts > 0
        }));
    }
    *note = format!("{scenes} scenes");
    if scenes < 40 { f64::INFINITY } else { wrong }
}

fn starts(note: &mut String) -> f64 {
    let steps = ["dop853", "radau"].map(|method| {
        let set = [format!("run.method={method}"), "run.t_end=0.1 ms".into()];
        let scene = common::scene("drives/start_up", &set);
        let run = common::run(&scene);
        // The companion is a second run, whose start is a few rounding errors away from the edge.
        let companion = common::run(&digits::companion(&scene, &run, false));
        let steps = [run, companion].map(|run| run.solver.steps + run.solver.rejected);
        *note += &format!("{method}: {} steps, {} from a start beside the edge; ", steps[0], steps[1]);
        largest(steps.map(|steps| steps as f64))
    });
    largest(steps)
}

fn loaded(_: &mut String) -> f64 {
    let mut noise = Noise::new(1121);
    largest((0..20).map(|_| {
        let set = [
            r#"effects=["damping", "backlash", "stiffness_step", "torques"]"#.into(),
            "parameters.b=1e-3 rad".into(),
            format!("parameters.T0={:?} N*m", noise.power(0.0, 2.0)),
            format!("start.speed={:?} rad/s", noise.power(0.5, 2.0)),
            "start.theta=0.1 rad".into(),
            "run.t_end=0.5 ms".into(),
            "run.tolerance=1e-12".into(),
        ];
        let scene = common::scene("oh2005/spectrum_600rpm_exact", &set);
        let exact = common::run(&scene);
        let scene = Scene { solver: Solver { method: Some(Method::Dop853), ..scene.solver }, ..scene };
        let run = |scene: &_| common::model("gear_pair").run(scene, &mut |_| {});
        let steps = digits::noted(&scene, common::run(&scene), &run);
        let claimed = 10f64.powf(-steps.digits.expect("a companion that runs").at_end);
        error::of(&steps, &exact, 0.0).end / claimed
    }))
}
