//! A scene with its reference, as JSON. The reference is the result of the engine with 50 digits; its difference from the result with 70
//! digits is the error of the reference.
//!
//! Errors are relative to the scales of the motion: theta to a pitch, theta' to its value at the start, phi to T0/k1, phi' to
//! w0 T0/k1. The growth of a disturbance of the initial state shows how many digits any method loses in the scene.

use gearsim_tests::oh2005::{GearPair, Kind, PITCH, State};
use gearsim_tests::precise::scene::{Run, scene};
use serde_json::{Value, json};

use crate::case::{self, Case};

/// Relative size of the disturbance.
const DISTURBANCE: f64 = 1e-13;

/// The scene and its reference.
///
/// # Errors
/// If the scene is not valid.
pub fn of(case: &Case, quick: bool) -> anyhow::Result<Value> {
    let checked = case.scene(quick)?;
    let pair = case::pair(&checked);
    let (start, t_end) = (case::start(&checked, &pair), checked.t_end);
    let sizes = sizes(&pair, &start);
    let [run, again] = [50, 70].map(|digits| scene(&pair, &start, t_end, digits));
    // Starts with a disturbed deflection, and with a disturbed speed.
    let by = 1.0 + DISTURBANCE;
    let grown = [State { phi: start.phi * by, ..start }, State { theta_dot: start.theta_dot * by, ..start }]
        .map(|start| distance(&run, &scene(&pair, &start, t_end, 50), &sizes) / DISTURBANCE);
    let events: Vec<_> = run.events.iter().map(|e| json!([e.t.0, e.t.1, word(e.kind), e.cell_to])).collect();
    let two = |x: (f64, f64)| json!([x.0, x.1]);
    Ok(json!({
        "name": case.name,
        "about": case.about,
        "command": case.command(quick),
        "m1": pair.m1(), "m2": pair.m2(), "c": pair.c(), "t0": pair.t0,
        "i1": pair.i1, "i2": pair.i2, "n1": pair.n1, "n2": pair.n2,
        "k": [pair.k1, pair.k2],
        "width": [pair.width1, pair.width2()],
        "pitch": PITCH,
        "start": [0.0, start.theta_dot, start.phi, start.phi_dot],
        "t_end": t_end,
        "sizes": sizes,
        "reference": {
            "events": events,
            "cell": run.end.cell,
            "end": [two(run.end.local), two(run.end.theta_dot), two(run.end.phi), two(run.end.phi_dot)],
            "error": distance(&run, &again, &sizes),
            "growth": grown[0].max(grown[1]),
            "narrowest": run.narrowest,
        },
    }))
}

/// Scales of theta, theta', phi, phi' [rad, rad/s, rad, rad/s].
fn sizes(pair: &GearPair, start: &State) -> [f64; 4] {
    let phi = pair.t0 / pair.k1;
    [PITCH, start.theta_dot, phi, pair.w0() * phi]
}

/// Largest relative difference of two states at the end; infinite if the events differ.
fn distance(a: &Run, b: &Run, sizes: &[f64; 4]) -> f64 {
    let same = a.events.len() == b.events.len()
        && a.events.iter().zip(&b.events).all(|(a, b)| (a.kind, a.cell_to) == (b.kind, b.cell_to));
    if !same {
        return f64::INFINITY;
    }
    let parts = |run: &Run| [run.end.local, run.end.theta_dot, run.end.phi, run.end.phi_dot];
    let each = parts(a).into_iter().zip(parts(b)).zip(sizes);
    each.map(|((a, b), size)| ((a.0 - b.0) + (a.1 - b.1)).abs() / size).fold(0.0, f64::max)
}

/// The word for an event in the JSON files.
pub fn word(kind: Kind) -> &'static str {
    match kind {
        Kind::Transmit => "transmit",
        Kind::Reflect => "reflect",
    }
}
