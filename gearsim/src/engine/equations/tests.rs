//! The expansion of `equations!` against hand-written formulas, and its defaults for what a file does not state.

mod many_effects;

use crate::engine::equations::{Derived, Equations, Switching, accelerated, compliance, direction, mobility};
use crate::engine::vector::{Matrix, Vector};

use crate::model::{Range, Start};
use crate::scene::Effects;
use gearsim_generated::gear_pair::GearPair;
use gearsim_generated::idler::Idler;

const STIFFNESS_STEP: u64 = 1;
const RIGID_KINEMATICS: u64 = 2;
const FROZEN_PHASE: u64 = 4;
const TRANSMISSION_ERROR: u64 = 8;
const DAMPING: u64 = 32;
const TORQUES: u64 = 64;
const SLIDING_FRICTION: u64 = 128;

/// N1, N2, I1, I2, zeta, T0, b, alpha, NaN for the parameters of absent effects, and the mid value of k.
const NUMBERS: [f64; 37] = {
    let mut numbers = [f64::NAN; 37];
    let [n1, n2, i1, i2, zeta, t0, _, alpha, ..] = &mut numbers;
    (*n1, *n2, *i1, *i2, *zeta, *t0, *alpha) = (24.0, 96.0, 1.15e-4, 2.9e-2, 0.03, 10.0, 0.35);
    numbers
};
const MID: f64 = 2.5e4;

/// A point: q, q', k, dk and ddk.
const Q: [f64; 2] = [0.7, 3.0e-4];
const V: [f64; 2] = [31.0, -0.4];
const K: [f64; VALUES] = values([3.1e4]);
const DK: [f64; VALUES] = values([1.7e5]);
const DDK: [f64; VALUES] = values([-2.3e6]);

/// The number of laws of the gear pair and of symbols of its switches.
const VALUES: usize = 9;

/// The values of its first laws; NaN for those of absent effects.
const fn values<const L: usize>(laws: [f64; L]) -> [f64; VALUES] {
    let (mut values, mut i) = ([f64::NAN; VALUES], 0);
    while i < L {
        values[i] = laws[i];
        i += 1;
    }
    values
}

fn gear_pair(effects: u64) -> Box<dyn Equations> {
    GearPair::equations(&set::<GearPair>(effects), &NUMBERS, &[MID]).unwrap()
}

/// The effects of a model whose bits are 1.
fn set<D: Derived>(bits: u64) -> Effects {
    Effects::numbered(&D::MODEL, (0..u64::BITS as usize).filter(|i| bits >> i & 1 == 1))
}

/// M1, M2 and C of the gear pair, from the parameters above.
fn constants() -> (f64, f64, f64) {
    let [n1, n2, i1, i2, zeta, ..] = NUMBERS;
    let (a, b) = (n1 * n1 / i1, n2 * n2 / i2);
    let m2 = (a + b) / 2.0;
    ((a - b) / 2.0, m2, 2.0 * zeta * (MID / m2).sqrt())
}

#[track_caller]
fn close(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len());
    for (x, y) in found.iter().zip(expected) {
        assert!((x - y).abs() <= 1e-12 * y.abs().max(1e-12), "{found:?} is not {expected:?}");
    }
}

#[test]
fn energies_and_work() {
    let e = gear_pair(STIFFNESS_STEP | DAMPING | TORQUES);
    let [n1, n2, i1, i2, _, t0, ..] = NUMBERS;
    let (w1, w2) = ((V[0] + V[1]) / n1, (V[0] - V[1]) / n2);
    close(&[e.kinetic(&Q, &V)], &[i1 * w1 * w1 / 2.0 + i2 * w2 * w2 / 2.0]);
    close(&[e.potential(&Q, &K)], &[K[0] * Q[1] * Q[1]]);
    close(&[e.dissipation(&Q, &V, &K)], &[constants().2 * V[1] * V[1]]);
    let works = [e.torque_work(0, &Q), e.torque_work(1, &Q)];
    close(&works, &[t0 * (Q[0] + Q[1]), -t0 * (Q[0] - Q[1])]);
    close(&[e.work(&Q)], &[2.0 * t0 * Q[1]]);
    close(&e.motion(0), &[n1, 0.0]);
}

