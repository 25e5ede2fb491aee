//! Motors and loads: the scenes of `models/scenes/drives`, compared with balances of torque and energy computed without a simulation.

mod common;

use std::f64::consts::PI;

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
    for said in ["in the torque `induction`", "in the torque `fan`"] {
        assert!(outcome.solver.why.contains(said), "{}", outcome.solver.why);
    }
    let (found, expected) = (motor_speed(&scene, &outcome, 0.2), working_point(&scene));
    assert!((found / expected - 1.0).abs() < 1e-3, "{found} {expected}");
    assert!(unaccounted(&outcome) < 1e-6, "{:e}", unaccounted(&outcome));
    // The motor does positive work and the fan negative work.
    let t = &outcome.trajectory;
    let works = ["induction", "fan"].map(|name| *t.work_of(name).expect("a torque of the scene").last().expect("rows"));
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

/// Every model has every drive and every load, one motor at a time. A train has those that its tables list.
#[test]
fn every_model_has_every_drive_and_load() {
    const MOTORS: [&str; 4] = ["speed_governor", "dc_motor", "induction_motor", "traction_motor"];
    for model in common::models().into_iter().filter(|model| model.elements.is_empty()) {
        for name in MOTORS.iter().chain(&["fan_load"]) {
            assert!(model.effects.iter().any(|effect| effect.name == *name), "{} has no {name}", model.name);
        }
        let excludes = |a: &str, b: &str| {
            let lists = |a: &str, b: &str| model.effects.iter().any(|e| e.name == a && e.excludes.contains(&b));
            lists(a, b) || lists(b, a)
        };
        for (i, a) in MOTORS.iter().enumerate() {
            assert!(MOTORS[i + 1..].iter().all(|b| excludes(a, b)), "{}: {a} and another motor", model.name);
        }
    }
}

/// A traction motor of 5 N*m and 500 W, which drives a free rotor of 0.05 kg*m^2.
fn traction(more: &[&str]) -> Outcome {
    let set = [
        "effects=[\"traction_motor\"]",
        "parameters.Tp_motor=\"5 N*m\"",
        "parameters.Pp_motor=\"500 W\"",
        "parameters.I1=\"0.05 kg*m^2\"",
        "run.t_end=\"5 s\"",
        "run.tolerance=1e-12",
    ];
    run(&scene("freewheel", &[&set[..], more].concat().iter().map(|s| s.to_string()).collect::<Vec<_>>()))
}

/// The time in which the motor brings the rotor from rest to the speed `omega` \[rad/s\], with r the rounding of the corner:
/// I domega = T dt, and the integral of 1/T in closed form.
fn run_up(omega: f64, r: f64) -> f64 {
    let (inertia, torque, base) = (0.05, 5.0, 100.0);
    let x = omega / base;
    let g = |y: f64| (y * y.hypot(r) + r * r * (y / r).asinh()) / 2.0;
    inertia * base / (2.0 * torque) * (g(1.0 + x) - g(1.0 - x))
}

/// Constant torque, then constant power: omega = T t/I up to the base speed, and omega² = base² + 2 P (t - t_base)/I from there on. The rounded
/// corner has a closed form too, and the speeds differ by less than the rounding.
#[test]
fn a_traction_motor_runs_up_with_constant_torque_and_then_constant_power() {
    let r = 0.01;
    let outcome = traction(&[]);
    assert_eq!(outcome.solver.method, "dop853");
    assert!(outcome.solver.why.contains("in the torque `traction`"), "{}", outcome.solver.why);
    let t = &outcome.trajectory;
    let mut above = 0;
    for (i, (time, omega)) in t.t.iter().zip(&t.q_dot[0]).enumerate() {
        assert!((time - run_up(*omega, r)).abs() < 1e-9, "{time} s: {omega} rad/s, expected at {}", run_up(*omega, r));
        let sharp = if *time < 1.0 { 100.0 * time } else { (1e4 + 2.0 * 500.0 * (time - 1.0) / 0.05f64).sqrt() };
        assert!((omega - sharp).abs() < 1e-3 * sharp.max(1.0), "{time} s: {omega} rad/s, not {sharp}");
        if *omega > 110.0 {
            above += 1;
            let power = t.output("power_traction").expect("an output")[i];
            let bound = r * r / (2.0 * ((omega / 100.0).powi(2) - 1.0));
            assert!((0.0..bound).contains(&(1.0 - power / 500.0)), "{omega} rad/s: {power} W");
        }
    }
    assert!(above > 100, "{above} rows above the base speed");
    assert!(unaccounted(&outcome) < 1e-10, "{:e}", unaccounted(&outcome));
}

