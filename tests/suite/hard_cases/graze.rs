//! Row 1: grazes of every depth, and exact tangency.

use gearsim_tests::oh2005::{GearPair, State};
use gearsim_tests::precise::{self, first_crossing};

use crate::case::{Case, NONE, WRONG, count, largest};
use crate::linear::{Linear, Met, first_from};
use crate::{noise::Noise, pair};

pub const CASES: &[Case] = &[
    Case {
        row: "1",
        name: "crest 1e-1 to 1e-14 of the amplitude beyond a boundary, or short of it",
        proves: "every crossing is found however shallow, and no false one",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: depths,
    },
    Case {
        row: "1",
        name: "time of a graze",
        proves: "as accurate as the conditioning of a flat root allows",
        tolerance: 8.0,
        unit: "eps amplitude/slope",
        reason: "the tolerance of a touch, 4 eps of twice the amplitude",
        measure: times,
    },
    Case {
        row: "1",
        name: "exact tangency, repeated",
        proves: "a touch is never an event",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: |_| tangencies(|met, again| met.side.is_some() || met != again),
    },
    Case {
        row: "1",
        name: "exact tangency, counted",
        proves: "touches are reported: 16 crests, 16 grazes",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: |_| tangencies(|met, _| met.cost.grazes != 16),
    },
    Case {
        row: "1",
        name: "graze in a cell whose width is 1e-2 to 1e-8 of the swing",
        proves: "the smallest depth that is resolved depends on the width of the cell, not on the swing",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: narrow,
    },
    Case {
        row: "1",
        name: "gear pair that just reaches the end of its cell or stops short of it, by 1e-1 to 1e-12 of its speed",
        proves: "there is an event exactly if the speed suffices; the limiting speed is found in 50 digits",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: gear_pairs,
    },
];

/// Amplitudes A and levels. A sin t has its crest at exactly A; the level is below or above it by the relative depths 1e-1 to 1e-14.
fn levels() -> impl Iterator<Item = (f64, f64)> {
    let depths = (1..=14).flat_map(|k| [1.0, -1.0].map(|sign| sign * 10f64.powi(-k)));
    depths.flat_map(|depth| [1e-9, 1.0, 3.7e8].map(|amplitude| (amplitude, amplitude * (1.0 - depth))))
}

fn sine() -> Linear<1> {
    Linear::modal([(0.0, 1.0)], [0.0])
}

fn depths(_: &mut String) -> f64 {
    let wrong = |(amplitude, level): (f64, f64), sign: f64| {
        let gaps = if sign > 0.0 { [2.0 * amplitude, level] } else { [level, 2.0 * amplitude] };
        // The horizon 2 is after the first crest.
        first_from(&sine(), [sign * amplitude], gaps, 2.0).side.is_some() != (level < amplitude)
    };
    count(levels().flat_map(|case| [wrong(case, 1.0), wrong(case, -1.0)]))
}

fn times(_: &mut String) -> f64 {
    largest(levels().filter(|(amplitude, level)| level < amplitude).map(|(amplitude, level)| {
        let mode = precise::Mode { sigma: 0.0, omega2: 1.0, force: 0.0, x: 0.0, v: amplitude, weight: 1.0 };
        let root = first_crossing(&[mode], level, 2.0).expect("the crest is higher");
        let met = first_from(&sine(), [amplitude], [2.0 * amplitude, level], 2.0);
        ((met.t - root.t.0) - root.t.1).abs() * root.slope.abs() / (f64::EPSILON * amplitude)
    }))
}

fn tangencies(wrong: fn(Met, Met) -> bool) -> f64 {
    let mut noise = Noise::new(101);
    count((0..1000).map(|_| {
        // omega is a power of two, so the height of the crest is the amplitude to the bit.
        let (amplitude, omega) = (noise.power(-6.0, 6.0), 2f64.powi(noise.below(20) as i32 - 10));
        let system = Linear::modal([(0.0, omega * omega)], [0.0]);
        // 16 crests
        let run = || first_from(&system, [amplitude * omega], [3.0 * amplitude, amplitude], 100.0 / omega);
        let (met, again) = (run(), run());
        if met.side.is_some() {
            println!("{amplitude:?} sin({omega:?} t) crossed its crest at {}", met.t);
        }
        wrong(met, again)
    }))
}

/// xi'' + xi = -cos tau starts just before its crest, which has the height 1 above the equilibrium. It moves by a small part of its swing,
/// and the cell is as narrow. The level is below or above the crest by 1e-3 to 1e-9 of this way.
fn narrow(note: &mut String) -> f64 {
    let mut total = 0;
    let wrong = |(tau, depth): (f64, f64)| {
        total += 1;
        let (v, force) = (tau.sin(), -tau.cos());
        let mode = precise::Mode { sigma: 0.0, omega2: 1.0, force, x: 0.0, v, weight: 1.0 };
        // 1 - cos tau, without cancellation
        let level = 2.0 * (0.5 * tau).sin().powi(2) * (1.0 - depth);
        let horizon = 2.0 * tau;
        let exact = first_crossing(&[mode], level, horizon).is_some();
        assert_eq!(exact, depth > 0.0, "the level must be on the intended side of the crest");
        let wrong =
            first_from(&Linear::modal([(0.0, 1.0)], [force]), [v], [level, level], horizon).side.is_some() != exact;
        if wrong {
            println!("xi'' + xi = {force:?}, xi'(0) = {v:?}, level {level:?} until {horizon:?}: crossed is {exact}");
        }
        wrong
    };
    let cases = (3..=9).flat_map(|k| [1.0, -1.0].map(|sign| sign * 10f64.powi(-k)));
    let wrong = count(cases.flat_map(|depth| [0.14, 1.4e-2, 1.4e-3, 1.4e-4].map(|tau| (tau, depth))).map(wrong));
    *note = format!("{total} levels");
    wrong
}

fn gear_pairs(_: &mut String) -> f64 {
    let pair = GearPair::paper(0.05, 10.0);
    let start = |theta_dot: f64| State { theta: 1.725, theta_dot, phi_dot: 100.0, ..pair.start(0.0) };
    let t_end = 3e-4;
    let (mut short, mut far) = (0.0, 150.0);
    while far - short > 2e-14 * far {
        let middle = 0.5 * (short + far);
        let reached = !precise::scene(&pair, &start(middle), t_end, 50).events.is_empty();
        if reached { far = middle } else { short = middle }
    }
    // 1e-13 of the speed would be 5e-16 rad, less than the depth below which a crossing counts as a touch.
    let cases = (1..=12).flat_map(|k| [-1.0, 1.0].map(|sign| sign * 10f64.powi(-k)));
    count(cases.map(|depth| pair::run(&pair, &start(far * (1.0 + depth)), t_end).events.is_empty() != (depth < 0.0)))
}
