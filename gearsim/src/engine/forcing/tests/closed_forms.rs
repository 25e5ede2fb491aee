//! Motions under ramps and harmonics against closed forms.

use std::f64::consts::TAU;

use super::{residual, run};
use crate::run::Outcome;

/// Stiffness [N*m/rad].
const K: f64 = 2000.0;
/// M1 and M2 [1/(kg*m²)].
const M: [f64; 2] =
    [0.5 * (24.0 * 24.0 / 2.89e-3 - 96.0 * 96.0 / 0.7402), 0.5 * (24.0 * 24.0 / 2.89e-3 + 96.0 * 96.0 / 0.7402)];

/// Natural angular frequency of phi [rad/s].
fn omega() -> f64 {
    (M[1] * K).sqrt()
}

/// The largest difference of phi and phi' from their closed forms, each relative to its largest value.
fn worst(outcome: &Outcome, phi: impl Fn(f64) -> [f64; 2]) -> f64 {
    let t = &outcome.trajectory;
    let expected: Vec<[f64; 2]> = t.t.iter().map(|t| phi(*t)).collect();
    let off = |column: &[f64], which: usize| {
        let size = expected.iter().fold(0.0f64, |m, e| m.max(e[which].abs()));
        column.iter().zip(&expected).fold(0.0f64, |m, (x, e)| m.max((x - e[which]).abs() / size))
    };
    off(&t.q[1], 0).max(off(&t.q_dot[1], 1))
}

#[test]
fn ramps_have_closed_forms() {
    let (start, duration, to) = (2e-3, 7e-3, 12.0);
    let course = format!("parameters.T0={{ramp={{to=\"{to} N*m\", start=\"{start} s\", duration=\"{duration} s\"}}}}");
    let (w, slope) = (omega(), to / duration);
    // From rest: slope/K (t - sin(w t)/w). At the end of the ramp a second motion with the opposite slope begins.
    let from = |t: f64| match t > 0.0 {
        true => [slope / K * (t - (w * t).sin() / w), slope / K * (1.0 - (w * t).cos())],
        false => [0.0; 2],
    };
    let phi = |t: f64| {
        let (up, down) = (from(t - start), from(t - start - duration));
        [up[0] - down[0], up[1] - down[1]]
    };
    let outcome = run(&[&course]);
    assert_eq!(outcome.solver.method, "exact");
    assert!(worst(&outcome, phi) < 2e-13, "{:e}", worst(&outcome, phi));
    assert!(residual(&outcome) < 1e-13, "{:e}", residual(&outcome));
}

#[test]
fn rigid_motions_under_ramps_are_polynomials() {
    let course = "parameters.T0={ramp={from=\"-3 N*m\", to=\"5 N*m\", duration=\"0.02 s\"}}";
    let outcome = run(&[course, "laws.k.steps=[{value=0}]"]);
    let phi = |t: f64| [M[1] * (-1.5 * t * t + 400.0 / 6.0 * t.powi(3)), M[1] * (-3.0 * t + 200.0 * t * t)];
    assert!(worst(&outcome, phi) < 1e-14, "{:e}", worst(&outcome, phi));
    assert!(residual(&outcome) < 1e-14, "{:e}", residual(&outcome));
}

