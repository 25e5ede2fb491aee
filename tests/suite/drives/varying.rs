//! Fans, brakes and clutches whose parameters vary in time, in closed form.

use gearsim::run::Outcome;

use crate::{freewheel, unaccounted};

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
    let outcome = freewheel(&set);
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
        freewheel(&[&set[..], &[&method], more].concat())
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

/// A brake whose torque falls from 5 N*m to 1 N*m within 1 s. It releases a rotor under 2 N*m at 0.75 s. From there I omega' = 4 t - 3 for
/// 1/4 s, then 1 N*m.
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

/// A clutch that engages with T = 1 N*m + c t between rotors of 1 and 2 kg*m^2: the slip is omega0 - (1 N*m t + c t²/2) (1/I1 + 1/I2). When
/// it is zero, both rotors turn together.
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
