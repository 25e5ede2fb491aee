//! Smooth stiffness laws in scenes, against the jump rule, against hand-written equations, and against one another.

use std::f64::consts::TAU;

use super::{difference, run, try_run};
use crate::engine::Refusal;
use crate::run::Outcome;
use crate::trajectory::Trajectory;

const FOURIER: &str = r#"laws.k={mean="2.1 kN*m", harmonics=[{order=1, amplitude="0.6 kN*m", phase="0.4 rad"}, {order=2, amplitude="0.1 kN*m"}]}"#;

/// Ramps of width eps converge to the jump rule of a step, with transmission and with reflection. The difference is O(eps): halving eps
/// four times reduces it by 16, up to the next order in eps.
#[test]
fn ramps_converge_to_the_jump_rule_in_first_order() {
    // Start and end are far from any ramp. The motion passes one step, or is reflected by it and then passes it.
    let through = ["start.theta=\"1 rad\"", "start.phi=\"0.005 rad\"", "start.speed=\"60 rpm\"", "run.t_end=\"8 ms\""];
    let back = ["start.theta=\"1.6 rad\"", "start.phi=\"0.01 rad\"", "start.speed=\"20 rpm\"", "run.t_end=\"4 ms\""];
    for (case, events) in [(through, (1, 0)), (back, (1, 1))] {
        let only_end = ["output.events=false", "output.rate=\"1 Hz\""];
        let with = |more: &[&str]| run(&[&case[..], &only_end, more].concat());
        let jump = with(&[]);
        assert_eq!((jump.counts.cell_changes, jump.counts.reflections), events, "{case:?}");
        let differences: Vec<f64> = (0..5)
            .map(|octave| {
                let ramp = format!("laws.k.ramp=\"{:?} rad\"", 2e-5 / f64::from(1 << octave));
                difference(&with(&[&ramp, "run.tolerance=1e-13"]).trajectory, &jump.trajectory)
            })
            .collect();
        let slope = (differences[0] / differences[4]).log2() / 4.0;
        println!("{differences:?}, slope {slope:.3}");
        assert!((slope - 1.0).abs() < 0.05, "{case:?}: {differences:?}, slope {slope}");
    }
}

