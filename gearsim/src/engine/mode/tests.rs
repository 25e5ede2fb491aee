//! One mode against the same formulas in 50 digits, for all kinds of damping and all times.

use gearsim_tests::precise::cell::{Law, Motion};
use gearsim_tests::precise::number::{Real, Scalar};

use super::*;
use nalgebra::Complex;

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

/// The responses to a ramp and to a swing by their power series in 150 digits: S3; the real and imaginary parts of the displacement and of
/// the speed under e^{i W t} - 1.
fn driven_by_series(sigma: f64, omega2: f64, w: f64, t: f64) -> [f64; 5] {
    type Many = Real<512>;
    let (t, w) = (Many::exact(t), Many::exact(w));
    let (a, b) = (Many::exact(2.0 * sigma) * t.clone(), Many::exact(omega2) * t.clone() * t.clone());
    // The terms of the load: tⁿ (i W)ⁿ/n!; a ramp has only the second. The unit of the last pair of terms is t².
    let series = |ramp: bool, imaginary: bool| {
        let zero = Many::exact(0.0);
        let (mut before, mut term, mut load) = (zero.clone(), zero.clone(), Many::exact(1.0));
        let (mut sum, mut rate) = (zero.clone(), zero.clone());
        for n in 0..420u32 {
            let sign = if n % 4 >= 2 { -1.0 } else { 1.0 };
            let acts = n > 0 && if ramp { n == 1 } else { (n % 2 == 1) == imaginary };
            let own = if ramp { t.clone() } else { load.clone() * Many::exact(sign) };
            let push = if acts { own * t.clone() * t.clone() } else { zero.clone() };
            let drag = term.clone() * a.clone() * Many::exact(f64::from(n + 1));
            let next = (push - drag - before.clone() * b.clone()).over((n + 2) * (n + 1));
            (before, term) = (term, next);
            load = (load * w.clone() * t.clone()).over(n + 1);
            sum = sum + term.clone();
            rate = rate + term.clone() * Many::exact(f64::from(n + 2));
        }
        [sum.approx(), (rate / t.clone()).approx()]
    };
    let [s3, _] = series(true, false);
    let ([re, re_rate], [im, im_rate]) = (series(false, false), series(false, true));
    [s3, re, im, re_rate, im_rate]
}

/// Ramps and swings at every damping: slow and fast, on resonance and at any distance from it, for short and for long times.
#[test]
fn driven_responses_match_their_series() {
    let mut worst = [0.0f64; 3];
    let mut place = [const { String::new() }; 3];
    let near_critical = powers(-12, -1).step_by(3).flat_map(|d| [1.0 - d, 1.0 + d]);
    let ratios = [0.0, 1e-9, 1e-3, 0.05, 0.5, 0.9, 0.99, 1.0, 1.01, 1.2, 5.0, 1e3].into_iter().chain(near_critical);
    let modes = ratios.map(|zeta| (zeta * 3.0, 9.0));
    for (sigma, omega2) in modes.chain([(0.0, 0.0), (1.5, 0.0), (1.5, 1e-12)]) {
        let mode = Mode::new(sigma, omega2);
        let near = powers(-16, -1).step_by(3).flat_map(|d| [1.0 - d, 1.0 + d]);
        for w in powers(-8, 1).step_by(2).chain(near).map(|part| part * mode.damped_frequency().max(1.0)) {
            for t in powers(-6, 0).flat_map(|t| [t, 2.7 * t, 7.1 * t]) {
                if mode.rate.max(w) * t > 40.0 {
                    continue;
                }
                let at = mode.response(t);
                let [moved, rate] = mode.swing(w, t, exp_m1(Complex::new(0.0, w * t)), &at);
                let got = [mode.ramp(t, &at), moved.re, moved.im, rate.re, rate.im];
                let want = driven_by_series(sigma, omega2, w, t);
                let roundings = (1.0 + (mode.damped_frequency() + w) * t) * f64::EPSILON;
                let effect = mode.effect(t);
                let sizes = [want[0].abs(), effect, effect, t.min(w * effect), t.min(w * effect)];
                for k in 0..5 {
                    let error = (got[k] - want[k]).abs() / (roundings * sizes[k]);
                    let kind = [0, 1, 1, 2, 2][k];
                    if error.is_nan() || error > worst[kind] {
                        worst[kind] = error;
                        place[kind] =
                            format!("sigma {sigma:e}, omega² {omega2:e}, W {w:e}, t {t:e}: {got:?}, not {want:?}");
                    }
                }
            }
        }
    }
    println!("largest errors: {worst:.1?} roundings\n{}", place.join("\n"));
    assert!(worst.iter().all(|worst| *worst < 60.0), "{worst:?} roundings\n{}", place.join("\n"));
}
