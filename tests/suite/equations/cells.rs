//! Eqs. (12), (13): the generated matrices of a cell, and the motion between two steps, at random points.

use gearsim::engine::cell::Cell;
use gearsim_tests::oh2005::{GearPair, State};
use nalgebra::SVector;

use crate::TOLERANCE;
use crate::points::{DAMPING, POINTS, Point, STIFFNESS_STEP, TORQUES, points};

/// M q'' + C q' + K q = f entry by entry; entries that the paper does not have are exactly zero.
#[test]
fn matrices_of_a_cell_are_those_of_the_paper() {
    for p in points(POINTS) {
        for others in [0, DAMPING, TORQUES, DAMPING | TORQUES] {
            let (equations, pair) = (p.equations(STIFFNESS_STEP | others), p.pair(others));
            let same = |found: f64, expected: f64, scale: f64| {
                assert!((found - expected).abs() <= TOLERANCE * scale, "{found:e} is not {expected:e} at {p:?}");
            };
            let (a, b) = (pair.i1 / pair.n1.powi(2), pair.i2 / pair.n2.powi(2));
            let (mass, k) = (equations.mass(), [p.k, 1.0, 0.0, 1.0, 0.0]);
            for (i, j, expected) in [(0, 0, a + b), (0, 1, a - b), (1, 0, a - b), (1, 1, a + b)] {
                same(mass[i][j], expected, a + b);
            }
            for (found, expected) in [(equations.stiffness(&k), 2.0 * p.k), (equations.damping(&k), 2.0 * pair.c())] {
                assert_eq!([found[0], [found[1][0], 0.0]], [[0.0; 2]; 2], "{p:?}");
                same(found[1][1], expected, expected);
            }
            assert_eq!(equations.load(&k)[0], 0.0, "{p:?}");
            same(equations.load(&k)[1], 2.0 * pair.t0, 2.0 * pair.t0.abs());
        }
    }
}

/// The change of state over a time of up to ten radians of the oscillation, against the closed form by hand: in units
/// of the amplitudes that (12), (13) are sums of. Underdamped cells; the phase w t has ten rounding errors of its own,
/// hence the larger number of them.
fn error_of_motion(p: &Point, pair: &GearPair, turn: f64) -> f64 {
    let equations = p.equations(STIFFNESS_STEP | DAMPING | TORQUES);
    let cell = Cell::new(&*equations, &[p.k]).expect("a sound cell");
    let sigma = pair.zeta * pair.w0();
    let w = (pair.m2() * p.k - sigma * sigma).sqrt();
    // Start at rest in theta: its drift is checked by itself in the energy tests, and would hide the rest here.
    let from = State { theta: 0.0, theta_dot: 0.0, phi: p.phi, phi_dot: p.phi_dot };
    let t = turn / w;
    let expected = pair.closed_form(p.k, from, t);
    let flight = cell.flight(&SVector::from([0.0, p.phi]), &SVector::from([0.0, p.phi_dot]));
    let point = flight.at(t);
    let (dq, dv) = (cell.shapes * point.moved, cell.shapes * point.gained);
    let amplitude = (p.phi.abs() + (pair.t0 / p.k).abs()) + p.phi_dot.abs() / w;
    let scale = [amplitude, amplitude * (w + sigma)];
    let errors = [
        (dq[1] - (expected.phi - from.phi)) / scale[0],
        (dv[1] - (expected.phi_dot - from.phi_dot)) / scale[1],
        (dq[0] - expected.theta) / (scale[0] + p.phi_dot.abs() * t),
        (dv[0] - expected.theta_dot) / scale[1],
    ];
    errors.into_iter().fold(0.0, |m, e| m.max(e.abs()))
}

/// Inertias referred to the mesh, I/N^2, up to this ratio. M as a matrix of numbers holds their sum and their difference,
/// and has lost as many digits of the smaller as the ratio has; the inverse in closed form has them.
const LARGEST_RATIO: f64 = 1e12;

/// Points whose cell is underdamped, and a phase w t from 1e-3 to 10 for each.
fn underdamped() -> impl Iterator<Item = (Point, GearPair, f64)> {
    points(8 * POINTS).enumerate().filter_map(|(i, p)| {
        let pair = p.pair(DAMPING | TORQUES);
        let ratio = pair.zeta * pair.w0() / (pair.m2() * p.k).sqrt();
        let (a, b) = (pair.i1 / pair.n1.powi(2), pair.i2 / pair.n2.powi(2));
        (ratio < 0.9 && a.max(b) < LARGEST_RATIO * a.min(b))
            .then(|| (p, pair, 10f64.powf((i % 4000) as f64 / 1000.0 - 3.0)))
    })
}

#[test]
fn motion_in_a_cell_is_that_of_the_paper() {
    let (mut n, mut worst) = (0, 0.0f64);
    for (p, pair, turn) in underdamped() {
        let error = error_of_motion(&p, &pair, turn);
        n += 1;
        assert!(error < TOLERANCE, "{error:e} after w t = {turn} at {p:?}");
        worst = worst.max(error);
    }
    println!("{n} cells, error {worst:.1e} of the amplitude");
    assert!(n >= POINTS, "only {n} cells");
}

#[test]
fn a_wrong_cell_is_told() {
    let told = |change: fn(&mut GearPair)| {
        underdamped().any(|(p, mut pair, turn)| {
            change(&mut pair);
            error_of_motion(&p, &pair, turn) > TOLERANCE
        })
    };
    assert!(told(|p| p.zeta *= 1.0 + 1e-11) && told(|p| p.t0 *= 1.0 + 1e-12) && told(|p| p.i1 *= 1.0 + 1e-12));
}