/// With a demand of -1/2 it brakes along the same curve, in twice the time; also a rotor that turns backward.
#[test]
fn a_traction_motor_brakes_along_the_same_curve() {
    for direction in [1.0, -1.0] {
        let start = format!("start.speed=\"{} rad/s\"", 300.0 * direction);
        let demand = format!("parameters.d_motor={}", -0.5 * direction);
        let outcome = traction(&[&start, &demand]);
        let t = &outcome.trajectory;
        for (time, omega) in t.t.iter().zip(&t.q_dot[0]) {
            let expected = 2.0 * (run_up(300.0, 0.01) - run_up(omega.abs(), 0.01));
            assert!((time - expected).abs() < 1e-8, "{time} s: {omega} rad/s, expected at {expected}");
        }
        assert!(t.kinetic[t.len() - 1] < t.kinetic[0] && unaccounted(&outcome) < 1e-10);
    }
}

/// The demand varies in time: along d(t), I domega = d T dt, so the integral of d takes the place of the time. Harmonics and a table, whose
/// breakpoint is an event; an explicit method, and an implicit one.
#[test]
fn the_demand_on_a_traction_motor_varies_in_time() {
    let demand = "parameters.d_motor={table=[{at=0, value=0.2}, {at=\"1 s\", value=1.2}], harmonics=[{amplitude=0.5, frequency=\"3 Hz\"}]}";
    let integral = |t: f64| {
        let ramp = if t < 1.0 { 0.2 * t + 0.5 * t * t } else { 0.7 + 1.2 * (t - 1.0) };
        ramp + 0.5 * (6.0 * PI * t).sin() / (6.0 * PI)
    };
    for method in ["dop853", "radau"] {
        let outcome =
            traction(&[demand, &format!("run.method={method}"), "run.tolerance=1e-10", "start.speed=\"20 rad/s\""]);
        let t = &outcome.trajectory;
        for (i, (time, omega)) in t.t.iter().zip(&t.q_dot[0]).enumerate() {
            let passed = run_up(*omega, 0.01) - run_up(20.0, 0.01);
            assert!((integral(*time) - passed).abs() < 1e-8, "{method}: {time} s: {omega} rad/s, {passed} s");
            let d = 0.2 + time.min(1.0) + 0.5 * (6.0 * PI * time).cos();
            let envelope = 500.0 * 5.0 * omega / (500.0f64.powi(2) + (5.0 * omega).powi(2)).sqrt();
            let power = t.output("power_traction").expect("an output")[i];
            assert!((0.7..1.5).contains(&(power / (d * envelope))), "{method}: {time} s: {power} W, demand {d}");
        }
        assert!(unaccounted(&outcome) < 1e-9, "{method}: {:e}", unaccounted(&outcome));
    }
}

/// A fan whose coefficient varies, in closed form: I domega/(omega (w0² + omega²)^(1/2)) = -c(t) dt.
#[test]
fn the_coefficient_of_a_fan_varies_in_time() {
    let (inertia, w0) = (0.4, 0.5);
    let set = [
        "effects=[\"fan_load\"]",
        "parameters.I2=\"0.4 kg*m^2\"",
        "parameters.w0_load=\"0.5 rad/s\"",
        "parameters.cf_load={steps=[{value=\"0.01 N*m*s^2/rad^2\", until=\"0.3 s\"}, {value=\"0.002 N*m*s^2/rad^2\"}]}",
        "start.theta2_dot=\"200 rad/s\"",
        "run.t_end=\"2 s\"",
        "run.tolerance=1e-12",
    ];
    let outcome = run(&scene("freewheel", &set.map(String::from)));
    let t = &outcome.trajectory;
    let slowed = |omega: f64| inertia / w0 * ((w0 / omega).asinh() - (w0 / 200.0f64).asinh());
    for (time, omega) in t.t.iter().zip(&t.q_dot[1]) {
        let taken = 0.01 * time.min(0.3) + 0.002 * (time - 0.3).max(0.0);
        assert!((slowed(*omega) - taken).abs() < 1e-10, "{time} s: {omega} rad/s");
    }
    assert!(t.q_dot[1][t.len() - 1] < 60.0 && unaccounted(&outcome) < 1e-11, "{:e}", unaccounted(&outcome));
}

/// Rotors of `freewheel` by two methods, with 1 and 2 kg*m^2.
fn rotors(more: &[&str]) -> [Outcome; 2] {
    let set = ["parameters.I1=\"1 kg*m^2\"", "parameters.I2=\"2 kg*m^2\"", "parameters.rise2=0", "run.tolerance=1e-10"];
    ["dop853", "radau"].map(|method| {
        let method = format!("run.method={method}");
        run(&scene(
            "freewheel",
            &[&set[..], &[&method], more].concat().iter().map(|s| s.to_string()).collect::<Vec<_>>(),
        ))
    })
}

