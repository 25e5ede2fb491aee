//! Row 13: coincident and defective modes, compared with the matrix exponential.

use gearsim::__private::Vector;
use gearsim_tests::precise::exponential::Exponential;
use gearsim_tests::precise::number::{Real, Scalar};
use nalgebra::{SMatrix, SVector};

use crate::case::{Case, largest};
use crate::linear::Linear;
use crate::noise::Noise;

pub const CASES: &[Case] = &[
    Case {
        row: "13",
        name: "random cells of three coordinates, with a rigid-body mode or without",
        proves: "q and q' agree with the matrix exponential in 50 digits",
        tolerance: 64.0,
        unit: "eps (1 + rate t)",
        reason: "rounding errors of the eigenvalue problem and of the transformations, whose condition number is up to 10",
        measure: |note| cells(note, 1301, Kind::Any),
    },
    Case {
        row: "13",
        name: "coincident modes, undamped and damped",
        proves: "any basis of their eigenspace gives the motion",
        tolerance: 64.0,
        unit: "eps (1 + rate t)",
        reason: "as for random cells",
        measure: |note| cells(note, 1302, Kind::Coincident),
    },
    Case {
        row: "13",
        name: "defective cells: critically damped modes, coincident or single",
        proves: "no basis of complex modes is needed",
        tolerance: 64.0,
        unit: "eps (1 + rate t)",
        reason: "as for random cells",
        measure: |note| cells(note, 1303, Kind::Critical),
    },
];

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Any,
    Coincident,
    Critical,
}

/// Cells M q'' + C q' + K q = f from M = AᵀA, K = Aᵀ diag(omega²) A, C = Aᵀ diag(2 sigma) A.
fn cells(note: &mut String, seed: u64, kind: Kind) -> f64 {
    let mut noise = Noise::new(seed);
    *note = "200 cells".to_string();
    largest((0..200).map(|case| {
        let a = loop {
            let a = SMatrix::<f64, 3, 3>::from_fn(|_, _| noise.even());
            let values = a.singular_values();
            if values.max() < 10f64.sqrt() * values.min() {
                break a;
            }
        };
        let mut omega = [noise.power(-1.0, 1.0), noise.power(-1.0, 1.0), noise.power(-1.0, 1.0)];
        match kind {
            Kind::Any => omega[0] *= f64::from(case % 2),
            Kind::Coincident => omega = [omega[0]; 3],
            Kind::Critical => omega[1] = omega[0],
        }
        let zeta = if kind == Kind::Critical { 1.0 } else { [0.0, 0.1, 2.0][case as usize % 3] };
        let product = |d: [f64; 3]| {
            let x = a.transpose() * SMatrix::from_diagonal(&SVector::from(d)) * a;
            // Made exactly symmetric, as the derived matrices are.
            std::array::from_fn(|i| std::array::from_fn(|j| x[(i.min(j), i.max(j))]))
        };
        let system = Linear {
            mass: product([1.0; 3]),
            damping: product(omega.map(|w| 2.0 * zeta * w)),
            stiffness: product(omega.map(|w| w * w)),
            load: [(); 3].map(|()| noise.even()),
            normal: [1.0; 3],
        };
        let (q, v) = ([(); 3].map(|()| noise.even()), [(); 3].map(|()| noise.even()));
        let t = noise.power(-2.0, 1.0);
        let cell = system.cell();
        let flight = cell.flight(&Vector::from(q), &Vector::from(v));
        let (dq, dv) = flight.increments(&flight.at(t));
        let exact = propagate(&system, q, v, t);
        let rate = omega.iter().fold(0.0, |m: f64, w| m.max(w * (1.0 + 2.0 * zeta)));
        // A motion of the fastest mode with amplitude 1 has the speed `rate`.
        let size = largest((0..3).map(|i| exact.0[i].abs().max(q[i].abs()))) + t * largest(v.map(f64::abs));
        let apart = |i: usize| (q[i] + dq[i] - exact.0[i]).abs().max((v[i] + dv[i] - exact.1[i]).abs() / rate.max(1.0));
        largest((0..3).map(apart)) / (size * f64::EPSILON * (1.0 + rate * t))
    }))
}

/// q and q' after the time `t` \[s\].
fn propagate(system: &Linear<3>, q: [f64; 3], v: [f64; 3], t: f64) -> ([f64; 3], [f64; 3]) {
    let [q, v] = [q, v].map(|x| x.map(Real::<192>::exact));
    let whole = Exponential::new(&system.mass, &system.damping, &system.stiffness, &system.load);
    let (q, v) = whole.over(&Real::exact(t)).of(&q, &v);
    (std::array::from_fn(|i| q[i].approx()), std::array::from_fn(|i| v[i].approx()))
}