#[test]
fn accelerations_match_hand_written_formulas() {
    let e = gear_pair(STIFFNESS_STEP | DAMPING | TORQUES);
    let (m1, m2, c) = constants();
    let ([_, phi], [_, phi_dot], t0) = (Q, V, NUMBERS[5]);
    let (smooth, jump) = (t0 - K[0] * phi - c * phi_dot, DK[0] * phi * phi / 2.0);
    let expected = [m1 * smooth - m2 * jump, m2 * smooth - m1 * jump];
    close(&e.acceleration(&Q, &V, &K, &DK), &expected);
    close(&(&mobility(&e.mass(&Q)) * &e.force(&Q, &V, &K, &DK)), &expected);
}

/// The jacobian against central differences. The accelerations are at most quadratic in q and q', so the differences along these
/// are exact to rounding. Along theta the laws change with the phase.
#[test]
fn the_jacobian_matches_central_differences() {
    let e = gear_pair(STIFFNESS_STEP | DAMPING | TORQUES);
    let [by_q, by_v] = accelerated(&e.mobility(&Q), e.jacobian(&Q, &V, &K, &DK, &DDK));
    let at = |theta: f64, phi: f64, phi_dot: f64| {
        let (k, dk) = (K[0] + theta * DK[0] + theta * theta / 2.0 * DDK[0], DK[0] + theta * DDK[0]);
        e.acceleration(&[Q[0], Q[1] + phi], &[V[0], V[1] + phi_dot], &values([k]), &values([dk]))
    };
    let slope = |[a, b]: [Vector; 2], h: f64| [(a[0] - b[0]) / (2.0 * h), (a[1] - b[1]) / (2.0 * h)];
    let near = |found: [f64; 2], expected: [f64; 2]| {
        for (x, y) in found.iter().zip(expected) {
            assert!((x - y).abs() < 1e-6 * y.abs(), "{found:?} is not {expected:?}");
        }
    };
    let h = 1e-4;
    near([by_q[(0, 0)], by_q[(1, 0)]], slope([at(h, 0.0, 0.0), at(-h, 0.0, 0.0)], h));
    near([by_q[(0, 1)], by_q[(1, 1)]], slope([at(0.0, h, 0.0), at(0.0, -h, 0.0)], h));
    near([by_v[(0, 1)], by_v[(1, 1)]], slope([at(0.0, 0.0, h), at(0.0, 0.0, -h)], h));
    assert_eq!([by_v[(0, 0)], by_v[(1, 0)]], [0.0, 0.0]);
}

/// Larger models have no symbolic inverse of M. The derivatives of the forces are then multiplied by M⁻¹.
#[test]
fn jacobian_of_a_larger_model() {
    let model = Idler::MODEL;
    let effects = ["stiffness_step", "transmission_error", "damping", "torques", "sliding_friction"];
    let effects = Effects::from_names(effects, &model).unwrap();
    let parameters: Vec<f64> = (0..model.parameters.len()).map(|i| 1.3 + 0.7 * i as f64).collect();
    let e = Idler::equations(&effects, &parameters, &[2.0, 3.0]).unwrap();
    let (q, v) = ([0.3, 0.2, -0.4], [1.1, -0.6, 0.8]);
    // Laws of the phase q[0], cubic about its present value.
    let courses = [
        [2.1, 0.7, -0.9],
        [3.3, -0.4, 0.5],
        [0.05, 0.3, -0.2],
        [-0.07, 0.2, 0.6],
        [-0.4, 0.3, 0.8],
        [0.9, -0.2, 0.4],
        [0.6, 0.5, -0.7],
        [1.2, 0.1, 0.3],
    ];
    let law = |order: usize, s: f64| courses.map(|c| [c[0] + c[1] * s + c[2] * s * s / 2.0, c[1] + c[2] * s][order]);
    let at = |q: [f64; 3], v: [f64; 3]| {
        let s = q[0] - 0.3;
        e.acceleration(&q, &v, &model.in_contact(law(0, s)), &law(1, s))
    };
    let found = e.jacobian(&q, &v, &model.in_contact(law(0, 0.0)), &law(1, 0.0), &courses.map(|c| c[2]));
    let found = accelerated(&e.mobility(&q), found);
    let h = 1e-5;
    for j in 0..3 {
        let moved = |x: [f64; 3], by: f64| std::array::from_fn(|i| if i == j { x[i] + by } else { x[i] });
        let by_q = (at(moved(q, h), v) - &at(moved(q, -h), v)) * (0.5 / h);
        let by_v = (at(q, moved(v, h)) - &at(q, moved(v, -h))) * (0.5 / h);
        for (found, expected) in found.iter().zip([by_q, by_v]) {
            let largest = expected.amax().max(1e-3);
            for i in 0..3 {
                assert!((found[(i, j)] - expected[i]).abs() < 1e-8 * largest, "{i} {j}: {found:?} is not {expected:?}");
            }
        }
    }
}

