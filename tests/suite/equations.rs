//! Generated code compared with the equations of Oh, Grosh & Barber (2005) written by hand, Eqs. (2)-(6), (9), (11)-(13).
//!
//! Each comparison is done at 10,000 points, with parameters and states log-uniform over many decades. Both sides do about ten
//! operations on the same terms, so they differ by about ten rounding errors of the largest term of the sum: a few 1e-15. The
//! tolerance is 1e-13 of that term. Further tests show that a coefficient that is wrong by 1e-12 is detected.

#[path = "equations/cells.rs"]
mod cells;
#[path = "equations/jumps.rs"]
mod jumps;
#[path = "equations/mobility.rs"]
mod mobility;
#[path = "equations/points.rs"]
mod points;

use gearsim_tests::oh2005::GearPair;
use points::{DAMPING, FROZEN_PHASE, POINTS, Point, RIGID_KINEMATICS, STIFFNESS_STEP, TORQUES, points};

/// Allowed error, relative to the largest term of a sum.
pub const TOLERANCE: f64 = 1e-13;

/// The equations that are written by hand, with the effects that give them.
const FORMS: [(&str, u64); 3] = [
    ("exact, Eqs. (2), (3)", STIFFNESS_STEP),
    ("rigid kinematics, Eqs. (4), (5)", STIFFNESS_STEP | RIGID_KINEMATICS),
    ("classical, Eq. (6)", STIFFNESS_STEP | FROZEN_PHASE),
];

/// theta'' and phi'' by hand, and the largest term of each sum.
fn by_hand(pair: &GearPair, p: &Point, exact: bool) -> ([f64; 2], [f64; 2]) {
    let dk = if exact { p.dk } else { 0.0 };
    let (phi_ddot, theta_ddot) = pair.exact(p.k, dk, p.phi, p.phi_dot);
    let terms = [pair.t0, p.k * p.phi, pair.c() * p.phi_dot];
    // The two terms of M1 may cancel, so the scale is taken from their size, which is at most M2.
    let smooth = terms.into_iter().fold(0.0, |m: f64, x| m.max(x.abs())) * pair.m2();
    let largest = smooth.max((pair.m2() * dk * p.phi * p.phi / 2.0).abs());
    ([theta_ddot, phi_ddot], [largest; 2])
}

/// The largest error of the accelerations over all points, in units of the largest term. `change` may put an error into the
/// hand-written pair.
fn largest_error(effects: u64, change: impl Fn(&mut GearPair)) -> f64 {
    let mut worst: f64 = 0.0;
    for p in points(POINTS) {
        let equations = p.equations(effects);
        let mut pair = p.pair(effects);
        change(&mut pair);
        let (expected, scale) = by_hand(&pair, &p, effects & (RIGID_KINEMATICS | FROZEN_PHASE) == 0);
        // The classical equation keeps theta' constant; only phi'' is compared.
        let from = if effects & FROZEN_PHASE == 0 { 0 } else { 1 };
        let found = equations.acceleration(&p.q(), &p.q_dot(), &p.values(), &p.slopes());
        for i in from..2 {
            worst = worst.max((found[i] - expected[i]).abs() / scale[i]);
        }
    }
    worst
}

#[test]
fn accelerations_equal_those_of_the_paper() {
    for (what, form) in FORMS {
        for others in [0, DAMPING, TORQUES, DAMPING | TORQUES] {
            let worst = largest_error(form | others, |_| {});
            println!("{what}, other effects {others:#b}: error {worst:.1e} of the largest term");
            assert!(worst < TOLERANCE, "{what}, other effects {others:#b}: {worst:e}");
        }
    }
}

#[test]
fn without_effects_the_slope_of_the_stiffness_is_not_read() {
    // Without effects the equations are (4), (5). The slope is NaN here, so reading it would show.
    for p in points(POINTS) {
        let equations = p.equations(0);
        let (expected, scale) = by_hand(&p.pair(0), &p, false);
        let found = equations.acceleration(&p.q(), &p.q_dot(), &p.values(), &[f64::NAN; 4]);
        for i in 0..2 {
            assert!((found[i] - expected[i]).abs() < TOLERANCE * scale[i], "{p:?}");
        }
    }
}

#[test]
fn generated_forces_equal_mass_times_acceleration() {
    // M q'' = F with the mass matrix by hand; the residual is compared with the largest term of its sum.
    for p in points(POINTS) {
        let equations = p.equations(STIFFNESS_STEP | DAMPING | TORQUES);
        let a = equations.acceleration(&p.q(), &p.q_dot(), &p.values(), &p.slopes());
        let f = equations.force(&p.q(), &p.q_dot(), &p.values(), &p.slopes());
        let pair = p.pair(DAMPING | TORQUES);
        let (m1, m2) = (pair.i1 / pair.n1.powi(2), pair.i2 / pair.n2.powi(2));
        let sums = [(m1 + m2) * a[0] + (m1 - m2) * a[1] - f[0], (m1 - m2) * a[0] + (m1 + m2) * a[1] - f[1]];
        let (_, [largest, _]) = by_hand(&pair, &p, true);
        let scale = (m1 + m2) * largest;
        assert!(sums.iter().all(|rest| rest.abs() < TOLERANCE * scale), "{sums:?} of {scale:e} at {p:?}");
    }
}

/// The comparison can fail: a parameter that is wrong by 1e-12, or a missing term, is detected in every form that contains it.
#[test]
fn a_wrong_coefficient_is_detected() {
    type Change = (&'static str, u64, fn(&mut GearPair));
    let changes: [Change; 6] = [
        ("I1", 0, |p| p.i1 *= 1.0 + 1e-12),
        ("I2", 0, |p| p.i2 *= 1.0 + 1e-12),
        ("N1", 0, |p| p.n1 *= 1.0 + 1e-12),
        ("N2", 0, |p| p.n2 *= 1.0 + 1e-12),
        ("zeta", DAMPING, |p| p.zeta *= 1.0 + 1e-12),
        ("T0", TORQUES, |p| p.t0 *= 1.0 + 1e-12),
    ];
    for (what, form) in FORMS {
        for (parameter, needs, change) in changes {
            let worst = largest_error(form | needs, change);
            println!("{what}: {parameter} off by 1e-12 gives {worst:.1e}");
            assert!(worst > TOLERANCE, "{what}: {parameter} off by 1e-12 is not detected: {worst:e}");
        }
    }
    let exact = largest_error(STIFFNESS_STEP, |_| {});
    let mixed = points(POINTS).any(|p| {
        let found = p.equations(STIFFNESS_STEP).acceleration(&p.q(), &p.q_dot(), &p.values(), &p.slopes());
        let (expected, scale) = by_hand(&p.pair(0), &p, false);
        (found[0] - expected[0]).abs() > TOLERANCE * scale[0]
    });
    assert!(exact < TOLERANCE && mixed, "the comparison takes (2), (3) with jump terms for (4), (5)");
}
