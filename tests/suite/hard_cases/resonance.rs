//! Row 12: parametric resonance. phi'' + 2 sigma phi' + M2 k(Omega t) phi = 0 is Meissner's equation, the classical form of the gear
//! pair (Eq. (6)) without torque. Its solution must grow exactly by the Floquet multipliers of a pitch.

use gearsim::scene::Scene;
use gearsim_tests::oh2005::{GearPair, PITCH, State};
use gearsim_tests::precise::cell::{Law, Motion};
use gearsim_tests::precise::number::{Real, Scalar};

use crate::case::{Case, largest};
use crate::{common, pair};

pub const CASES: &[Case] = &[
    Case {
        row: "12",
        name: "Meissner's equation in its main resonance, undamped and damped",
        proves: "after 100 pitches phi and phi' equal the product of the cells' propagators in 50 digits",
        tolerance: 8.0,
        unit: "eps w t of the growth",
        reason: "rounding errors of the frequencies and of the switching times shift the phase",
        measure: states,
    },
    Case {
        row: "12",
        name: "growth per pitch in the main resonance",
        proves: "it is the larger Floquet multiplier, with and without damping",
        tolerance: 1e-12,
        unit: "of the multiplier",
        reason: "the rounding errors of 100 pitches over 100; the part of the second multiplier has died away",
        measure: multipliers,
    },
    Case {
        row: "12",
        name: "edge of the resonance, trace = -2",
        proves: "linear growth: x(2n) - 2 x(n) + x(0) = 0",
        tolerance: 1e-8,
        unit: "of x(2n)",
        reason: "the edge is found to eps, so the two multipliers differ by sqrt(eps)",
        measure: edge,
    },
];

type Digits = Real<192>;

/// Number of pitches of a run.
const PITCHES: usize = 100;