/// Eqs. (2) and (3) of Oh, Grosh & Barber (2005) with k = k(theta), or (6) with k(Omega0 t): the end state after `t_end` by the
/// classical Runge-Kutta method in `n` steps. With 40,000 steps its error is below 1e-11 here.
fn by_hand(frozen: bool, t_end: f64, n: usize) -> [f64; 4] {
    let (i1, i2): (f64, f64) = (2890e-6 / 576.0, 740200e-6 / 9216.0);
    let (m1, m2) = ((1.0 / i1 - 1.0 / i2) / 2.0, (1.0 / i1 + 1.0 / i2) / 2.0);
    let k = |s: f64| 2100.0 + 600.0 * (s + 0.4).cos() + 100.0 * (2.0 * s).cos();
    let dk = |s: f64| -600.0 * (s + 0.4).sin() - 200.0 * (2.0 * s).sin();
    // (max + min)/2 of k, found by a scan.
    let scan = (0..1_000_000).map(|i| k(TAU * f64::from(i) * 1e-6));
    let (low, high) = scan.fold((f64::INFINITY, 0.0f64), |(low, high), k| (low.min(k), high.max(k)));
    let c = 2.0 * 0.05 * ((low + high) / 2.0 / m2).sqrt();
    let omega = 600.0 * TAU / 60.0 * 24.0;
    let rate = |t: f64, [theta, phi, theta_dot, phi_dot]: [f64; 4]| {
        let (s, slope) = if frozen { (omega * t, 0.0) } else { (theta, dk(theta)) };
        let (spring, jump) = (10.0 - k(s) * phi - c * phi_dot, slope * phi * phi / 2.0);
        [theta_dot, phi_dot, m1 * spring - m2 * jump, m2 * spring - m1 * jump]
    };
    let h = t_end / n as f64;
    let plus = |y: [f64; 4], h: f64, f: [f64; 4]| std::array::from_fn(|i| y[i] + h * f[i]);
    let mut y = [0.0, 10.0 / k(0.0), omega, 0.0];
    for i in 0..n {
        let t = h * i as f64;
        let a = rate(t, y);
        let b = rate(t + h / 2.0, plus(y, h / 2.0, a));
        let c = rate(t + h / 2.0, plus(y, h / 2.0, b));
        let d = rate(t + h, plus(y, h, c));
        y = std::array::from_fn(|i| y[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
    }
    y
}

fn end(run: &Trajectory) -> [f64; 4] {
    let last = |column: &[f64]| column[column.len() - 1];
    [last(&run.q[0]), last(&run.q[1]), last(&run.q_dot[0]), last(&run.q_dot[1])]
}

/// A Fourier law by every method against the hand-written equations, with moving and with frozen phase. The scan finds k_mid with an error
/// of 1e-9, which is therefore the error of the damping.
#[test]
fn a_fourier_law_matches_hand_written_equations() {
    for (frozen, effects) in [
        (false, "effects=[\"stiffness_step\", \"damping\", \"torques\"]"),
        (true, "effects=[\"stiffness_step\", \"frozen_phase\", \"damping\", \"torques\"]"),
    ] {
        let expected = by_hand(frozen, 0.02, 40_000);
        for method in ["dopri5", "dop853", "radau"] {
            let method = format!("run.method={method:?}");
            let outcome = run(&[FOURIER, effects, &method, "run.tolerance=1e-12"]);
            let found = end(&outcome.trajectory);
            for (found, expected) in found.iter().zip(expected) {
                let scale = expected.abs().max(1e-2);
                assert!((found - expected).abs() < 1e-8 * scale, "{method} {effects}: {found} for {expected}");
            }
            if !frozen {
                let lost = outcome.trajectory.residual.iter().fold(0.0f64, |m, r| m.max(r.abs()));
                assert!(lost < 1e-9 * outcome.energy_at_start, "{method}: {lost} J unaccounted for");
            }
        }
    }
}

/// A table with values of a Fourier law converges to it as h⁴ or faster. The oscillating error between its points averages out
/// over the motion.
#[test]
fn a_table_converges_to_the_law_it_samples() {
    let one = "laws.k={mean=\"2.1 kN*m\", harmonics=[{order=1, amplitude=\"0.6 kN*m\"}]}";
    let run = |law: &str| run(&[law, "run.tolerance=1e-12", "output.events=false"]);
    let expected = run(one);
    let error = |n: usize| {
        let points = (0..n).map(|i| {
            let s = TAU * i as f64 / n as f64;
            format!("{{at=\"{s:?} rad\", value=\"{:?} N*m\"}}", 2100.0 + 600.0 * s.cos())
        });
        let table = format!("laws.k={{table=[{}]}}", points.collect::<Vec<_>>().join(", "));
        difference(&run(&table).trajectory, &expected.trajectory)
    };
    let order = (error(8) / error(32)).log2() / 2.0;
    assert!(order > 3.6, "{order}");
}

fn reason(outcome: &Outcome) -> (&str, &str) {
    (outcome.solver.method, &outcome.solver.why)
}

/// The method and its reason: exact for linear cells; otherwise by the tolerance and by the stiffness of the motion.
#[test]
fn the_method_depends_on_the_scene() {
    let plain = run(&[]);
    assert_eq!(reason(&plain), ("exact", "every cell is linear: M q'' + C q' + K q = f with constant M, C, K, f"));
    // Without the effect the law is constant.
    assert_eq!(run(&[FOURIER, "effects=[\"torques\"]"]).solver.method, "exact");
    let smooth = run(&[FOURIER]);
    assert_eq!(reason(&smooth), ("dop853", "cells are not linear: k(theta) varies within a cell, in V and its forces"));
    assert_eq!(run(&[FOURIER, "run.tolerance=1e-5"]).solver.method, "dopri5");
    let Err(Refusal::Nonlinear { terms }) = try_run(&[FOURIER, "run.method=\"exact\""]) else { panic!("refused") };
    assert!(terms.contains("k(theta)"), "{terms}");

    // A damper whose rate is four decades above the natural frequency of phi.
    let stiff = [FOURIER, "parameters.zeta=200", "run.tolerance=1e-8"];
    let outcome = run(&stiff);
    let (method, why) = reason(&outcome);
    assert!(method == "radau" && why.contains("dop853 until t ="), "{method}: {why}");
    let explicit = run(&[&stiff[..], &["run.method=\"dop853\""]].concat());
    assert!(explicit.solver.steps > 5 * outcome.solver.steps, "{:?} {:?}", explicit.solver, outcome.solver);
    // With such damping the speeds of phi are a hundred times smaller than those that count as zero. So phi has two digits less.
    let error = difference(&outcome.trajectory, &explicit.trajectory);
    assert!(error < 1e-4, "{error:e}");
}