/// A transmission error shifts the deflection: V = k (phi - e)². Its force and its step against hand-written formulas. Without
/// the effect it changes nothing.
#[test]
fn transmission_error() {
    let (k, e, de) = (K[0], 1.7e-4, 0.02);
    let (over, k_and_e) = (Q[1] - e, values([k, e]));
    let with = gear_pair(STIFFNESS_STEP | TRANSMISSION_ERROR);
    let (m1, m2, _) = constants();
    close(&[with.potential(&Q, &k_and_e)], &[k * over * over]);
    close(&with.load(&k_and_e), &[0.0, 2.0 * k * e]);
    let (spring, jump) = (2.0 * k * over, -DK[0] * over * over + 2.0 * k * over * de);
    let expected = [m2 / 2.0 * jump - m1 / 2.0 * spring, m1 / 2.0 * jump - m2 / 2.0 * spring];
    close(&with.acceleration(&Q, &V, &k_and_e, &values([DK[0], de])), &expected);
    let step = 3e-4;
    close(&[with.step(1, &Q, &k_and_e, step)], &[k * ((over - step).powi(2) - over * over)]);
    close(&[with.step(0, &Q, &k_and_e, 1e3)], &[1e3 * over * over]);
    let without = gear_pair(STIFFNESS_STEP);
    close(&[without.potential(&Q, &k_and_e)], &[k * Q[1] * Q[1]]);
    close(&without.load(&k_and_e), &[0.0, 0.0]);
    assert_eq!([with.switching(1), without.switching(1)], [Switching::WithJump, Switching::Never]);
}

#[test]
fn the_cell_and_the_jump_match_hand_written_formulas() {
    let e = gear_pair(STIFFNESS_STEP | DAMPING | TORQUES);
    let [n1, n2, i1, i2, _, t0, ..] = NUMBERS;
    let (m1, m2, c) = constants();
    let (a, b) = (i1 / n1.powi(2), i2 / n2.powi(2));
    close(e.mass(&Q).as_slice(), &[a + b, a - b, a - b, a + b]);
    close(e.mobility(&Q).as_slice(), &[m2 / 2.0, m1 / 2.0, m1 / 2.0, m2 / 2.0]);
    close(mobility(&e.mass(&Q)).as_slice(), e.mobility(&Q).as_slice());
    close(e.damping(&K).as_slice(), &[0.0, 0.0, 0.0, 2.0 * c]);
    close(e.stiffness(&K).as_slice(), &[0.0, 0.0, 0.0, 2.0 * K[0]]);
    close(&e.load(&K), &[0.0, 2.0 * t0]);
    assert_eq!(e.normal(0), [1.0, 0.0]);
    close(&[e.compliance(0, &Q)], &[m2 / 2.0]);
    close(&e.direction(0, &Q), &[1.0, m1 / m2]);
    close(&[compliance(&e.mass(&Q), &e.normal(0))], &[e.compliance(0, &Q)]);
    close(&direction(&e.mass(&Q), &e.normal(0)), &e.direction(0, &Q));
    close(&[e.step(0, &Q, &K, 400.0)], &[400.0 * Q[1] * Q[1]]);
}