fn scene(pair: &GearPair, start: &State, pitches: f64) -> Scene {
    let damping = if pair.zeta > 0.0 { r#", "damping""# } else { "" };
    let effects = format!(r#"effects=["stiffness_step", "frozen_phase"{damping}]"#);
    let mut numbers = pair::scene(pair, start, pitches * PITCH / start.theta_dot);
    // No events are recorded: theta, which the growing phi drives far away, is not needed here.
    numbers.output.events = false;
    Scene { effects: common::scene("oh2005/energy_300rpm", &[effects]).effects, ..numbers }
}

/// (phi, phi') at the end of the engine's run over some pitches.
fn engine(pair: &GearPair, start: &State, pitches: f64) -> [f64; 2] {
    let end = pair::of(&scene(pair, start, pitches)).end;
    [end.phi, end.phi_dot]
}

/// The same in 50 digits, cell after cell from theta = 0.
fn exact(pair: &GearPair, start: &State, pitches: f64) -> [Digits; 2] {
    let real = Digits::exact;
    let part = |n: f64, inertia: f64| real(n) * real(n) / real(inertia);
    let m2 = (part(pair.n1, pair.i1) + part(pair.n2, pair.i2)).scaled(-1);
    let sigma = real(pair.zeta) * (m2.clone() * (real(pair.k1) + real(pair.k2)).scaled(-1)).root();
    let laws = [pair.k1, pair.k2].map(|k| Law::new(sigma.clone(), m2.clone() * real(k)));
    let t_end = real(pitches * PITCH / start.theta_dot);
    let (mut x, mut v, mut t) = (real(start.phi), real(start.phi_dot), real(0.0));
    for cell in 0.. {
        let whole = real((cell / 2) as f64) * real(PITCH);
        let until = if cell % 2 == 0 { whole + real(pair.width1) } else { whole + real(PITCH) } / real(start.theta_dot);
        let last = until > t_end;
        let until = if last { t_end.clone() } else { until };
        let motion = Motion::new(laws[cell % 2].clone(), real(0.0), x, v, real(1.0));
        (x, v) = motion.state(&(until.clone() - t));
        if last {
            return [x, v];
        }
        t = until;
    }
    unreachable!("the cells have no end")
}

/// The gear pair at the speed of its main resonance, about theta' = 2 w0, at which the absolute value of the trace is largest.
fn resonant(zeta: f64) -> (GearPair, State) {
    let pair = GearPair { k2: 6000.0, ..GearPair::paper(zeta, 0.0) };
    let speeds = (0..40).map(|i| pair.w0() * (1.6 + 0.02 * f64::from(i)));
    let size = |theta_dot: &f64| matrix(&pair, *theta_dot)[0].approx().abs();
    let theta_dot = speeds.max_by(|a, b| size(a).total_cmp(&size(b))).expect("forty speeds");
    (pair, State { theta: 0.0, theta_dot, phi: 1e-3, phi_dot: 0.0 })
}

fn states(note: &mut String) -> f64 {
    let mut grown = vec![];
    let worst = largest([0.0, 0.02, 0.05].map(|zeta| {
        let (pair, start) = resonant(zeta);
        let pitches = PITCHES as f64 + 0.1;
        let (got, want) = (engine(&pair, &start, pitches), exact(&pair, &start, pitches).map(|x| x.approx()));
        let scale = want[0].abs().max(want[1].abs() / pair.w0());
        grown.push(format!("{:.1e}", scale / start.phi));
        let error = (got[0] - want[0]).abs().max((got[1] - want[1]).abs() / pair.w0()) / scale;
        error / (f64::EPSILON * pair.w0() * pitches * PITCH / start.theta_dot)
    }));
    *note = format!("grown by {}", grown.join(", "));
    worst
}

/// Trace and determinant of the monodromy matrix of a pitch, in 50 digits.
fn matrix(pair: &GearPair, theta_dot: f64) -> [Digits; 2] {
    let column = |phi: f64, phi_dot: f64| exact(pair, &State { theta: 0.0, theta_dot, phi, phi_dot }, 1.0);
    let ([a, c], [b, d]) = (column(1.0, 0.0), column(0.0, 1.0));
    [a.clone() + d.clone(), a * d - b * c]
}

fn multipliers(note: &mut String) -> f64 {
    let mut each = vec![];
    let worst = largest([0.0, 0.02].map(|zeta| {
        let (pair, start) = resonant(zeta);
        let [trace, determinant] = matrix(&pair, start.theta_dot).map(|x| x.approx());
        let multiplier = 0.5 * (trace.abs() + (trace * trace - 4.0 * determinant).sqrt());
        let at = |pitches: usize| engine(&pair, &start, pitches as f64)[0].abs();
        let found = (at(2 * PITCHES) / at(PITCHES)).powf(1.0 / PITCHES as f64);
        each.push(format!("{multiplier:.6}"));
        (found / multiplier - 1.0).abs()
    }));
    *note = format!("multipliers {}", each.join(", "));
    worst
}

fn edge(note: &mut String) -> f64 {
    let pair = GearPair::paper(0.0, 0.0);
    let start = State { theta: 0.0, theta_dot: 2.0 * pair.w0(), phi: 1e-3, phi_dot: 1.0 };
    // Above the middle of the resonance the two multipliers meet again: trace + 2 changes sign.
    let beyond = |theta_dot: f64| (matrix(&pair, theta_dot)[0].clone() + Digits::exact(2.0)).approx() > 0.0;
    let (mut inside, mut outside) = (start.theta_dot, 1.5 * start.theta_dot);
    assert!(!beyond(inside) && beyond(outside), "the edge must be between the two speeds");
    while outside.next_down() > inside {
        let middle = 0.5 * (inside + outside);
        if beyond(middle) { outside = middle } else { inside = middle }
    }
    let start = State { theta_dot: inside, ..start };
    let [half, whole] = [50.0, 100.0].map(|pitches| engine(&pair, &start, pitches));
    *note = format!("theta' = {:.6} w0, grown by {:.1}", inside / pair.w0(), (whole[0] / start.phi).abs());
    let first = [start.phi, start.phi_dot];
    let size = whole[0].abs().max(whole[1].abs() / pair.w0());
    largest((0..2).map(|i| (whole[i] - 2.0 * half[i] + first[i]).abs() / size / if i == 0 { 1.0 } else { pair.w0() }))
}
