//! Motors and loads: the scenes of `models/scenes/drives`, compared with balances of torque and energy computed without a simulation.

mod common;
#[path = "drives/traction.rs"]
mod traction;
#[path = "drives/varying.rs"]
mod varying;

use common::{run, scene};
use gearsim::run::Outcome;
use gearsim::scene::Scene;

fn named(scene: &Scene, name: &str) -> f64 {
    scene.parameter(name).unwrap_or_else(|| panic!("no {name}"))
}

/// Mean speed of the motor [rad/s] over the last `part` (0 to 1) of a run. The model's coordinates are theta, s, psi_m, psi_l.
fn motor_speed(scene: &Scene, outcome: &Outcome, part: f64) -> f64 {
    let t = &outcome.trajectory;
    let (n1, h) = (named(scene, "N1"), named(scene, "r1") / named(scene, "N1"));
    let angle = |row: usize| (t.q[0][row] + 0.5 * t.q[1][row] / h) / n1 + t.q[2][row];
    let last = t.len() - 1;
    let first = t.t.iter().position(|x| *x >= t.t[last] * (1.0 - part)).expect("there are rows");
    (angle(last) - angle(first)) / (t.t[last] - t.t[first])
}

/// A run of the scene `freewheel` with other values.
fn freewheel(set: &[&str]) -> Outcome {
    run(&scene("freewheel", &set.iter().map(|s| s.to_string()).collect::<Vec<_>>()))
}

/// Largest residual of the energy account T + V - W + D, relative to the largest of the four parts.
fn unaccounted(outcome: &Outcome) -> f64 {
    let t = &outcome.trajectory;
    let peak = |column: &[f64]| column.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    let scale = [&t.kinetic, &t.strain, &t.work, &t.dissipated].map(|c| peak(c)).into_iter().fold(0.0, f64::max);
    peak(&t.residual) / scale
}

/// The motor speed [rad/s] at which the motor's torque, by the formula of Kloss, equals the torques of the fan and of damping,
/// both referred to the motor shaft. Found by bisection.
fn working_point(scene: &Scene) -> f64 {
    let of = |name| named(scene, name);
    let ratio = of("N1") / of("N2");
    let damping = of("alpha_M") * (of("I_m") + of("I1") + (of("I2") + of("I_l")) * ratio * ratio);
    let excess = |omega: f64| {
        let slip = 1.0 - omega / of("ns_motor");
        let motor = 2.0 * of("Tb_motor") / (slip / of("sb_motor") + of("sb_motor") / slip);
        let fan = of("cf_load") * (ratio * omega).powi(2);
        motor - ratio * fan - damping * omega
    };
    let (mut low, mut high) = (0.9 * of("ns_motor"), of("ns_motor") * (1.0 - 1e-12));
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if excess(middle) > 0.0 { low = middle } else { high = middle }
    }
    low
}

/// The run starts at rest on a step. The shaft winds up slowly and pulls the train off the step. No method may report events
/// there that do not exist.
#[test]
fn methods_leave_a_step_from_rest_without_false_events() {
    let by = |method: &str, tolerance: f64| {
        let solver =
            [format!("run.method={method}"), format!("run.tolerance={tolerance:e}"), "run.t_end=0.04 s".into()];
        let outcome = run(&scene("drives/fan_run_up", &solver));
        let t = &outcome.trajectory;
        (outcome.counts.cell_changes, t.q[0][t.len() - 1])
    };
    let reference = by("dop853", 1e-12);
    assert!(reference.0 > 0);
    for method in ["dopri5", "dop853", "radau"] {
        for tolerance in [1e-5, 1e-8, 1e-11] {
            let (changes, angle) = by(method, tolerance);
            assert_eq!(changes, reference.0, "{method} at {tolerance:e}");
            assert!((angle - reference.1).abs() < 1e4 * tolerance, "{method} at {tolerance:e}: {angle}");
        }
    }
}

#[test]
fn a_motor_and_a_fan_reach_their_working_point() {
    let scene = scene("drives/fan_run_up", &[]);
    let outcome = run(&scene);
    assert_eq!(outcome.solver.method, "dop853");
    for said in ["in the torque `induction_motor`", "in the torque `fan_load`"] {
        assert!(outcome.solver.why.contains(said), "{}", outcome.solver.why);
    }
    let (found, expected) = (motor_speed(&scene, &outcome, 0.2), working_point(&scene));
    assert!((found / expected - 1.0).abs() < 1e-3, "{found} {expected}");
    assert!(unaccounted(&outcome) < 1e-6, "{:e}", unaccounted(&outcome));
    // The motor does positive work and the fan negative work.
    let t = &outcome.trajectory;
    let works = ["induction_motor", "fan_load"]
        .map(|name| *t.work_of(name).expect("a torque of the scene").last().expect("rows"));
    assert!(works[0] > 0.0 && works[1] < 0.0, "{works:?}");
}

