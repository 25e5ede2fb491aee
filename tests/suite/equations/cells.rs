//! Eqs. (12), (13): the generated matrices of a cell and the motion between two steps, at random points.

use gearsim::__private::{Cell, Vector};
use gearsim_tests::oh2005::{GearPair, State};

use crate::TOLERANCE;
use crate::points::{DAMPING, POINTS, Point, STIFFNESS_STEP, TORQUES, points};

/// The matrices of M q'' + C q' + K q = f, entry by entry. Entries that are absent in the paper are exactly zero.
#[test]
fn matrices_of_a_cell_equal_those_of_the_paper() {
    for p in points(POINTS) {
        for others in [0, DAMPING, TORQUES, DAMPING | TORQUES] {
            let (equations, pair) = (p.equations(STIFFNESS_STEP | others), p.pair(others));
            let same = |found: f64, expected: f64, scale: f64| {
                assert!((found - expected).abs() <= TOLERANCE * scale, "{found:e} is not {expected:e} at {p:?}");
            };
            let (a, b) = (pair.i1 / pair.n1.powi(2), pair.i2 / pair.n2.powi(2));
            let (mass, k) = (equations.mass(&[0.0; 2]), p.values());
            for (i, j, expected) in [(0, 0, a + b), (0, 1, a - b), (1, 0, a - b), (1, 1, a + b)] {
                same(mass[(i, j)], expected, a + b);
            }
            for (found, expected) in [(equations.stiffness(&k), 2.0 * p.k), (equations.damping(&k), 2.0 * pair.c())] {
                assert_eq!([found[(0, 0)], found[(0, 1)], found[(1, 0)]], [0.0; 3], "{p:?}");
                same(found[(1, 1)], expected, expected);
            }
            assert_eq!(equations.load(&k)[0], 0.0, "{p:?}");
            same(equations.load(&k)[1], 2.0 * pair.t0, 2.0 * pair.t0.abs());
        }
    }
}

/// The error of the change of state after a time t = `turn`/w, compared with the closed form by hand, in units of the amplitudes
/// that are summed in (12), (13). The cell is underdamped. At w t = 10 the angle w t itself adds ten rounding errors.
fn error_of_motion(p: &Point, pair: &GearPair, turn: f64) -> f64 {
    let equations = p.equations(STIFFNESS_STEP | DAMPING | TORQUES);
    let cell = Cell::new(&*equations, &p.values()).expect("a sound cell");
    let sigma = pair.zeta * pair.w0();
    let w = (pair.m2() * p.k - sigma * sigma).sqrt();
    // theta starts at rest. A drift of theta would hide the other terms here; the energy tests check it.
    let from = State { theta: 0.0, theta_dot: 0.0, phi: p.phi, phi_dot: p.phi_dot };
    let t = turn / w;
    let expected = pair.closed_form(p.k, from, t);
    let flight = cell.flight(&Vector::from([0.0, p.phi]), &Vector::from([0.0, p.phi_dot]));
    let point = flight.at(t);
    let (dq, dv) = (&cell.shapes * &point.moved, &cell.shapes * &point.gained);
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

/// Largest ratio of the inertias referred to the mesh, I/N². The entries of M are their sum and their difference, so M has lost
/// as many digits of the smaller one as the ratio has. The inverse in closed form has these digits.
const LARGEST_RATIO: f64 = 1e12;

/// Points whose cell is underdamped, each with an angle w t from 1e-3 to 10.
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
fn motion_in_a_cell_equals_that_of_the_paper() {
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
fn a_wrong_cell_is_detected() {
    let detected = |change: fn(&mut GearPair)| {
        underdamped().any(|(p, mut pair, turn)| {
            change(&mut pair);
            error_of_motion(&p, &pair, turn) > TOLERANCE
        })
    };
    assert!(detected(|p| p.zeta *= 1.0 + 1e-11));
    assert!(detected(|p| p.t0 *= 1.0 + 1e-12));
    assert!(detected(|p| p.i1 *= 1.0 + 1e-12));
}
