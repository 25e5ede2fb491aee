//! Row 13: stiff shafts and rigid-body modes.

use gearsim::__private::{Cell, Side, Vector};
use gearsim_tests::oh2005::GearPair;

use crate::case::{Case, largest};
use crate::common;
use crate::linear::{Linear, diagonal, first_from};
use crate::models::end;
use crate::pair;

pub const CASES: &[Case] = &[
    Case {
        row: "13",
        name: "shaft of stiffness 1e2 to 1e10 between two inertias",
        proves: "the difference from the rigid limit is O(1/k)",
        tolerance: 1.01,
        unit: "bound ~ 1/k",
        reason: "the bound follows from the closed form, twice the static twist; 1 % for the lower speed there",
        measure: shaft,
    },
    Case {
        row: "13",
        name: "slow mode of a chain with one stiffness up to 1e9 times the other",
        proves: "no more digits are lost than the rounded matrix has lost",
        tolerance: 8.0,
        unit: "eps k_max/k_min",
        reason: "k_max + k_min rounds k_min by eps k_max/k_min",
        measure: chain,
    },
    Case {
        row: "13",
        name: "gear pair that rotates with phi at rest",
        proves: "a rigid-body mode has no part in coordinates that it does not move",
        tolerance: 0.0,
        unit: "of the way of theta",
        reason: "no force acts on phi, so phi' = 0 stays exact; any error would add up cell after cell",
        measure: rolling,
    },
    Case {
        row: "13",
        name: "radau where a cell ends within a rounding of the time, at ten ends of a frozen phase",
        proves: "a step of 1e-20 s converges, although its displacements are rounding errors; dop853 gives the same end",
        tolerance: 1e-6,
        unit: "of the motion's sizes",
        reason: "the tolerance of the steps, 1e-9, over some thousand steps",
        measure: shortest_step,
    },
];

fn shaft(_: &mut String) -> f64 {
    // The force f acts on m1, and the shaft pulls m2: x1 = f t²/(2 m) + (m2/m) twist, 0 <= twist <= 2 f/(m1 w²).
    let (m1, m2, f, level) = (1.0, 3.0, 2.0, 5.0);
    let m = m1 + m2;
    largest((2..=10).map(|power| {
        let k = 10f64.powi(power);
        let system = Linear {
            mass: diagonal([m1, m2]),
            damping: diagonal([0.0; 2]),
            stiffness: [[k, -k], [-k, k]],
            load: [f, 0.0],
            normal: [1.0, 0.0],
        };
        let met = first_from(&system, [0.0, 0.0], [1.0, level], 100.0);
        if met.side != Some(Side::Upper) {
            return f64::INFINITY;
        }
        let rigid = (2.0 * level * m / f).sqrt();
        let twist = 2.0 * f / (m1 * k * (1.0 / m1 + 1.0 / m2));
        // The boundary is met before the time of the rigid limit; from there on the speed is at least 99 % of that of the rigid limit.
        (rigid - met.t).abs() * (f / m * rigid) / (m2 / m * twist)
    }))
}

fn chain(note: &mut String) -> f64 {
    *note = "k_max/k_min = 1, 1e3, 1e6, 1e9".to_string();
    largest([1.0, 1e3, 1e6, 1e9].map(|k| {
        // ground - 1 - m - k - m: det(K - w² M) = w⁴ - (1 + 2k) w² + k, its small root without cancellation
        let system = Linear {
            mass: diagonal([1.0, 1.0]),
            damping: diagonal([0.0; 2]),
            stiffness: [[1.0 + k, -k], [-k, k]],
            load: [0.0; 2],
            normal: [1.0, 0.0],
        };
        let b = 1.0 + 2.0 * k;
        let exact = 2.0 * k / (b + (b * b - 4.0 * k).sqrt());
        (system.cell().modes[0].omega2 / exact - 1.0).abs() / (f64::EPSILON * k)
    }))
}

fn rolling(_: &mut String) -> f64 {
    let equations = pair::equations(&GearPair::paper(0.05, 0.0));
    largest([1430.0, 2780.0].map(|k| {
        let cell = Cell::new(&*equations, &pair::values(k)).expect("a cell of the paper's");
        let flight = cell.flight(&Vector::zeros(2), &Vector::from([1500.0, 0.0]));
        let (dq, _) = flight.increments(&flight.at(1e-3));
        (dq[1] / dq[0]).abs()
    }))
}

fn shortest_step(note: &mut String) -> f64 {
    let [(steps, a), (_, b)] = ["radau", "dop853"].map(|method| {
        let set = [
            format!("run.method={method}"),
            r#"effects=["stiffness_step", "transmission_error", "backlash", "viscous_friction", "torques", "frozen_phase"]"#.into(),
            "run.t_end=3.1 ms".into(),
        ];
        let run = common::run(&common::scene("train_kahraman_singh", &set));
        (run.solver.steps, end(&run))
    });
    *note = format!("{steps} steps of radau");
    let apart = |a: &[f64], b: &[f64]| largest(a.iter().zip(b).map(|(a, b)| (a - b).abs() / b.abs()));
    apart(&a.0, &b.0).max(apart(&a.1, &b.1))
}
