//! A flywheel that turns a slider-crank or a load behind a universal joint, without torques. The energy integral gives the speed at every
//! angle in closed form, theta'² = 2 T/I(theta), and the time of a turn by quadrature.

use std::f64::consts::TAU;

use super::{largest, linkage, run, scene};
use gearsim::run::{Entry, Refusal};

const LINKAGE: Entry = Entry::new::<linkage::Linkage>();

const I_F: f64 = 0.05;
const R: f64 = 0.06;
const L: f64 = 0.2;
const M_P: f64 = 3.0;
const BETA: f64 = 0.6;
const I_O: f64 = 0.04;
const SPEED: f64 = 40.0;

fn text(effects: &str, t_end: f64) -> String {
    format!(
        "model = \"linkage\"\neffects = {effects}\n[parameters]\nI_f = \"{I_F} kg*m^2\"\nI_w = \"0.01 kg*m^2\"\n[start]\n\
         theta_dot = \"{SPEED} rad/s\"\npsi_dot = \"1 rad/s\"\n[laws.k]\nsteps = [{{ value = \"4 N*m/rad\" }}]\n[run]\n\
         t_end = \"{t_end:?} s\"\n[output]\nrate = \"2 kHz\"\n"
    )
}

const CRANK: [&str; 4] =
    ["parameters.r_p=0.06 m", "parameters.l_p=0.2 m", "parameters.m_p=3 kg", "run.tolerance=1e-13"];
const JOINT: [&str; 3] = ["parameters.beta=0.6 rad", "parameters.I_o=0.04 kg*m^2", "run.tolerance=1e-13"];

/// The inertia that the flywheel feels with a crank: the speed of the piston from the triangle of crank and rod, v = r w sin(theta + b)/
/// cos b with sin b = (r/l) sin theta.
fn with_crank(theta: f64) -> f64 {
    let b = (R / L * theta.sin()).asin();
    let ratio = R * (theta + b).sin() / b.cos();
    I_F + M_P * ratio * ratio
}

/// The inertia with a joint: the angle behind the joint, tan theta_o = tan theta/cos beta, differentiated by the angle in front of it.
fn with_joint(theta: f64) -> f64 {
    let ratio = BETA.cos() / (theta.sin().powi(2) + (BETA.cos() * theta.cos()).powi(2));
    I_F + I_O * ratio * ratio
}

/// The time of a whole turn, by the trapezoidal rule, which converges faster than any power for periodic functions.
fn turn(inertia: impl Fn(f64) -> f64) -> f64 {
    let energy = inertia(0.0) * SPEED * SPEED;
    let n = 4000;
    (0..n).map(|i| (inertia(TAU * f64::from(i) / f64::from(n)) / energy).sqrt()).sum::<f64>() * TAU / f64::from(n)
}

fn turns_as_by_the_energy_integral(effects: &str, overrides: &[&str], inertia: fn(f64) -> f64) {
    let turns = 5.0;
    for method in ["dop853", "radau"] {
        let method = format!("run.method={method}");
        let overrides = [overrides, &[method.as_str()]].concat();
        let outcome = run(&LINKAGE, &text(effects, turns * turn(inertia)), &overrides);
        let t = &outcome.trajectory;
        let end = t.q[0].last().copied().unwrap_or(f64::NAN);
        println!("{effects}, {method}: angle at the end {:.1e} off", end - turns * TAU);
        assert!((end - turns * TAU).abs() < 1e-9, "{effects}, {method}: {end} is not {turns} turns");
        for i in 0..t.len() {
            let speed = SPEED * (inertia(0.0) / inertia(t.q[0][i])).sqrt();
            let error = (t.q_dot[0][i] / speed - 1.0).abs();
            assert!(error < 1e-10, "{effects}, {method}, row {i}: {} is not {speed}", t.q_dot[0][i]);
        }
        assert!(largest(&t.residual) < 1e-10 * outcome.energy_at_start, "{effects}: energy is not conserved");
    }
}

#[test]
fn a_slider_crank_turns_as_by_the_energy_integral() {
    turns_as_by_the_energy_integral("[\"crank\"]", &CRANK, with_crank);
}

#[test]
fn a_universal_joint_turns_as_by_the_energy_integral() {
    turns_as_by_the_energy_integral("[\"joint\"]", &JOINT, with_joint);
}

/// Without the effects that make M depend on the angle, the cells are linear and solved exactly; with one of them the exact method is
/// refused by name.
#[test]
fn the_same_model_is_exact_without_the_effects_of_varying_inertia() {
    let outcome = run(&LINKAGE, &text("[]", 0.5), &[]);
    assert_eq!(outcome.solver.method, "exact");
    let (end, w) = (outcome.trajectory.q[1].last().copied().unwrap_or(f64::NAN), (4.0f64 / 0.01).sqrt());
    assert!((end - (0.5 * w).sin() / w).abs() < 1e-13, "{end}");
    let exact = [&CRANK[..3], &["run.method=exact"]].concat();
    match LINKAGE.run(&scene(&LINKAGE, &text("[\"crank\"]", 0.5), &exact), &mut |_| {}) {
        Err(Refusal::Nonlinear { terms }) => assert!(terms.contains("M(theta) in the kinetic energy"), "{terms}"),
        other => panic!("not refused by name: {other:?}"),
    }
}
