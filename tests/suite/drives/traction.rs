//! A traction motor along its envelope, with a constant demand and with one that varies in time.

use std::f64::consts::PI;

use gearsim::run::Outcome;

use crate::{freewheel, unaccounted};

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
    freewheel(&[&set[..], more].concat())
}

/// The time in which the motor brings the rotor from rest to the speed `omega` \[rad/s\], with r the rounding of the corner:
/// I domega = T dt, and the integral of 1/T in closed form.
fn run_up(omega: f64, r: f64) -> f64 {
    let (inertia, torque, base) = (0.05, 5.0, 100.0);
    let x = omega / base;
    let g = |y: f64| (y * y.hypot(r) + r * r * (y / r).asinh()) / 2.0;
    inertia * base / (2.0 * torque) * (g(1.0 + x) - g(1.0 - x))
}

/// Constant torque, then constant power: omega = T t/I up to the base speed, and omega² = base² + 2 P (t - t_base)/I from there on. The
/// motion with the rounded corner has a closed form too. Its speeds differ from these by less than 0.1 % or 1e-3 rad/s.
#[test]
fn a_traction_motor_runs_up_with_constant_torque_and_then_constant_power() {
    let r = 0.01;
    let outcome = traction(&[]);
    assert_eq!(outcome.solver.method, "dop853");
    assert!(outcome.solver.why.contains("in the torque `traction_motor`"), "{}", outcome.solver.why);
    let t = &outcome.trajectory;
    let mut above = 0;
    for (i, (time, omega)) in t.t.iter().zip(&t.q_dot[0]).enumerate() {
        assert!((time - run_up(*omega, r)).abs() < 1e-9, "{time} s: {omega} rad/s, expected at {}", run_up(*omega, r));
        let sharp = if *time < 1.0 { 100.0 * time } else { (1e4 + 2.0 * 500.0 * (time - 1.0) / 0.05f64).sqrt() };
        assert!((omega - sharp).abs() < 1e-3 * sharp.max(1.0), "{time} s: {omega} rad/s, not {sharp}");
        if *omega > 110.0 {
            above += 1;
            let power = t.output("power_traction_motor").expect("an output")[i];
            let bound = r * r / (2.0 * ((omega / 100.0).powi(2) - 1.0));
            assert!((0.0..bound).contains(&(1.0 - power / 500.0)), "{omega} rad/s: {power} W");
        }
    }
    assert!(above > 100, "{above} rows above the base speed");
    assert!(unaccounted(&outcome) < 1e-10, "{:e}", unaccounted(&outcome));
}

/// With a demand of -1/2 the motor brakes along the same curve in twice the time. A rotor that turns backward is braked by a demand of 1/2.
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

/// The demand d(t) varies in time: I domega = d T dt, so the integral of d takes the place of the time. The demand has harmonics and a
/// table whose breakpoint is an event. The run is done by an explicit and by an implicit method.
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
            let (x, r) = (omega / 100.0, 0.01);
            let expected = omega * 2.0 * d * 5.0 / ((1.0 + x).hypot(r) + (1.0 - x).hypot(r));
            let power = t.output("power_traction_motor").expect("an output")[i];
            assert!(
                (power - expected).abs() < 1e-10 * expected.abs().max(1.0),
                "{method}: {time} s: {power} W, not {expected}"
            );
        }
        assert!(unaccounted(&outcome) < 1e-9, "{method}: {:e}", unaccounted(&outcome));
    }
}
