//! Rows 7, 8: energy over many events, time reversal.

use gearsim::scene::Precision;
use gearsim_tests::oh2005::{GearPair, State};

use crate::case::{Case, largest};
use crate::noise::setting;
use crate::pair::{self, distance};

pub const CASES: &[Case] = &[
    Case {
        row: "7",
        name: "energy of an undamped, aperiodic gear pair in compensated precision",
        proves: "no energy is lost or gained",
        tolerance: 1e-12,
        unit: "of the energy",
        reason: "the limit promised for 1e8 events (GEARSIM_EVENTS); every shorter run keeps it",
        measure: |note| energy(Precision::Compensated, note).0,
    },
    Case {
        row: "7",
        name: "energy drift of the same gear pair in plain precision",
        proves: "an event changes the energy by less than one rounding error",
        tolerance: f64::EPSILON,
        unit: "of the energy per event",
        reason: "the rounding errors of a cell's constants always have the same sign, so the drift is linear; it is documented",
        measure: |note| {
            let (lost, events) = energy(Precision::Plain, note);
            lost / events
        },
    },
    Case {
        row: "8",
        name: "time reversed after 20 to 2000 events",
        proves: "the motion returns to its start",
        tolerance: 8.0,
        unit: "eps growth of disturbances per event",
        reason: "each event adds a few rounding errors, which grow as disturbances of the start do",
        measure: reversal,
    },
];

/// The residual of the energy account at the end over the energy at the start, and the number of events.
fn energy(precision: Precision, note: &mut String) -> (f64, f64) {
    // 480 events a second
    let pair = GearPair::paper(0.0, 10.0);
    let events = setting("GEARSIM_EVENTS", 1_000_000);
    let mut scene = pair::scene(&pair, &pair.start(600.0), events as f64 / 480.0);
    (scene.output.events, scene.solver.precision) = (false, precision);
    let run = pair::of(&scene).outcome;
    let happened = (run.counts.cell_changes + run.counts.reflections) as f64;
    *note = format!("{happened:.1e} events");
    let residual = run.trajectory.residual.last().expect("a row").abs();
    (if run.stopped_by.is_some() { f64::INFINITY } else { residual / run.energy_at_start }, happened)
}

fn reversal(note: &mut String) -> f64 {
    let mut all = vec![];
    let worst = largest([(600.0, 0.04), (600.0, 0.08), (2000.0, 0.3), (4500.0, 0.55)].map(|(rpm, t)| {
        let pair = GearPair::paper(0.0, 1.0);
        // The start is not on a step, because the way back would end on it.
        let start = State { theta: 1.0, ..pair.start(rpm) };
        let turned = |end: &State| State { theta_dot: -end.theta_dot, phi_dot: -end.phi_dot, ..*end };
        let there = pair::run(&pair, &start, t);
        let turn = turned(&there.end);
        let back = pair::run(&pair, &turn, t);
        // The growth of disturbances of the start, and of disturbances at the reversal.
        let grown = [(&start, &there), (&turn, &back)].map(|(from, run)| {
            let by = 1.0 + 1e-9;
            let disturbed = State { phi: from.phi * by, theta_dot: from.theta_dot * by, ..*from };
            distance(&pair::run(&pair, &disturbed, t).end, &run.end, &pair, start.theta_dot) / 1e-9
        });
        let events = there.events.len() as f64;
        all.push(events);
        let grown = 1.0 + grown[0].max(grown[1]);
        distance(&turned(&back.end), &start, &pair, start.theta_dot) / (f64::EPSILON * grown * events)
    }));
    *note = format!("{all:?} events");
    worst
}
