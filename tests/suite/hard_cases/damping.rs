//! Row 6: damping factors 0, 1 +- 10^-k, and up to 1e6.

use gearsim::__private::Vector;
use gearsim_tests::oh2005::{GearPair, State};
use gearsim_tests::precise::cell::{Law, Motion};
use gearsim_tests::precise::number::{Real, Scalar};

use crate::case::{Case, largest};
use crate::linear::Linear;
use crate::scenes::MULTIPLE;
use crate::scenes::compare::compare;

pub const CASES: &[Case] = &[
    Case {
        row: "6",
        name: "one mode at zeta = 0, 1e-12 to 1e6, 1 +- 1e-1 to 1e-15",
        proves: "xi and xi' as in 50 digits, at every time from 1e-8 to 100 periods",
        tolerance: 40.0,
        unit: "eps (1 + wd t) of the largest value so far",
        reason: "a rounding error of omega shifts the phase; near zeta = 1 the two roots differ by sqrt(eps)",
        measure: responses,
    },
    Case {
        row: "6",
        name: "from zeta = 1 - 1e-k to 1 + 1e-k, k = 4 to 16",
        proves: "xi is continuous through critical damping: it differs by no more than its derivative by zeta allows",
        tolerance: 8.0,
        unit: "eps + 2e-k",
        reason: "|d xi/d zeta| <= 2 here, plus the rounding errors of xi",
        measure: continuity,
    },
    Case {
        row: "6",
        name: "gear pair at zeta = 0, 1e-9, 1 +- 1e-12, 30, 1e3, 1e6",
        proves: "events and end as in 50 digits",
        tolerance: MULTIPLE,
        unit: "eps (growth of disturbances + 1) per event",
        reason: "as for random gear pairs; infinite if an event differs",
        measure: scenes,
    },
    Case {
        row: "6",
        name: "gear pair so slow that it stays in a cell for 300 to 2,370 decay times",
        proves: "events and end as in 50 digits: nothing is left of the vibration",
        tolerance: MULTIPLE,
        unit: "eps (growth of disturbances + 1) per event",
        reason: "as for random gear pairs; infinite if an event differs",
        measure: rests,
    },
];

fn powers(from: i32, to: i32) -> impl Iterator<Item = f64> + Clone {
    (from..=to).map(|k| 10f64.powi(k))
}

fn responses(note: &mut String) -> f64 {
    let near = powers(-15, -1).flat_map(|d| [1.0 - d, 1.0 + d]);
    let zetas: Vec<f64> = [0.0, 1.0].into_iter().chain(powers(-12, 6)).chain(near).collect();
    *note = format!("{} damping factors", zetas.len());
    largest(zetas.into_iter().flat_map(|zeta| {
        let (omega, v, force) = (3.0, 0.7, -4.0);
        let cell = Linear::modal([(zeta * omega, omega * omega)], [force]).cell();
        let flight = cell.flight(&Vector::zeros(1), &Vector::from([v]));
        let [sigma, omega2] = [cell.modes[0].sigma, cell.modes[0].omega2];
        let exact = move |t: f64| {
            let [sigma, omega2, force, v] = [sigma, omega2, force, v].map(Real::<192>::exact);
            let motion = Motion::new(Law::new(sigma, omega2), force, Real::exact(0.0), v, Real::exact(1.0));
            let (x, v) = motion.state(&Real::exact(t));
            (x.approx(), v.approx())
        };
        let damped = cell.modes[0].damped_frequency();
        let times = powers(-8, 2).flat_map(|t| [t / omega, 2.7 * t / omega]);
        let mut far = 0f64;
        times
            .map(move |t| {
                let point = flight.at(t);
                let (x, v_t) = exact(t);
                far = far.max(x.abs());
                let turns = f64::EPSILON * (1.0 + damped * t);
                let (x, v_t) = ((point.moved[0] - x).abs(), (v + point.gained[0] - v_t).abs());
                largest([x / (turns * far), v_t / (turns * v.abs().max(force.abs() / omega))])
            })
            .collect::<Vec<_>>()
    }))
}

fn rests(note: &mut String) -> f64 {
    let decays = (0..70).map(|i| 300.0 + 30.0 * f64::from(i));
    let scenes: Vec<_> = decays.flat_map(|decays| [1e-3, 10.0].map(|t0| (decays, t0))).collect();
    let mut events = 0;
    let errors = scenes.iter().map(|&(decays, t0)| {
        let pair = GearPair::paper(0.7, t0);
        let theta_dot = pair.width1 * 0.7 * pair.w0() / decays;
        let State { phi, .. } = pair.start(0.0);
        let start = State { theta: 0.01, theta_dot, phi: 1.5 * phi, phi_dot: 0.0 };
        let compared = compare(&pair, &start, 2.2 * pair.width1 / theta_dot);
        events += compared.events;
        if compared.wrong.is_some() { f64::INFINITY } else { compared.error }
    });
    let worst = largest(errors.collect::<Vec<_>>());
    *note = format!("{} runs, {events} events", scenes.len());
    worst
}

fn continuity(_: &mut String) -> f64 {
    let at = |zeta: f64, t: f64| {
        let cell = Linear::modal([(zeta, 1.0)], [-0.6]).cell();
        let flight = cell.flight(&Vector::zeros(1), &Vector::from([0.8]));
        flight.at(t).moved[0]
    };
    largest((4..=16).flat_map(|k| {
        let d = 10f64.powi(-k);
        (1..=40)
            .map(move |i| 0.25 * f64::from(i))
            .map(move |t| (at(1.0 + d, t) - at(1.0 - d, t)).abs() / (f64::EPSILON + 2.0 * d))
    }))
}

fn scenes(note: &mut String) -> f64 {
    let zetas = [0.0, 1e-9, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 30.0, 1e3, 1e6];
    let mut events = 0;
    let worst =
        largest(zetas.into_iter().flat_map(|zeta| [60.0, -1500.0].map(|rpm| (zeta, rpm))).map(|(zeta, rpm)| {
            let pair = GearPair::paper(zeta, 10.0);
            let start = State { theta: 0.5, phi: 2e-3, phi_dot: 3.0, ..pair.start(rpm) };
            let compared = compare(&pair, &start, 30.0 / start.theta_dot.abs());
            events += compared.events;
            if let Some(what) = &compared.wrong {
                println!("{what}: {pair:?}");
            }
            if compared.wrong.is_some() { f64::INFINITY } else { compared.error }
        }));
    *note = format!("{events} events");
    worst
}