/// phi'' + 2 zeta w phi' + w² phi = M2 a cos(W t) from rest: off resonance, near it and on it, with and without damping.
#[test]
fn harmonics_have_closed_forms_also_on_resonance() {
    let (w, a) = (omega(), 7.0);
    for (part, zeta) in [(0.3, 0.0), (1.0, 0.0), (1.0 + 1e-9, 0.0), (7.3, 0.0), (1.0, 0.03), (0.8, 0.03), (1.4, 1.2)] {
        let drive = part * w;
        let course =
            format!("parameters.T0={{harmonics=[{{amplitude=\"{a} N*m\", frequency=\"{:?} Hz\"}}]}}", drive / TAU);
        let outcome = run(&[
            &course,
            &format!("parameters.zeta={zeta:?}"),
            if zeta > 0.0 { "effects=[\"torques\", \"damping\"]" } else { "effects=[\"torques\"]" },
        ]);
        let phi = |t: f64| {
            if zeta == 0.0 {
                // The divided difference of the cosines by the product formula, which has no cancellation on resonance.
                let (mean, half) = (0.5 * (drive + w), 0.5 * (drive - w));
                let sinc = if half == 0.0 { t } else { (half * t).sin() / half };
                let x = M[1] * a * sinc * (mean * t).sin() / (2.0 * mean);
                let cosine = (half * t).cos() * (mean * t).sin() + mean * sinc * (mean * t).cos();
                return [x, M[1] * a * cosine / (2.0 * mean)];
            }
            let (real, imaginary) = (w * w - drive * drive, 2.0 * zeta * w * drive);
            let size = M[1] * a / (real * real + imaginary * imaginary);
            // The steady motion is size (real cos + imaginary sin); the free motion makes the sum zero at the start.
            let (c, s) = (size * real, size * imaginary);
            let steady = [
                c * (drive * t).cos() + s * (drive * t).sin(),
                drive * (s * (drive * t).cos() - c * (drive * t).sin()),
            ];
            let (x, v) = (-c, -s * drive);
            let sigma = zeta * w;
            let mode = crate::engine::mode::Mode::new(sigma, w * w);
            let r = mode.response(t);
            let force = -w * w * x;
            let moved = x + v * r.s1 + force * r.s2;
            let speed = v + (force - 2.0 * sigma * v) * r.s1 - w * w * v * r.s2;
            [steady[0] + moved, steady[1] + speed]
        };
        assert!(worst(&outcome, phi) < 1e-12, "{part} {zeta}: {:e}", worst(&outcome, phi));
        assert!(residual(&outcome) < 1e-13, "{part} {zeta}: {:e}", residual(&outcome));
    }
}

/// A harmonic torque moves a phase back and forth over boundaries between equal levels, which do not change the motion. The engine
/// finds each crossing of the closed form that a fine sampling shows.
#[test]
fn no_crossing_is_missed() {
    let mut random = 12345u64;
    let mut fraction = || {
        random = random.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (random >> 11) as f64 / (1u64 << 53) as f64
    };
    let (w, mut crossings) = (omega(), 0);
    for case in 0..200 {
        let (drive, a) = (w * (0.2 + 2.0 * fraction()), 4000.0 * fraction());
        let (v, begin) = (400.0 * (fraction() - 0.5), TAU * fraction());
        let widths = [0.05 + 3.0 * fraction(), 0.01 + 3.0 * fraction()];
        let t_end = 4e-3;
        let outcome = run(&[
            "effects=[\"stiffness_step\", \"torques\"]",
            &format!("parameters.T0={{harmonics=[{{amplitude=\"{a:?} N*m\", frequency=\"{:?} Hz\"}}]}}", drive / TAU),
            &format!(
                "laws.k.steps=[{{value=\"2 kN*m\", width=\"{:?} rad\"}}, {{value=\"2 kN*m\", width=\"{:?} rad\"}}, {{value=\"2 kN*m\"}}]",
                widths[0], widths[1]
            ),
            &format!("start={{theta=\"{begin:?} rad\", theta_dot=\"{v:?} rad/s\", phi=0}}"),
            &format!("run.t_end=\"{t_end} s\""),
            "output.rate=\"1 kHz\"",
        ]);
        // Without damping, theta'' = (M1/M2) phi''.
        let frequency: f64 = format!("{:?}", drive / TAU).parse().unwrap();
        let drive = TAU * frequency;
        let (mean, half) = (0.5 * (drive + w), 0.5 * (drive - w));
        let phi = |t: f64| M[1] * a * (half * t).sin() / half * (mean * t).sin() / (2.0 * mean);
        let theta = |t: f64| begin + v * t + M[0] / M[1] * phi(t);
        let cell = |x: f64| {
            let (turn, rest) = ((x / TAU).floor() as i64, x.rem_euclid(TAU));
            3 * turn + i64::from(rest >= widths[0]) + i64::from(rest >= widths[0] + widths[1])
        };
        let (n, mut passed, mut last) = (100_000, 0, cell(theta(0.0)));
        for i in 1..=n {
            let now = cell(theta(t_end * f64::from(i) / f64::from(n)));
            passed += now.abs_diff(last);
            last = now;
        }
        let changes = outcome.counts.cell_changes;
        // The samples may miss a pair of crossings; the engine misses none.
        assert!(
            changes >= passed && (changes - passed).is_multiple_of(2) && changes - passed <= 2,
            "{case}: {changes} {passed}"
        );
        crossings += passed;
    }
    assert!(crossings > 1000, "{crossings}");
}