/// Terms of an absent effect are not evaluated: NaN and infinity in the quantities that they would use do not change the result.
#[test]
fn terms_of_absent_effects_are_not_evaluated() {
    let mut numbers = NUMBERS;
    (numbers[4], numbers[5]) = (f64::NAN, f64::NAN);
    for effects in [0, STIFFNESS_STEP | RIGID_KINEMATICS, STIFFNESS_STEP | FROZEN_PHASE] {
        let e = GearPair::equations(&set::<GearPair>(effects), &numbers, &[f64::NAN]).unwrap();
        let (m1, m2, _) = constants();
        let a = e.acceleration(&Q, &V, &K, &values([f64::INFINITY]));
        close(&a, &[-m1 * K[0] * Q[1], -m2 * K[0] * Q[1]]);
        close(&e.force(&Q, &V, &K, &values([])), &[0.0, -2.0 * K[0] * Q[1]]);
        assert_eq!([e.dissipation(&Q, &V, &K), e.work(&Q), e.torque_work(0, &Q)], [0.0; 3]);
        // Rigid kinematics keeps the moving phase: its forces change with theta by the slope of k.
        let slope = if effects & RIGID_KINEMATICS > 0 { 0.0 } else { f64::NAN };
        let [by_q, by_v] = accelerated(&e.mobility(&Q), e.jacobian(&Q, &V, &K, &values([slope]), &values([])));
        close(by_q.transpose().as_slice(), &[0.0, -m1 * K[0], 0.0, -m2 * K[0]]);
        assert_eq!(by_v.amax(), 0.0);
        assert_eq!([e.damping(&K).amax(), e.load(&K).amax()], [0.0; 2]);
    }
}

#[test]
fn inadmissible_sets_of_effects_are_refused() {
    let exists = |effects| GearPair::equations(&set::<GearPair>(effects), &NUMBERS, &[MID]).is_some();
    assert_eq!((0..256).filter(|&effects| exists(effects)).count(), 104);
    assert!(!exists(SLIDING_FRICTION) && exists(STIFFNESS_STEP | SLIDING_FRICTION | TRANSMISSION_ERROR));
    assert!(exists(STIFFNESS_STEP | SLIDING_FRICTION | RIGID_KINEMATICS));
    assert!(!exists(RIGID_KINEMATICS) && !exists(FROZEN_PHASE | DAMPING));
    assert!(!exists(STIFFNESS_STEP | RIGID_KINEMATICS | FROZEN_PHASE));
    let switching = |effects| gear_pair(effects).switching(0);
    assert_eq!(switching(DAMPING), Switching::Never);
    assert_eq!(switching(STIFFNESS_STEP), Switching::WithJump);
    assert_eq!(switching(STIFFNESS_STEP | RIGID_KINEMATICS), Switching::WithoutJump);
    assert_eq!(switching(STIFFNESS_STEP | FROZEN_PHASE), Switching::ByTime);
}

#[test]
#[should_panic(expected = "no torque number 100")]
fn a_torque_index_out_of_range_panics() {
    gear_pair(0).torque_work(100, &Q);
}

#[test]
fn the_model_describes_the_gear_pair() {
    let m = GearPair::MODEL;
    assert_eq!((m.name, m.title), ("gear_pair", "two spur gears on rigid shafts"));
    assert_eq!([m.coordinates[0].name, m.coordinates[1].name], ["theta", "phi"]);
    assert_eq!((m.coordinates[0].start, m.coordinates[1].start), (Start::At(0.0), Start::Static));
    let names: Vec<_> = m.parameters.iter().map(|p| p.name).collect();
    assert_eq!(names[..11], ["N1", "N2", "I1", "I2", "zeta", "T0", "b", "alpha", "mu", "w_mix", "mu_rise"]);
    assert_eq!(names.len(), NUMBERS.len(), "parameters of drives and loads follow");
    assert_eq!((m.parameters[0].default, m.parameters[2].default), (Some(24.0), None));
    let ranges = [m.parameters[0], m.parameters[4], m.parameters[5]].map(|p| p.range.to_string());
    assert_eq!(ranges, ["(0, inf)", "[0, inf)", "(-inf, inf)"]);
    assert_eq!((m.laws[0].name, m.laws[0].phase, m.laws[0].period), ("k", "theta", std::f64::consts::TAU));
    assert_eq!((m.motions[0].name, m.motions[0].unit), ("speed", "rad/s"));
    assert_eq!((m.effects[2].name, m.effects[2].requires), ("frozen_phase", &["stiffness_step"][..]));
    assert_eq!(m.effects[2].excludes, ["rigid_kinematics"]);
    assert_eq!((m.torques[0].name, m.torques[1].name), ("drive", "load"));
    // If only some terms of a torque need a second effect, the torque itself does not need it.
    let with: Vec<_> = m.torques[..5].iter().map(|torque| torque.with).collect();
    let [torques, friction, governor] = ["torques", "sliding_friction", "governor_motor"].map(|effect| vec![effect]);
    assert_eq!(with, [&torques, &torques, &friction, &friction, &governor]);
    assert!(m.equations.contains("theta'' = ") && m.latex.contains(r"\ddot{\theta} = "));
}