/// The speed falls below the set point by the load torque over the gain.
#[test]
fn the_droop_of_a_governor_is_torque_over_gain() {
    let scene = scene("drives/governor", &["output.rate=\"50 kHz\"".into()]);
    let outcome = run(&scene);
    assert_eq!(outcome.solver.method, "exact");
    let ratio = named(&scene, "N1") / named(&scene, "N2");
    let droop = 100.0 * ratio / named(&scene, "c_motor");
    let (found, expected) = (motor_speed(&scene, &outcome, 0.1), named(&scene, "n_motor") - droop);
    assert!((found / expected - 1.0).abs() < 2e-3, "{found} {expected}");
    assert!(unaccounted(&outcome) < 1e-11, "{:e}", unaccounted(&outcome));
}

/// A governor with a set point that varies in time is solved exactly too, although its damping couples the modes. Compared with
/// DOP853.
#[test]
fn a_set_point_that_varies_is_solved_exactly() {
    let set: Vec<String> = [
        "parameters.n_motor={ramp={from=\"600 rpm\", to=\"700 rpm\", start=\"10 ms\", duration=\"20 ms\"}, \
         harmonics=[{amplitude=\"5 rpm\", frequency=\"150 Hz\"}]}",
        "run.t_end=\"50 ms\"",
        "output.events=false",
    ]
    .map(String::from)
    .into();
    let exact = run(&scene("drives/governor", &set));
    assert_eq!(exact.solver.method, "exact");
    assert!(unaccounted(&exact) < 1e-12, "{:e}", unaccounted(&exact));
    let by = [set, vec!["run.method=dop853".into(), "run.tolerance=1e-12".into()]].concat();
    let steps = run(&scene("drives/governor", &by));
    assert_eq!(steps.counts.cell_changes, exact.counts.cell_changes);
    for (a, b) in steps.trajectory.q_dot.iter().zip(&exact.trajectory.q_dot) {
        let size = b.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        let off = a.iter().zip(b).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
        assert!(off < 1e-6 * size, "{off:e} of {size:e}");
    }
}

/// Torques that vary in time, as ramps, levels and harmonics, are solved exactly and the energy account closes.
#[test]
fn torques_that_vary_in_time_are_solved_exactly() {
    for name in ["drives/start_up", "drives/torque_ripple"] {
        let outcome = run(&scene(name, &[]));
        assert_eq!(outcome.solver.method, "exact");
        assert!(outcome.solver.why.contains("f that varies in time with `T_motor`"), "{}", outcome.solver.why);
        assert!(unaccounted(&outcome) < 1e-11, "{name}: {:e}", unaccounted(&outcome));
    }
}

/// A DC motor moves as a governor whose gain is stall torque over no-load speed.
#[test]
fn a_dc_motor_moves_as_the_equivalent_governor() {
    let set = |more: &[&str]| more.iter().map(|s| s.to_string()).collect::<Vec<_>>();
    let end = ["run.t_end=\"20 ms\""];
    let governor = run(&scene(
        "drives/governor",
        &set(&[&end[..], &["parameters.n_motor=\"80 rad/s\"", "parameters.c_motor=\"8 N*m*s/rad\""]].concat()),
    ));
    let dc = run(&scene(
        "drives/governor",
        &set(&[
            &end[..],
            &[
                "effects=[\"stiffness_step\", \"torques\", \"dc_motor\"]",
                "parameters.n0_motor=\"80 rad/s\"",
                "parameters.Ts_motor=\"640 N*m\"",
            ],
        ]
        .concat()),
    ));
    let off = |a: &[Vec<f64>], b: &[Vec<f64>]| {
        a.iter().flatten().zip(b.iter().flatten()).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()))
    };
    assert!(off(&governor.trajectory.q, &dc.trajectory.q) < 1e-11);
}

/// In derived models each rotor on which a constant torque acts has every motor, one at a time, and a fan, with the exceptions named below. A
/// train has those that its tables list.
#[test]
fn every_rotor_has_every_drive_and_load() {
    const MOTORS: [&str; 4] = ["governor", "dc", "induction", "traction"];
    for model in common::models().into_iter().filter(|model| model.elements.is_empty()) {
        let has =
            |name: &String| assert!(model.effects.iter().any(|e| e.name == *name), "{} has no {name}", model.name);
        let excludes = |a: &str, b: &str| {
            let lists = |a: &str, b: &str| model.effects.iter().any(|e| e.name == a && e.excludes.contains(&b));
            assert!(lists(a, b) || lists(b, a), "{}: {a} and {b} together", model.name);
        };
        let of_torques = model.torques.iter().filter(|torque| torque.with.contains(&"torques"));
        let rotors: Vec<&str> = match model.name {
            // One torque for both gears.
            "gear_pair" => vec!["motor", "load"],
            // The load is behind the joint, where the speed is not linear in the coordinates. The machines are before it, on gear 2.
            "cardan_drive" => vec!["motor", "2"],
            _ => of_torques.map(|torque| torque.name).filter(|name| *name != "piston").collect(),
        };
        assert!(!rotors.is_empty(), "{}", model.name);
        for rotor in rotors {
            has(&format!("fan_{rotor}"));
            let motors = MOTORS.map(|motor| format!("{motor}_{rotor}"));
            motors.iter().for_each(has);
            for (i, a) in motors.iter().enumerate() {
                motors[i + 1..].iter().for_each(|b| excludes(a, b));
            }
        }
    }
}

