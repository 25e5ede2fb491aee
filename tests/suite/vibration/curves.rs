//! Stability with stiffnesses that follow curves. A wave is compared with Mathieu's equation. Ramps are compared with a Runge-Kutta method. In
//! a train with two stages one stiffness steps and the other is a wave.

use std::f64::consts::TAU;

use gearsim::__private::{Inside, linear};
use gearsim::analysis::floquet::Floquet;
use gearsim::scene::Scene;
use nalgebra::DMatrix;

use crate::common;

fn floquet(scene: &Scene) -> Floquet {
    let system = common::model(scene.model.name).system(scene).expect("a linear model");
    linear::floquet(scene, &system).expect("a system with multipliers")
}

/// The sum of the multipliers of the undamped gear pair with a stiffness law, where the mesh frequency is `ratio` times the natural frequency
/// at the mean stiffness; and that natural frequency [rad/s].
fn trace(law: &str, ratio: f64) -> (f64, f64) {
    let of = |speed: f64| {
        let set =
            ["parameters.zeta=0".into(), format!("laws.k={law}"), format!("start={{theta_dot=\"{speed:?} rad/s\"}}")];
        floquet(&common::scene("oh2005/energy_300rpm", &set))
    };
    let natural = of(1000.0).natural * TAU;
    (of(ratio * natural).multipliers.iter().map(|z| z.re).sum(), natural)
}

/// y'' + (a - 2 q cos 2 tau) y = 0 has a solution of the period pi where a = a_2(q) or b_2(q), and one of the period 2 pi where a = a_1(q)
/// or b_1(q): the trace is 2 or -2 there. Values of SciPy's `mathieu_a`, `mathieu_b`; for q = 1 those of M. Abramowitz & I. Stegun, Handbook
/// of Mathematical Functions, 1964, Sec. 20.
#[test]
fn a_wave_is_stable_where_mathieus_equation_is() {
    for (a, q, expected) in [
        (4.371300982735086, 1.0, 2.0),
        (3.917024772998471, 1.0, 2.0),
        (1.2883236383268328, 0.3, -2.0),
        (0.6891659356138624, 0.3, -2.0),
    ] {
        // 2 tau is the mesh phase: a = 4 (omega/Omega)², and 2 q/a is the amplitude over the mean.
        let law =
            format!("{{ mean = \"2 kN*m\", harmonics = [{{ order = 1, amplitude = \"{:?} kN*m\" }}] }}", 4.0 * q / a);
        let (trace, _) = trace(&law, 2.0 / f64::sqrt(a));
        assert!((trace - expected).abs() < 1e-9, "a = {a}, q = {q}: the trace is {trace}");
    }
}

/// The monodromy matrix of y'' + k(t) y = 0 over one period, by classical Runge-Kutta steps between the kinks `ends` of k.
fn by_runge_kutta(k: impl Fn(f64) -> f64, ends: &[f64]) -> DMatrix<f64> {
    const STEPS: u32 = 2000;
    let mut p = DMatrix::identity(2, 2);
    for pair in ends.windows(2) {
        let h = (pair[1] - pair[0]) / f64::from(STEPS);
        // k is continuous at a kink, so that the pieces on both sides have the same value there.
        let rate = |t: f64, p: &DMatrix<f64>| DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -k(t), 0.0]) * p;
        for step in 0..STEPS {
            let t = pair[0] + f64::from(step) * h;
            let a = rate(t, &p);
            let b = rate(t + 0.5 * h, &(&p + &a * (0.5 * h)));
            let c = rate(t + 0.5 * h, &(&p + &b * (0.5 * h)));
            let d = rate(t + h, &(&p + &c * h));
            p += (a + (b + c) * 2.0 + d) * (h / 6.0);
        }
    }
    p
}

/// Two levels with ramps of a tenth of the pitch about the steps.
#[test]
fn ramps_have_the_multipliers_of_a_runge_kutta_method() {
    let (low, high, width, ramp) = (1.43, 2.78, 0.3, 0.1);
    let law = format!(
        "{{ steps = [{{ value = \"{low} kN*m\", width = \"{:?} rad\" }}, {{ value = \"{high} kN*m\" }}], ramp = \"{:?} rad\" }}",
        width * TAU,
        ramp * TAU
    );
    let mean = low * width + high * (1.0 - width);
    // Phase in pitches, from the middle of the low level on.
    let level = |x: f64| {
        let from_middle = (x - (x + 0.5).floor()).abs();
        low + (high - low) * ((from_middle - 0.5 * (width - ramp)) / ramp).clamp(0.0, 1.0)
    };
    let kinks = [0.0, 0.1, 0.2, 0.8, 0.9, 1.0];
    for ratio in [0.6, 1.02, 1.4, 1.95] {
        let (found, natural) = trace(&law, ratio);
        let period = TAU / (ratio * natural);
        let k = |t: f64| natural * natural * level(t / period) / mean;
        let expected = by_runge_kutta(k, &kinks.map(|x| x * period)).trace();
        assert!((found - expected).abs() < 1e-9, "ratio {ratio}: {found}, not {expected}");
    }
}

/// A wave beside a law that steps. The reference is a product of propagators with the stiffness in the middle of short steps, extrapolated.
#[test]
fn a_wave_beside_steps_is_not_replaced_by_its_mean() {
    let wave = "laws.k34={mean=\"520 MN/m\",harmonics=[{order=1,amplitude=\"250 MN/m\"}]}";
    let scene = common::scene("two_stage", &[wave.into(), "start.speed=33200 rpm".into()]);
    let found = floquet(&scene);
    let system = common::model("two_stage").system(&scene).expect("a linear model");
    let stiffnesses = linear::stiffnesses(&scene, &system).expect("a start");
    let expected = |steps: u32| {
        let h = found.period / f64::from(steps);
        let mut p = DMatrix::identity(2 * scene.model.coordinates.len(), 2 * scene.model.coordinates.len());
        for step in 0..steps {
            let levels = stiffnesses((f64::from(step) + 0.5) * h);
            p = system.propagator(&levels, h).expect("modes") * p;
        }
        p.complex_eigenvalues().iter().map(|z| z.norm()).fold(0.0, f64::max)
    };
    let (coarse, fine) = (expected(4000), expected(8000));
    let expected = fine + (fine - coarse) / 3.0;
    let largest = found.multipliers[0].norm();
    assert!(largest > 10.0 && (largest / expected - 1.0).abs() < 1e-5, "{largest}, not {expected}");
}
