//! Smooth transmission errors: a Fourier series of the mesh phase, solved by numerical methods.

use std::f64::consts::{PI, TAU};

use crate::{common, mobilities, run, unaccounted};

/// Constant stiffness, as a law with one level [N m].
const K: f64 = 2780.0;
const CONSTANT: &str = r#"laws.k.steps=[{value="2780 N*m"}]"#;
/// Amplitude of e [rad]; e has the phase 0.4 rad.
const A: f64 = 1e-4;
const WAVE: &str = r#"laws.e={harmonics=[{order=1, amplitude="1e-4 rad", phase="0.4 rad"}]}"#;
const ZETA: f64 = 0.1;

/// The steady oscillation of phi that e(Omega t) excites has the closed form of the linear oscillator
/// phi'' + 2 zeta w phi' + w² (phi - e) = M2 T0. A run that starts in the steady state stays in it, at resonance and off resonance.
#[test]
fn a_harmonic_error_drives_a_linear_oscillator() {
    let w = (mobilities().1 * K).sqrt();
    for ratio in [0.3, 1.0, 1.7] {
        let omega = ratio * w;
        // phi = T0/k + Re(H A e^(i (Omega t + 0.4))), H = w²/(w² - Omega² + 2 i zeta w Omega).
        let (x, y) = (1.0 - ratio * ratio, 2.0 * ZETA * ratio);
        let (size, lag) = (A / x.hypot(y), y.atan2(x));
        let phi = |t: f64| 10.0 / K + size * (omega * t + 0.4 - lag).cos();
        let speed = -size * omega * (0.4 - lag).sin();
        let outcome = run(&[
            CONSTANT,
            WAVE,
            r#"effects=["stiffness_step", "frozen_phase", "transmission_error", "damping", "torques"]"#,
            &format!(
                "start={{theta_dot=\"{omega:?} rad/s\", phi=\"{:?} rad\", phi_dot=\"{speed:?} rad/s\"}}",
                phi(0.0)
            ),
            "run={t_end=\"10 ms\", tolerance=1e-12}",
            "output={rate=\"100 kHz\"}",
        ]);
        let t = &outcome.trajectory;
        let worst = (0..t.len()).map(|i| (t.q[1][i] - phi(t.t[i])).abs()).fold(0.0, f64::max);
        println!("Omega/w = {ratio}: {:.1e} of the amplitude {:.3} A", worst / size, size / A);
        assert!(worst < 1e-8 * size, "Omega/w = {ratio}: {worst:e} of {size:e}");
    }
}

/// In slow rotation phi = e + T0/k, except for 2 zeta Omega/w of the amplitude, which the damper causes.
#[test]
fn slow_rotation_is_quasi_static() {
    let w = (mobilities().1 * K).sqrt();
    let off = |omega: f64| {
        let outcome = run(&[
            CONSTANT,
            WAVE,
            r#"effects=["stiffness_step", "transmission_error", "damping", "torques"]"#,
            "parameters.T0=\"0.1 N*m\"",
            &format!("start={{theta_dot=\"{omega:?} rad/s\"}}"),
            &format!("run={{t_end=\"{:?} s\", tolerance=1e-11}}", 1.5 * TAU / omega),
        ]);
        assert!(unaccounted(&outcome) < 1e-10, "{:e}", unaccounted(&outcome));
        let t = &outcome.trajectory;
        // The transient of the start dies away within half a period of e.
        let late = (0..t.len()).filter(|&i| t.t[i] > 0.5 * TAU / omega);
        late.map(|i| (t.q[1][i] - 0.1 / K - A * (t.q[0][i] + 0.4).cos()).abs() / A).fold(0.0, f64::max)
    };
    for omega in [400.0, 200.0, 100.0] {
        let (found, expected) = (off(omega), 2.0 * ZETA * omega / w);
        println!("Omega = {omega}: off by {found:.3e} of e, 2 zeta Omega/w = {expected:.3e}");
        assert!((found / expected - 1.0).abs() < 0.05, "{omega}: {found} for {expected}");
    }
}