/// The smallest valid file: no closed forms, no effects, and a law that never steps.
mod two_masses {
    gearsim::equations! {
        model two_masses "Two coupled masses joined by a spring of 1 N/m, the second one held to the ground";
        coordinates {
            x "m" start -1.0, "first mass";
            y "m" start 0.0, "second mass";
        }
        parameters { m "kg" required, open 0.0 to included 5.0, "each mass"; }
        laws { s "N/m" phase y period 1.0, "ground spring"; }
        energies { potential { _ => s*y.powi(2)/2.0; _ => (x - y).powi(2)/2.0; } }
        mass { x x { _ => m; } x y { _ => m/2.0; } y y { _ => m; } }
        force { x { _ => y - x; } y { _ => x - y; _ => -s*y; } }
        jacobian {}
    }
}

#[test]
fn the_smallest_valid_file() {
    let e = two_masses::TwoMasses::equations(&Effects::none(&two_masses::TwoMasses::MODEL), &[3.0], &[7.0]).unwrap();
    assert_eq!(
        (e.kinetic(&Q, &[1.0, 1.0]), e.dissipation(&Q, &[1.0, 1.0], &[7.0]), e.work(&[1.0, 1.0])),
        (0.0, 0.0, 0.0)
    );
    assert_eq!(e.potential(&[2.0, 1.0], &[7.0]), 4.0);
    assert_eq!(e.force(&[2.0, 1.0], &[0.0; 2], &[7.0], &[0.0]), [-1.0, -6.0]);
    // M⁻¹ = [[4, -2], [-2, 4]]/9 for M = [[3, 1.5], [1.5, 3]].
    close(&e.acceleration(&[2.0, 1.0], &[0.0; 2], &[7.0], &[0.0]), &[8.0 / 9.0, -22.0 / 9.0]);
    close(e.mobility(&Q).as_slice(), &[4.0 / 9.0, -2.0 / 9.0, -2.0 / 9.0, 4.0 / 9.0]);
    assert_eq!((e.switching(0), e.normal(0)), (Switching::Never, [0.0, 1.0].into()));
    close(&[e.compliance(0, &Q)], &[4.0 / 9.0]);
    close(&e.direction(0, &Q), &[-0.5, 1.0]);
    let range = two_masses::TwoMasses::MODEL.parameters[0].range;
    assert_eq!(range, Range { low: 0.0, high: 5.0, low_included: false, high_included: true });
}

/// M = D [[4, 1, 1], [1, 4, 1], [1, 1, 4]] D against its hand-written inverse, with entries of D over 200 decades.
#[test]
fn inverse_of_a_badly_scaled_mass_matrix() {
    let d = [1e100, 1.0, 1e-100];
    let scaled = |diagonal: f64, other: f64, d: [f64; 3]| {
        Matrix::from_fn(3, 3, |i, j| if i == j { diagonal * d[i] * d[i] } else { other * d[i] * d[j] })
    };
    let w = mobility(&scaled(4.0, 1.0, d));
    close(w.as_slice(), scaled(5.0 / 18.0, -1.0 / 18.0, d.map(f64::recip)).as_slice());
    assert!((0..3).all(|i| (0..3).all(|j| w[(i, j)] == w[(j, i)])), "{w:?} is not symmetric");
}

#[test]
fn an_indefinite_matrix_has_no_inverse() {
    assert!(mobility(&Matrix::from_row_slice(2, 2, &[-1.0, 0.0, 0.0, 1.0])).iter().all(|x| x.is_nan()));
}
