//! Random gear pairs, drawn by dimensionless groups so that all regimes occur: fast and slow, with large and small torques.

use std::cell::Cell;

use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestCaseResult, TestRng, TestRunner};

use crate::pair::{PITCH, Pair};

/// Number of cases of each property.
const CASES: u64 = 1000;
/// Seed of the cases. It is the same in every run, so that a failure repeats on every machine.
const SEED: u64 = 2005;

/// Tests `holds` on cases of `strategy`; panics with the smallest case that fails. For long runs the environment variables
/// `PROPTEST_CASES` and `PROPTEST_RNG_SEED` override the number of cases and the seed.
pub fn check<S: Strategy>(strategy: S, holds: impl Fn(S::Value) -> TestCaseResult) {
    let set = |name: &str| std::env::var(name).ok().and_then(|text| text.parse::<u64>().ok());
    let (cases, seed) = (set("PROPTEST_CASES").unwrap_or(CASES), set("PROPTEST_RNG_SEED").unwrap_or(SEED));
    let skipped = u32::MAX; // chaotic motions are skipped, because there a rounding error may grow to any size
    let config = Config { cases: cases as u32, max_global_rejects: skipped, ..Config::default() };
    let mut bytes = [0; 32];
    bytes[..8].copy_from_slice(&seed.to_le_bytes());
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &bytes);
    let tried = Cell::new(0);
    let done = TestRunner::new_with_rng(config, rng).run(&strategy, |value| {
        tried.set(tried.get() + 1);
        holds(value)
    });
    if let Err(error) = done {
        panic!("seed {seed}: {error}");
    }
    println!("{cases} cases hold, {} were skipped", tried.get() - cases);
}

/// 10^x for x in a range.
fn power(from: f64, to: f64) -> impl Strategy<Value = f64> {
    (from..to).prop_map(|x: f64| 10f64.powf(x))
}

/// A width or an angle [rad] rounded to a multiple of 2^-46, so that subtracting it from the pitch loses no digits.
fn coarse(x: f64) -> f64 {
    let grain = 2f64.powi(-46);
    (x / grain).round() * grain
}

/// Damping factors: none, weak, critical, strong.
pub fn damping() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), power(-4.0, -0.5), 0.3..3.0f64, Just(1.0)]
}

/// A pair with a damping factor from `zeta`, with a run of up to about thirty pitches.
pub fn pair(zeta: impl Strategy<Value = f64>) -> impl Strategy<Value = Pair> {
    let levels = prop::collection::vec((power(0.0, 1.3), 0.05..1.0f64), 2..5);
    let train = (power(-4.0, 0.0), power(-1.5, 1.5), power(1.0, 4.0), levels, zeta);
    // In this order: theta' over the frequency of the vibration; torque, relative to that of the deflection at which a step reflects;
    // whether backwards; start within the pitch; deflection and its rate, relative to the same deflection; length of the run in pitches.
    let motion =
        (power(-1.3, 0.7), -0.6..0.6f64, any::<bool>(), 0.02..0.98f64, -0.5..0.5f64, -0.5..0.5f64, 0.3..30.0f64);
    (train, motion).prop_map(|((i1, ratio, k, levels, zeta), motion)| {
        let (speed, load, back, place, phi, phi_dot, pitches) = motion;
        let whole: f64 = levels.iter().map(|(_, width)| width).sum();
        let mut steps: Vec<(f64, f64)> = levels.iter().map(|(l, w)| (k * l, coarse(w / whole * PITCH))).collect();
        let before: f64 = steps[..steps.len() - 1].iter().map(|(_, width)| width).sum();
        let last = steps.len() - 1;
        steps[last].1 = PITCH - before;
        let mut pair = Pair {
            inertia: [i1, 16.0 * ratio * i1],
            zeta,
            t0: 0.0,
            steps,
            q: [coarse(place * PITCH), 0.0],
            q_dot: [0.0; 2],
            span: 1.0,
        };
        let (m2, stiffest) = (pair.m2(), pair.stiffest());
        let w = (m2 * stiffest).sqrt();
        let theta_dot = speed * w;
        // At phi = theta'/sqrt(M2 k) a step of the whole stiffness just stops the gear.
        let critical = theta_dot / (m2 * stiffest).sqrt();
        pair.t0 = load * critical * stiffest * 0.3;
        pair.q[1] = pair.t0 / stiffest + phi * 0.3 * critical;
        pair.q_dot = [if back { -theta_dot } else { theta_dot }, phi_dot * 0.3 * critical * w];
        pair.span = pitches * PITCH / theta_dot;
        pair
    })
}