/// The end state of M q'' = F from V = k(theta) (phi - e(theta))² by hand; k and e are harmonic, the period of e is 2/3 of a
/// pitch. Integrated by the classical Runge-Kutta method, whose error is below 1e-10 here.
fn by_hand(t_end: f64) -> [f64; 4] {
    let (m1, m2) = mobilities();
    let k = |s: f64| [2100.0 + 600.0 * s.cos(), -600.0 * s.sin()];
    let e = |s: f64| [2e-3 * (1.5 * s).cos(), -3e-3 * (1.5 * s).sin()];
    let rate = |[theta, phi, theta_dot, phi_dot]: [f64; 4]| {
        let ([k, dk], [e, de]) = (k(theta), e(theta));
        let x = phi - e;
        let [on_theta, on_phi] = [-dk * x * x + 2.0 * k * x * de, -2.0 * k * x + 20.0];
        [theta_dot, phi_dot, (m2 * on_theta + m1 * on_phi) / 2.0, (m1 * on_theta + m2 * on_phi) / 2.0]
    };
    let (n, plus) = (40_000, |y: [f64; 4], h: f64, f: [f64; 4]| std::array::from_fn(|i| y[i] + h * f[i]));
    let h = t_end / f64::from(n);
    let mut y = [0.0, 5e-3, 600.0 * PI / 30.0 * 24.0, 0.0];
    for _ in 0..n {
        let a = rate(y);
        let b = rate(plus(y, h / 2.0, a));
        let c = rate(plus(y, h / 2.0, b));
        let d = rate(plus(y, h, c));
        y = std::array::from_fn(|i| y[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
    }
    y
}

#[test]
fn harmonic_stiffness_and_error_give_the_motion_by_hand() {
    let expected = by_hand(0.02);
    for method in ["dop853", "radau"] {
        let outcome = run(&[
            r#"laws.k={mean="2.1 kN*m", harmonics=[{order=1, amplitude="0.6 kN*m"}]}"#,
            r#"laws.e={pitches=2, harmonics=[{order=3, amplitude="2e-3 rad"}]}"#,
            "start={speed=\"600 rpm\", phi=\"5e-3 rad\"}",
            &format!("run={{t_end=\"20 ms\", method={method:?}, tolerance=1e-12}}"),
        ]);
        let t = &outcome.trajectory;
        let last = t.len() - 1;
        let found = [t.q[0][last], t.q[1][last], t.q_dot[0][last], t.q_dot[1][last]];
        for ((found, expected), size) in found.iter().zip(expected).zip([1.0, 1e-2, 100.0, 100.0]) {
            assert!((found - expected).abs() < 1e-7 * size, "{method}: {found} for {expected}");
        }
        assert!(unaccounted(&outcome) < 1e-9, "{method}: {:e}", unaccounted(&outcome));
    }
}

/// Ramps instead of steps of the error: as their width falls, the motion converges to that of the jump rule in first order.
#[test]
fn ramps_of_the_error_converge_to_the_jump_rule() {
    let set = [
        "start={theta=\"5 rad\", phi=\"5e-3 rad\", speed=\"100 rpm\"}",
        "run.t_end=\"8 ms\"",
        "output={events=false, rate=\"1 Hz\"}",
    ];
    let of = |ramp: &str| {
        let law = format!(r#"laws.e={{pitch_errors=["0 rad", "1e-3 rad"]{ramp}}}"#);
        let tolerance = if ramp.is_empty() { "run.precision=\"plain\"" } else { "run.tolerance=1e-13" };
        let outcome = run(&[&set[..], &[CONSTANT, &law, tolerance]].concat());
        let t = &outcome.trajectory;
        let last = t.len() - 1;
        [t.q[0][last], 1e2 * t.q[1][last], 1e-2 * t.q_dot[0][last], 1e-2 * t.q_dot[1][last]]
    };
    let steps = of("");
    let apart = |octave: i32| {
        let ramped = of(&format!(", ramp=\"{:?} rad\"", 1e-4 / f64::from(1 << octave)));
        ramped.iter().zip(steps).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()))
    };
    let (wide, narrow) = (apart(0), apart(4));
    let slope = (wide / narrow).log2() / 4.0;
    println!("{wide:.2e} to {narrow:.2e}, slope {slope:.3}");
    assert!((slope - 1.0).abs() < 0.05, "{wide} {narrow}: slope {slope}");
}

/// The run-up of the scene `transmission_error`: the amplitude of the mesh is largest where the frequency of the error equals the lower
/// natural frequency of pinion and bearing, K = [[kb + k, k], [k, k]], M = diag(m, I/r²). The wheel counts as fixed.
#[test]
fn a_run_up_passes_its_resonance() {
    let (k, kb, m, i) = (120e6, 100e6, 1.0, 2890e-6 / 71.6e-3f64.powi(2));
    let (trace, det) = ((kb + k) / m + k / i, kb * k / (m * i));
    let expected = ((trace - (trace * trace - 4.0 * det).sqrt()) / 2.0f64).sqrt() / TAU;
    let outcome = common::run(&common::scene("transmission_error", &[]));
    let t = &outcome.trajectory;
    let windows = t.t.len() / 200;
    let swing = |w: usize| {
        let rows = &t.q[1][200 * w..200 * (w + 1)];
        let mean = rows.iter().sum::<f64>() / 200.0;
        (rows.iter().map(|s| (s - mean).powi(2)).sum::<f64>() / 200.0).sqrt()
    };
    let speed = |w: usize| t.q_dot[0][200 * w..200 * (w + 1)].iter().sum::<f64>() / 200.0;
    // Speeds above the resonance with twice the mesh frequency.
    let late = (0..windows).filter(|w| speed(*w) / TAU > 0.7 * expected);
    let most = late.max_by(|a, b| swing(*a).total_cmp(&swing(*b))).expect("a run-up to these speeds");
    let (found, last) = (speed(most) / TAU, windows - 1);
    println!(
        "swings most at {found:.0} Hz, {expected:.0} Hz by hand; {:.1e} m, {:.1e} m at the end",
        swing(most),
        swing(last)
    );
    // In a run-up the amplitude peaks after the resonance, by a part of the width of the resonance.
    assert!((found / expected - 1.0).abs() < 0.06, "{found} for {expected}");
    assert!(swing(most) > 4.0 * swing(last) && speed(last) / TAU > 1.5 * expected);
}
