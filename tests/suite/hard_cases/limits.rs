//! Row 13: stiff shafts, coincident and defective modes, rigid-body modes.

mod exponential;

use gearsim::engine::crossing::Side;
use nalgebra::{SMatrix, SVector};

use crate::case::{Case, largest};
use crate::linear::{Linear, diagonal, first_from};
use crate::noise::Noise;

pub const CASES: &[Case] = &[
    Case {
        row: "13",
        name: "shaft of stiffness 1e2 to 1e10 between two inertias",
        proves: "the rigid limit is reached as O(1/k)",
        tolerance: 1.01,
        unit: "bound ~ 1/k",
        reason: "the bound is that of the closed form, twice the static twist; 1 % for the speed there",
        measure: shaft,
    },
    Case {
        row: "13",
        name: "random cells of three coordinates, with a rigid-body mode or without",
        proves: "q, q' as the matrix exponential in 50 digits says",
        tolerance: 64.0,
        unit: "eps (1 + rate t)",
        reason: "roundings of the eigenvalue problem and of the transformations, conditioned up to 10",
        measure: |note| cells(note, 1301, Kind::Any),
    },
    Case {
        row: "13",
        name: "coincident modes, undamped and damped",
        proves: "any basis of their plane gives the motion",
        tolerance: 64.0,
        unit: "eps (1 + rate t)",
        reason: "as for random cells",
        measure: |note| cells(note, 1302, Kind::Coincident),
    },
    Case {
        row: "13",
        name: "defective: critically damped modes, coincident or alone",
        proves: "no basis of complex modes is needed",
        tolerance: 64.0,
        unit: "eps (1 + rate t)",
        reason: "as for random cells",
        measure: |note| cells(note, 1303, Kind::Critical),
    },
    Case {
        row: "13",
        name: "chain with a stiffness 1e9 times the other, its slow mode",
        proves: "no more digits are lost than the matrix itself has lost",
        tolerance: 8.0,
        unit: "eps k_max/k_min",
        reason: "k_max + k_min rounds k_min by eps k_max/k_min",
        measure: chain,
    },
];

fn shaft(_: &mut String) -> f64 {
    // m1 pulled by f drags m2 along: x1 = f t²/2m + (m2/m) twist, 0 <= twist <= 2 f/(m1 w²).
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
        // The crest of the swing comes before: from there on the speed is at least 99 % of this.
        (rigid - met.t).abs() * (f / m * rigid) / (m2 / m * twist)
    }))
}

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
            // Symmetric to the bit, as the derived matrices are.
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
        let flight = cell.flight(&SVector::from(q), &SVector::from(v));
        let (dq, dv) = flight.increments(&flight.at(t));
        let exact = exponential::propagate(&system, q, v, t);
        let rate = omega.iter().fold(0.0, |m: f64, w| m.max(w * (1.0 + 2.0 * zeta)));
        // Sizes: a motion of the fastest mode at unit size has the speed `rate`.
        let size = largest((0..3).map(|i| exact.0[i].abs().max(q[i].abs()))) + t * largest(v.map(f64::abs));
        let apart = |i: usize| (q[i] + dq[i] - exact.0[i]).abs().max((v[i] + dv[i] - exact.1[i]).abs() / rate.max(1.0));
        largest((0..3).map(apart)) / (size * f64::EPSILON * (1.0 + rate * t))
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
