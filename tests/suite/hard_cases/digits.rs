//! Row 9: starts after 1e9 revolutions, and runs of 3e8 seconds.

use gearsim::__private::Clock;
use gearsim_tests::oh2005::{GearPair, PITCH, State};
use gearsim_tests::precise::number::{Real, Scalar};

use crate::case::{Case, NONE, WRONG, count};
use crate::noise::Noise;
use crate::pair;

pub const CASES: &[Case] = &[
    Case {
        row: "9",
        name: "a start after 1e9 revolutions, in either direction",
        proves: "times, speeds and deflections have the same bits as for a start in the first pitch",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: revolutions,
    },
    Case {
        row: "9",
        name: "a run of 3e8 s, compared with the same run with time scaled by 2^-28",
        proves: "the motion does not depend on the unit of time: the same bits",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: units,
    },
    Case {
        row: "9",
        name: "the clock after 3e8 s, and a million flights of a microsecond",
        proves: "the error of the sum is a rounding error of the flights, not of the time",
        tolerance: 1.0,
        unit: "eps of a second",
        reason: "all flights together last a second; a plain sum would have 1e8 times this error",
        measure: clock,
    },
];

/// The number of entries of two columns whose bits differ, after `a` is multiplied by `scale`.
fn bits(a: &[f64], b: &[f64], scale: f64) -> f64 {
    let unlike = a.len().abs_diff(b.len()) as f64;
    unlike + count(a.iter().zip(b).map(|(a, b)| (a * scale).to_bits() != b.to_bits()))
}

fn revolutions(note: &mut String) -> f64 {
    let mut rows = 0;
    let wrong = [(1e9, 60.0), (1e9, -600.0), (-1e9, 60.0), (-1e9, -4500.0)].map(|(turns, rpm)| {
        let pair = GearPair::paper(0.05, 10.0);
        // Any angle this large will do; its remainder after whole pitches is exact.
        let far = State { theta: turns * pair.n1 * PITCH + 1.0, ..pair.start(rpm) };
        let near = State { theta: far.theta.rem_euclid(PITCH), ..far };
        let t_end = 50.0 / far.theta_dot.abs();
        let [far, near] = [far, near].map(|start| pair::run(&pair, &start, t_end).outcome.trajectory);
        rows += near.len();
        bits(&far.t, &near.t, 1.0)
            + bits(&far.q[1], &near.q[1], 1.0)
            + bits(&far.q_dot[0], &near.q_dot[0], 1.0)
            + bits(&far.q_dot[1], &near.q_dot[1], 1.0)
    });
    *note = format!("{rows} rows");
    wrong.iter().sum()
}

fn units(note: &mut String) -> f64 {
    let mut rows = 0;
    let slow = 2f64.powi(-28);
    let wrong = [20.0, 600.0, -1000.0].map(|rpm| {
        let pair = GearPair::paper(0.05, 10.0);
        let force = slow * slow;
        let later = GearPair { k1: pair.k1 * force, k2: pair.k2 * force, t0: pair.t0 * force, ..pair };
        let start = State { theta: 0.5, phi_dot: 1.0, ..pair.start(rpm) };
        let slowed = State { theta_dot: start.theta_dot * slow, phi_dot: start.phi_dot * slow, ..start };
        let seconds = pair::run(&pair, &start, 1.2).outcome.trajectory;
        let years = pair::run(&later, &slowed, 1.2 / slow).outcome.trajectory;
        rows += seconds.len();
        bits(&seconds.t, &years.t, 1.0 / slow)
            + bits(&seconds.q[0], &years.q[0], 1.0)
            + bits(&seconds.q[1], &years.q[1], 1.0)
            + bits(&seconds.q_dot[0], &years.q_dot[0], slow)
            + bits(&seconds.q_dot[1], &years.q_dot[1], slow)
    });
    *note = format!("{rows} rows");
    wrong.iter().sum()
}

fn clock(_: &mut String) -> f64 {
    let mut noise = Noise::new(901);
    let mut clock = Clock::default();
    clock.set(3e8);
    let mut exact = Real::<192>::exact(3e8);
    for _ in 0..1_000_000 {
        let dt = 2e-6 * noise.unit();
        clock.advance(dt);
        exact = exact + Real::exact(dt);
    }
    let to = 300_000_002.0;
    ((Real::exact(to) - exact).approx() - clock.until(to)).abs() / f64::EPSILON
}
