//! A step of stiffness as the limit of ramps: the solution of Eqs. (2), (3) through a ramp of width eps approaches the jump rule
//! with an error O(eps).
//!
//! The difference of the end states is C eps + O(eps^2). So halving eps halves the difference: for small eps the ratio must be
//! within 2 +- 0.1, and the mean slope of log difference over log eps, over four octaves, within 1 +- 0.04. Critical incidence is left
//! out, because it converges at another rate: a ramp has no single instant of reflection. The ramps are smooth, because the
//! reference's integrator loses its order at the kinks of linear ramps.

mod common;

use std::f64::consts::TAU;

use common::{run, scene};
use gearsim_tests::oh2005::{GearPair, Ramp, State};

/// The widest ramp \[rad\]; each next ramp is half as wide. Wider ramps would show the next order too. In ramps narrower than 1e-6 the
/// rounding error of theta would show.
const WIDEST: f64 = 4e-5;
const OCTAVES: usize = 4;
/// Fineness of the integration steps in a ramp. Their error must stay below the smallest difference, 4e-9.
const FINENESS: f64 = 8.0;

/// A run that meets one step. If the step reflects it, it meets the step again: phi then swings, and soon theta is transmitted. `theta`
/// is the start \[rad\], `rpm` the speed of the driving gear, `changes` and `reflections` the expected events.
struct Case {
    name: &'static str,
    theta: f64,
    rpm: f64,
    changes: u64,
    reflections: u64,
}

const CASES: [Case; 5] = [
    Case { name: "up, forwards", theta: 1.0, rpm: 60.0, changes: 1, reflections: 0 },
    Case { name: "down, forwards", theta: 6.0, rpm: 30.0, changes: 1, reflections: 0 },
    Case { name: "up, backwards", theta: 0.5, rpm: -60.0, changes: 1, reflections: 0 },
    Case { name: "down, backwards", theta: 1.9, rpm: -20.0, changes: 1, reflections: 0 },
    Case { name: "reflected, then transmitted", theta: 1.0, rpm: 20.0, changes: 1, reflections: 1 },
];

/// The largest difference of two states, each component relative to its size in this motion.
fn difference(a: &State, b: &State, pair: &GearPair, speed: f64) -> f64 {
    let (phi, w0) = (pair.t0 / pair.k1, pair.w0());
    let [theta, theta_dot] = [a.theta - b.theta, (a.theta_dot - b.theta_dot) / speed];
    let [phi, phi_dot] = [(a.phi - b.phi) / phi, (a.phi_dot - b.phi_dot) / (phi * w0)];
    [theta, theta_dot, phi, phi_dot].into_iter().fold(0.0, |m, x| m.max(x.abs()))
}

/// The end of the engine's run with the jump rule, from `start` \[rad, rad/s\] to `t_end` \[s\]. The scene starts phi in its static
/// equilibrium.
fn with_jump(case: &Case, pair: &GearPair, start: &State, t_end: f64) -> State {
    let set = |key: &str, value: f64, unit: &str| format!("{key}={value:?} {unit}");
    let overrides = [
        set("parameters.zeta", pair.zeta, "").trim_end().to_string(),
        set("parameters.T0", pair.t0, "N*m"),
        set("start.theta", start.theta, "rad"),
        set("start.theta_dot", start.theta_dot, "rad/s"),
        set("run.t_end", t_end, "s"),
        set("output.rate", (10.0 / t_end).round(), "Hz"),
    ];
    let outcome = run(&scene("oh2005/energy_300rpm", &overrides));
    let counts = &outcome.counts;
    assert_eq!((counts.cell_changes, counts.reflections), (case.changes, case.reflections), "{}", case.name);
    let t = &outcome.trajectory;
    let last = t.len() - 1;
    State { theta: t.q[0][last], theta_dot: t.q_dot[0][last], phi: t.q[1][last], phi_dot: t.q_dot[1][last] }
}

#[test]
fn ramps_converge_to_the_jump_rule_in_first_order() {
    let pair = GearPair::paper(0.05, 10.0);
    for case in CASES {
        let theta_dot = pair.n1 * case.rpm * TAU / 60.0;
        let start =
            State { theta: case.theta, theta_dot, phi: pair.t0 / pair.k(pair.locate(case.theta).0), phi_dot: 0.0 };
        let t_end = 1.2 / theta_dot.abs();
        let jump = with_jump(&case, &pair, &start, t_end);
        let differences: Vec<f64> = (0..=OCTAVES)
            .map(|octave| WIDEST / f64::from(1 << octave))
            .map(|eps| pair.solve_ramp(Ramp::Smooth, eps, start, t_end, FINENESS))
            .map(|end| difference(&end, &jump, &pair, theta_dot))
            .collect();
        let slope = (differences[0] / differences[OCTAVES]).log2() / OCTAVES as f64;
        let ratios: Vec<f64> = differences.windows(2).map(|d| d[0] / d[1]).collect();
        println!("{}: {differences:?}, ratios {ratios:.3?}, slope {slope:.4}", case.name);
        assert!((slope - 1.0).abs() < 0.04, "{}: slope {slope}", case.name);
        assert!(ratios.iter().all(|r| (r - 2.0).abs() < 0.1), "{}: {ratios:?}", case.name);
    }
}