/// A brake that is applied slowly, T = c t: I omega = I omega0 - c t²/2 until the rotor stands, and it stays at rest.
#[test]
fn a_brake_that_is_applied_stops_a_rotor() {
    let brake = "parameters.Tc2={ramp={to=\"12 N*m\", duration=\"3 s\"}}";
    for outcome in rotors(&["effects=[\"dry_friction\"]", brake, "start.theta2_dot=\"9 rad/s\"", "run.t_end=\"5 s\""]) {
        assert!(outcome.solver.why.contains("names it"), "{}", outcome.solver.why);
        let t = &outcome.trajectory;
        for (time, omega) in t.t.iter().zip(&t.q_dot[1]) {
            let expected = (9.0 - time * time).max(0.0);
            assert!((omega - expected).abs() < 1e-8, "{time} s: {omega} rad/s, not {expected}");
        }
        let last = t.len() - 1;
        assert!((t.q[1][last] - 18.0).abs() < 1e-8 && t.q_dot[1][last] == 0.0, "{} rad", t.q[1][last]);
        assert!(
            (t.dissipated[last] - 81.0).abs() < 1e-7 && unaccounted(&outcome) < 1e-9,
            "{:e}",
            unaccounted(&outcome)
        );
        assert_eq!(outcome.counts.sticks, 1);
    }
}

/// A brake that is released, 5 N*m to 1 N*m within 1 s, lets go of a rotor under 2 N*m at 0.75 s. From there I omega' = 4 t - 3 for 1/4 s, then 1 N*m.
#[test]
fn a_brake_that_is_released_lets_go_of_a_loaded_rotor() {
    let brake = "parameters.Tc2={ramp={from=\"5 N*m\", to=\"1 N*m\", duration=\"1 s\"}}";
    let effects = "effects=[\"dry_friction\", \"torques\"]";
    let set = [
        effects,
        brake,
        "parameters.T_load=\"-2 N*m\"",
        "parameters.T_motor=0",
        "start.theta2_dot=0",
        "run.t_end=\"2 s\"",
    ];
    for outcome in rotors(&set) {
        let t = &outcome.trajectory;
        for (i, (time, omega)) in t.t.iter().zip(&t.q_dot[1]).enumerate() {
            let free = (time - 0.75).clamp(0.0, 0.25);
            let expected = free * free + 0.5 * (time - 1.0).max(0.0);
            assert!((omega - expected).abs() < 1e-8, "{time} s: {omega} rad/s, not {expected}");
            let friction = if *time < 0.75 { 2.0 } else { (5.0 - 4.0 * time).max(1.0) };
            let recorded = t.output("friction_torque_2").expect("an output")[i];
            assert!(
                (recorded - friction).abs() < 1e-8 || (time - 0.75).abs() < 1e-6,
                "{time} s: {recorded} N*m, not {friction}"
            );
        }
        assert!(unaccounted(&outcome) < 1e-9, "{:e}", unaccounted(&outcome));
    }
}

/// A clutch that engages with T = 1 N*m + c t between rotors of 1 and 2 kg*m^2: the slip is omega0 - (1 N*m t + c t²/2) (1/I1 + 1/I2), and both turn together when
/// it is zero.
#[test]
fn a_clutch_that_engages_brings_two_rotors_to_one_speed() {
    let clutch = "parameters.Tmax={ramp={from=\"1 N*m\", to=\"31 N*m\", duration=\"3 s\"}}";
    let effects = "effects=[\"overrunning_clutch\"]";
    let set = [
        effects,
        clutch,
        "parameters.Tdrag=0",
        "start.theta1_dot=\"30 rad/s\"",
        "start.theta2_dot=0",
        "run.t_end=\"3 s\"",
    ];
    for outcome in rotors(&set) {
        let t = &outcome.trajectory;
        for i in 0..t.len() {
            let impulse = (t.t[i] + 5.0 * t.t[i] * t.t[i]).min(20.0);
            let expected = [30.0 - impulse, 0.5 * impulse];
            let speeds = [t.q_dot[0][i], t.q_dot[1][i]];
            assert!(
                (0..2).all(|j| (speeds[j] - expected[j]).abs() < 1e-7),
                "{} s: {speeds:?}, not {expected:?}",
                t.t[i]
            );
        }
        assert!((t.dissipated[t.len() - 1] - 300.0).abs() < 1e-6, "{} J", t.dissipated[t.len() - 1]);
        assert!(unaccounted(&outcome) < 1e-9, "{:e}", unaccounted(&outcome));
    }
}

/// The end scene: what is nonlinear is named; without it every cell is solved exactly. Friction takes energy, and the account closes.
#[test]
fn the_electric_axle_is_exact_where_its_cells_are_linear() {
    let outcome = run(&scene("electric_axle", &[]));
    assert_eq!(outcome.solver.method, "dop853");
    for said in ["in the torque `traction`", "in the torque `slide12`", "in the torque `roll12`"] {
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
