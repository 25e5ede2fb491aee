//! Row 5: ratios of stiffness and inertia from 1e-9 to 1e9, and cells without stiffness.

use gearsim::__private::{Cell, Vector};
use gearsim_tests::oh2005::{GearPair, State};

use crate::case::{Case, largest};
use crate::noise::Noise;
use crate::pair;
use crate::scenes::MULTIPLE;
use crate::scenes::compare::compare;

const UNIT: &str = "eps (growth of disturbances + 1) per event";
const GROWN: &str = "as for random gear pairs: each event adds rounding errors; infinite if an event differs";

pub const CASES: &[Case] = &[
    Case {
        row: "5",
        name: "stiffness ratio k2/k1 of 1e-9 to 1e9",
        proves: "events and end as in 50 digits",
        tolerance: MULTIPLE,
        unit: UNIT,
        reason: GROWN,
        measure: |note| against(note, powers().map(|r| GearPair { k2: 1430.0 * r, ..GearPair::paper(0.0, 3.0) })),
    },
    Case {
        row: "5",
        name: "inertia ratio I2/I1 of 1e-9 to 1e9",
        proves: "events and end as in 50 digits",
        tolerance: MULTIPLE,
        unit: UNIT,
        reason: GROWN,
        measure: |note| against(note, powers().map(|r| GearPair { i2: 2.89e-3 * r, ..GearPair::paper(0.02, 3.0) })),
    },
    Case {
        row: "5",
        name: "one of two cells without stiffness",
        proves: "events and end as in 50 digits",
        tolerance: MULTIPLE,
        unit: UNIT,
        reason: GROWN,
        measure: |note| {
            let (zetas, torques) = ([0.0, 0.02, 3.0], [0.0, 1.0, -30.0]);
            let each = |zeta| torques.map(|t0| GearPair { k2: 0.0, ..GearPair::paper(zeta, t0) });
            against(note, zetas.into_iter().flat_map(each))
        },
    },
    Case {
        row: "5",
        name: "flight without stiffness",
        proves: "q = a + b t for any t, and constant speeds",
        tolerance: 16.0,
        unit: "eps of the way",
        reason: "transformation to modes, product with t, and back: a dozen products and sums",
        measure: flight,
    },
    Case {
        row: "5",
        name: "momentum of theta at inertia ratios of 1e-9 to 1e9",
        proves: "no force acts on theta within a cell: M_theta.q' is constant",
        tolerance: 8.0,
        unit: "eps of the larger part",
        reason: "one product and one sum in each direction",
        measure: momentum,
    },
];

fn powers() -> impl Iterator<Item = f64> {
    [-9, -6, -3, -1, 1, 3, 6, 9].into_iter().map(|k| 10f64.powi(k))
}

fn against(note: &mut String, pairs: impl Iterator<Item = GearPair>) -> f64 {
    let (mut events, mut runs) = (0, 0);
    let worst = largest(pairs.flat_map(|pair| [100.0, -900.0].map(|rpm| (pair, rpm))).map(|(pair, rpm)| {
        let start = State { phi: 2e-3, phi_dot: 1.0, theta: 0.5, ..pair.start(rpm) };
        // A few pitches of theta, but at most a few hundred periods of the fastest oscillation.
        let fastest = (pair.m2() * pair.k1.max(pair.k2)).sqrt();
        let t_end = (20.0 / start.theta_dot.abs()).min(3e3 / fastest);
        let compared = compare(&pair, &start, t_end);
        (events, runs) = (events + compared.events, runs + 1);
        match compared.wrong {
            Some(what) => {
                println!("{what}: {pair:?}, {start:?}, until {t_end:e}");
                f64::INFINITY
            }
            None => {
                println!("{:.1} units, {} events: {pair:?} {start:?} {t_end:e}", compared.error, compared.events);
                compared.error
            }
        }
    }));
    *note = format!("{runs} scenes, {events} events");
    worst
}

fn flight(_: &mut String) -> f64 {
    let mut noise = Noise::new(501);
    let equations = pair::equations(&GearPair::paper(0.0, 0.0));
    let cell = Cell::new(&*equations, &pair::values(0.0)).expect("a cell without stiffness");
    largest((0..1000).map(|_| {
        let v = Vector::from([noise.even(), noise.even()]);
        let (flight, t) = (cell.flight(&Vector::from([noise.even(), noise.even()]), &v), noise.power(-9.0, 9.0));
        let (dq, dv) = flight.increments(&flight.at(t));
        let way = largest([dq[0] - v[0] * t, dq[1] - v[1] * t].map(f64::abs)) / (v.amax() * t);
        largest([way, dv.amax() / v.amax()]) / f64::EPSILON
    }))
}

fn momentum(_: &mut String) -> f64 {
    let mut noise = Noise::new(502);
    largest(powers().flat_map(|ratio| {
        let equations = pair::equations(&GearPair { i2: 2.89e-3 * ratio, ..GearPair::paper(0.0, 3.0) });
        let (cell, m) = (
            Cell::new(&*equations, &pair::values(2000.0)).expect("a cell"),
            equations.mass(&[0.0; 2]).row(0).clone_owned(),
        );
        [(); 50].map(|()| {
            let [q, v] = [(); 2].map(|()| Vector::from([noise.even(), noise.even()]));
            let flight = cell.flight(&q, &v);
            let (_, dv) = flight.increments(&flight.at(noise.unit() / cell.modes[1].rate));
            let largest = largest([m[0] * (v[0].abs() + dv[0].abs()), (m[1] * (v[1].abs() + dv[1].abs())).abs()]);
            (m[0] * dv[0] + m[1] * dv[1]).abs() / (f64::EPSILON * largest)
        })
    }))
}