/// A test bench: a DC motor drives, and a second one at the other end of the gears brakes as a generator. The speed is that at which both
/// torques are in balance.
#[test]
fn a_second_motor_brakes_as_a_generator() {
    let set = [
        "effects=[\"stiffness_step\", \"damping\", \"torques\", \"dc\"]",
        "parameters.Ts_motor=\"640 N*m\"",
        "parameters.n0_motor=\"80 rad/s\"",
        "parameters.Ts_load=\"200 N*m\"",
        "parameters.n0_load=\"5 rad/s\"",
        "parameters.T_load=\"0 N*m\"",
        "parameters.beta_K=\"40 us\"",
        "start.speed=\"500 rpm\"",
        "run.t_end=\"3 s\"",
    ];
    let scene = scene("drives/governor", &set.map(String::from));
    let outcome = run(&scene);
    assert_eq!(outcome.solver.method, "exact");
    let ratio = named(&scene, "N1") / named(&scene, "N2");
    // Ts (1 - w/n0) + ratio Ts' (1 - ratio w/n0') = 0.
    let (a, b) = (640.0 / 80.0, 200.0 / 5.0);
    let expected = (640.0 + ratio * 200.0) / (a + b * ratio * ratio);
    let found = motor_speed(&scene, &outcome, 0.1);
    assert!((found / expected - 1.0).abs() < 1e-4, "{found} {expected}");
    assert!(ratio * expected > 5.0, "the second motor turns above its no-load speed");
    let t = &outcome.trajectory;
    // The outputs have the powers of the whole torques: the first motor drives, the second one brakes.
    let output = |name: &str| t.output(name).expect("an output");
    for (rotor, part, [stall, free]) in [("m", "motor", [640.0, 80.0]), ("l", "load", [200.0, 5.0])] {
        let (speed, power) = (output(&format!("rotor_speed_{rotor}")), output(&format!("net_power_dc_{part}")));
        for (omega, power) in speed.iter().zip(power) {
            let by_hand = stall * (1.0 - omega / free) * omega;
            assert!((power - by_hand).abs() < 1e-9 * (stall * omega).abs().max(1.0), "{part}: {power} W, {by_hand} W");
        }
    }
    let last = |part: &str| *output(&format!("net_power_dc_{part}")).last().expect("rows");
    assert!(last("motor") > 0.0 && last("load") < 0.0, "{} {}", last("motor"), last("load"));
    assert!(unaccounted(&outcome) < 1e-11, "{:e}", unaccounted(&outcome));
}

/// The scene `electric_axle`: the reason for the method names the nonlinear terms. Without these terms every cell is solved exactly.
/// Friction dissipates energy, and the energy account closes.
#[test]
fn the_electric_axle_is_exact_where_its_cells_are_linear() {
    let outcome = run(&scene("electric_axle", &[]));
    assert_eq!(outcome.solver.method, "dop853");
    for said in ["in the torque `traction_motor`", "in the torque `slide12`", "in the torque `roll12`"] {
        assert!(outcome.solver.why.contains(said), "{}", outcome.solver.why);
    }
    assert!(unaccounted(&outcome) < 1e-7, "{:e}", unaccounted(&outcome));
    let of = |names: &[&str]| {
        let all = scene("electric_axle", &[]);
        let kept: Vec<_> = all.effects.names(all.model).into_iter().filter(|name| !names.contains(name)).collect();
        run(&scene("electric_axle", &[format!("effects={kept:?}"), "run.t_end=50 ms".into()]))
    };
    let curve = of(&["sliding_friction_12"]);
    assert_eq!(curve.solver.method, "dop853");
    assert!(!curve.solver.why.contains("slide12") && curve.solver.why.contains("traction"), "{}", curve.solver.why);
    let linear = of(&["sliding_friction_12", "traction_motor"]);
    assert_eq!(linear.solver.method, "exact", "{}", linear.solver.why);
    assert!(unaccounted(&linear) < 1e-11, "{:e}", unaccounted(&linear));
}
