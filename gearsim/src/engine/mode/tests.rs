//! One mode against the same formulas in 50 digits, for all kinds of damping and all times.

use gearsim_tests::precise::cell::{Law, Motion};
use gearsim_tests::precise::number::{Real, Scalar};

use super::*;
use crate::tolerance::modes::SHIFT_SPAN;

type Digits = Real<192>;

fn exact(x: f64) -> Digits {
    Digits::exact(x)
}

/// S1, S2 in 50 digits.
fn precise(sigma: f64, omega2: f64, t: f64) -> (Digits, Digits) {
    let motion = |force, v| {
        let law = Law::new(exact(sigma), exact(omega2));
        Motion::new(law, exact(force), exact(0.0), exact(v), exact(1.0)).state(&exact(t)).0
    };
    (motion(0.0, 1.0), motion(1.0, 0.0))
}

fn powers(from: i32, to: i32) -> impl Iterator<Item = f64> + Clone {
    (from..=to).map(|k| 10f64.powi(k))
}

/// Damping ratios: none, weak, strong, and on both sides of critical damping down to the rounding error.
fn damping_ratios() -> Vec<f64> {
    let near = powers(-15, -1).flat_map(|d| [1.0 - d, 1.0 + d]);
    [0.0, 1.0].into_iter().chain(powers(-12, 6)).chain(near).collect()
}

#[test]
fn responses_match_50_digits_at_every_damping() {
    // Conditioning: a rounding error of omega t changes the phase. A rounding error of omega - sigma changes the damped frequency w; near
    // critical damping it decides whether the motion oscillates. The bound is therefore a few roundings times (1 + w t).
    let mut worst = (0.0, String::new());
    for zeta in damping_ratios() {
        for tau in powers(-8, 2).flat_map(|t| [t, 2.7 * t]) {
            let (omega, t) = (3.0, tau / 3.0);
            let mode = Mode::new(zeta * omega, omega * omega);
            let (r, (s1, s2)) = (mode.response(t), precise(zeta * omega, omega * omega, t));
            let scale = (1.0 + mode.damped_frequency() * t) * f64::EPSILON;
            // S1 oscillates about 0 and decays: its error is compared with its largest value so far.
            let largest = t.min(mode.gain);
            for (what, got, want, size) in [("S1", r.s1, s1.approx(), largest), ("S2", r.s2, s2.approx(), s2.approx())]
            {
                let error = (got - want).abs() / (scale * size);
                if error > worst.0 {
                    worst = (error, format!("{what} zeta {zeta:e} omega t {tau:e}: {got:e}, not {want:e}"));
                }
            }
        }
    }
    println!("largest error: {:.1} roundings ({})", worst.0, worst.1);
    assert!(worst.0 < 40.0, "{} roundings: {}", worst.0, worst.1);
}

#[test]
fn responses_without_stiffness_are_exact() {
    let free = Mode::new(0.0, 0.0).response(3.0);
    assert_eq!((free.s1, free.s2), (3.0, 4.5));
    // Only a damper: S1 = (1 - e^{-2 sigma t})/(2 sigma).
    for t in powers(-6, 3) {
        let (r, (s1, s2)) = (Mode::new(0.7, 0.0).response(t), precise(0.7, 0.0, t));
        assert!((r.s1 / s1.approx() - 1.0).abs() < 4e-15, "S1 at {t}");
        assert!((r.s2 / s2.approx() - 1.0).abs() < 4e-15, "S2 at {t}");
    }
}

#[test]
fn a_shifted_response_equals_the_later_response() {
    for zeta in [0.0, 1e-6, 0.05, 0.9, 1.0, 1.0 + 1e-12, 1.2, 30.0] {
        let mode = Mode::new(zeta * 2.0, 4.0);
        for tau in [1e-3, 0.1, 1.0, 7.0] {
            let (t, dt) = (tau / mode.rate, SHIFT_SPAN / mode.rate);
            for dt in [dt, -0.7 * dt, 1e-3 * dt, 1e-9 * dt] {
                if t + dt < 0.0 {
                    continue;
                }
                let (before, later) = (mode.response(t), mode.response(t + dt));
                let shifted = mode.shifted(&before, dt);
                let (s1, s2) = (t.min(mode.gain), before.s2.max(later.s2));
                assert!((shifted.s1 - later.s1).abs() < 4e-15 * s1, "S1 zeta {zeta} t {t} dt {dt}");
                assert!((shifted.s2 - later.s2).abs() < 8e-15 * s2, "S2 zeta {zeta} t {t} dt {dt}");
                assert!((shifted.decay - later.decay).abs() < 1e-15, "decay zeta {zeta} t {t} dt {dt}");
            }
        }
    }
}

#[test]
fn the_dissipated_energy_equals_the_decrease_of_the_modes_energy() {
    for zeta in damping_ratios().into_iter().filter(|z| *z > 0.0) {
        let (omega2, v, a) = (4.0, 0.8, -1.3);
        let mode = Mode::new(zeta * 2.0, omega2);
        for t in powers(-4, 2) {
            let r = mode.response(t);
            // y: deviation from equilibrium, from a = -omega² y - 2 sigma v.
            let y = -(a + 2.0 * mode.sigma * v) / omega2;
            let force = -omega2 * y;
            let (moved, gained) = (v * r.s1 + force * r.s2, (force - 2.0 * mode.sigma * v) * r.s1 - omega2 * v * r.s2);
            let fall = -gained * (v + 0.5 * gained) - omega2 * moved * (y + 0.5 * moved);
            let dissipated = mode.dissipated(v, a, t, &r);
            let energy = 0.5 * (v * v + omega2 * y * y);
            assert!(
                (dissipated - fall).abs() < 2e-14 * energy,
                "zeta {zeta:e} t {t:e}: {dissipated:e}, not {fall:e} of {energy:e}"
            );
        }
    }
}

#[test]
fn bounds_hold_and_the_tight_bound_is_reached() {
    for zeta in [0.0, 1e-3, 0.3, 0.999, 1.0, 1.001, 40.0] {
        let mode = Mode::new(zeta * 5.0, 25.0);
        for (y, v) in [(1.0, 0.0), (0.0, 1.0), (1.0, 30.0), (-1.0, 30.0), (0.3, -4.0)] {
            let (tight, rough) = (mode.bound(y, v), mode.rough_bound(y, v));
            assert!(tight <= rough);
            let mut reached: f64 = 0.0;
            for i in 0..20_000 {
                let r = mode.response(i as f64 * 1e-4);
                reached = reached.max((y + v * r.s1 - 25.0 * y * r.s2).abs());
            }
            assert!(reached <= tight * (1.0 + 1e-14), "zeta {zeta} y {y} v {v}: {reached} > {tight}");
            assert!(zeta > 0.0 || reached > 0.999 * tight, "zeta {zeta} y {y} v {v}: {reached} < {tight}");
        }
    }
    assert_eq!(Mode::new(0.0, 0.0).bound(1.0, 1e-300), f64::INFINITY);
    assert_eq!(Mode::new(0.0, 0.0).bound(1.0, 0.0), 1.0);
}
