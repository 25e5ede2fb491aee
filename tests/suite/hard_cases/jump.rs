//! Row 2: total reflection, near-critical incidence v² = 2 G dV (1 +- 10^-k), equality.

use gearsim::__private::equations::Equations;
use gearsim::__private::{Passage, Side, Surface, Vector};
mod incidence;

use gearsim_tests::oh2005::GearPair;
use gearsim_tests::precise::number::Scalar;
use incidence::{Digits, incidences, square};

use crate::case::{Case, NONE, WRONG, count, largest};
use crate::linear::{Linear, diagonal};
use crate::noise::Noise;
use crate::pair;

pub const CASES: &[Case] = &[
    Case {
        row: "2",
        name: "v² = 2 G dV (1 +- 1e-1 to 1e-14)",
        proves: "transmitted or reflected as a reference of 115 digits decides",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: branches,
    },
    Case {
        row: "2",
        name: "speed after a near-critical step",
        proves: "the only cancellation is that of v² - 2 G dV",
        tolerance: 8.0,
        unit: "eps v²/v+²",
        reason: "six rounding errors of v² and 2 G dV, halved by the square root",
        measure: speeds,
    },
    Case {
        row: "2",
        name: "total reflection",
        proves: "the normal speed keeps its bits and changes its sign",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: reflections,
    },
    Case {
        row: "2",
        name: "v² = 2 G dV to the bit, and its neighbours",
        proves: "equality transmits with v+ = 0, one bit less reflects; dV = 0 changes nothing",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: equality,
    },
    Case {
        row: "2",
        name: "energy across a million steps, transmitted and reflected",
        proves: "T + V is the same on both sides",
        tolerance: 16.0,
        unit: "eps (T + |dV|)",
        reason: "rounding errors of T before and after, and of the jump",
        measure: energy,
    },
];

/// Values of the laws and switches of the gear pair. Only the step of the stiffness matters here.
const VALUES: &[f64] = &[0.0; 9];

/// The engine's decision at a step, and the speeds after it.
fn pass(equations: &dyn Equations, q: [f64; 2], v: [f64; 2], dk: f64) -> (Passage, [f64; 2]) {
    let mut q_dot = Vector::from(v);
    let side = if v[0] >= 0.0 { Side::Upper } else { Side::Lower };
    let passage = Surface::new(equations, 0, &q).pass(&mut q_dot, side, equations.step(0, &q, VALUES, dk));
    (passage, [q_dot[0], q_dot[1]])
}

fn branches(note: &mut String) -> f64 {
    let equations = pair::equations(&GearPair::paper(0.0, 0.0));
    let mut total = 0;
    let wrong = count(incidences(201).map(|i| {
        let (passage, _) = pass(&*equations, [0.0, i.phi], i.v, i.dk);
        total += 1;
        (passage == Passage::Reflected) != square(&i).is_negative() || (i.depth < 0.0) != square(&i).is_negative()
    }));
    *note = format!("{total} incidences");
    wrong
}

fn speeds(_: &mut String) -> f64 {
    let equations = pair::equations(&GearPair::paper(0.0, 0.0));
    largest(incidences(202).filter(|i| i.depth > 0.0).map(|i| {
        let (_, after) = pass(&*equations, [0.0, i.phi], i.v, i.dk);
        let square = square(&i);
        let (exact, relative) = (square.root(), i.v[0] * i.v[0] / square.approx());
        let error = (Digits::exact(after[0].abs()) - exact.clone()).approx().abs() / exact.approx();
        error / (f64::EPSILON * relative)
    }))
}

fn reflections(_: &mut String) -> f64 {
    let equations = pair::equations(&GearPair::paper(0.0, 0.0));
    count(incidences(203).filter(|i| i.depth < 0.0).map(|i| {
        let (passage, after) = pass(&*equations, [0.0, i.phi], i.v, i.dk);
        passage != Passage::Reflected || after[0].to_bits() != (-i.v[0]).to_bits()
    }))
}

fn equality(_: &mut String) -> f64 {
    // G = 1, 2 G dV = dk q_0²: 9 here
    let identity = diagonal([1.0; 2]);
    let none = diagonal([0.0; 2]);
    let system = Linear { mass: identity, damping: none, stiffness: identity, load: [0.0; 2], normal: [1.0, 0.0] };
    let at = |v: f64| pass(&system, [1.0, 0.0], [v, 0.5], 9.0);
    let cases = [3.0f64, -3.0].map(|v| {
        let (more, less) = ((v.abs().next_up()).copysign(v), (v.abs().next_down()).copysign(v));
        [
            at(v) != (Passage::Transmitted, [0.0, 0.5]),
            at(less) != (Passage::Reflected, [-less, 0.5]),
            at(more).0 != Passage::Transmitted || at(more).1[0] * v <= 0.0,
            pass(&system, [0.0, 1.0], [v, 0.5], 9.0) != (Passage::Transmitted, [v, 0.5]),
            pass(&system, [1.0, 0.0], [v, 0.5], 0.0) != (Passage::Transmitted, [v, 0.5]),
        ]
    });
    count(cases.into_iter().flatten())
}

fn energy(_: &mut String) -> f64 {
    let equations = pair::equations(&GearPair::paper(0.0, 0.0));
    let mut noise = Noise::new(204);
    largest((0..1_000_000).map(|_| {
        let (q, dk) = ([0.0, 0.1 * noise.even()], noise.power(0.0, 5.0).copysign(noise.even()));
        let v = [noise.power(0.0, 3.0) * noise.even(), noise.power(0.0, 3.0) * noise.even()];
        let (passage, after) = pass(&*equations, q, v, dk);
        let gain = if passage == Passage::Transmitted { equations.step(0, &q, VALUES, dk) } else { 0.0 };
        let (before, after) = (equations.kinetic(&q, &v), equations.kinetic(&q, &after));
        (after - before + gain).abs() / (f64::EPSILON * (before + gain.abs()))
    }))
}
