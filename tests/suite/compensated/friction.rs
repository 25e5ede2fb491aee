//! Dry friction: the vibration of Den Hartog (1931), its end at rest, and the release by a torque that rises.

use gearsim_tests::precise::number::Scalar;

use crate::digits::{Digits, apart, exact, floor, in_both, judge, of, pi, scene};

/// Spring and friction of the scene; its inertia is 1.
const K: f64 = 400.0;
const T_C: f64 = 4.0;

/// phi and phi' after the time `t` from rest at `phi` > 0. Stuck once |phi| <= (1 + rise) T_c/k at the end of a half vibration.
fn vibration(phi: f64, rise: f64, t: f64) -> [Digits; 2] {
    let (omega, shift) = (exact(K).root(), exact(T_C) / exact(K));
    let half = pi() / omega.clone();
    let (mut turn, mut n) = (exact(phi), 0.0);
    let halves = floor(&(exact(t) / half.clone()));
    let limit = shift.clone() * (exact(1.0) + exact(rise));
    while n < halves && turn > limit {
        turn = turn - shift.scaled(1);
        n += 1.0;
    }
    let sign = exact(if n % 2.0 == 0.0 { 1.0 } else { -1.0 });
    if turn <= limit {
        return [sign * turn, exact(0.0)];
    }
    let (sine, cosine) = (omega.clone() * (exact(t) - half * exact(n))).sine_cosine();
    let size = turn - shift.clone();
    [sign.clone() * (shift + size.clone() * cosine), -(sign * size * omega * sine)]
}

#[test]
fn the_vibration_of_den_hartog_is_accurate_to_double_double() {
    for t in [0.1, 0.2, 0.45, 0.7, 2.0] {
        let scene = scene(
            "friction_oscillator",
            &["start.phi=\"0.105 rad\"", "parameters.rise=0.25", &format!("run.t_end=\"{t:?} s\"")],
        );
        let [x, v] = vibration(0.105, 0.25, t);
        let errors = in_both(&scene, |now| {
            let [q, q_dot] = of(&now.state);
            apart(&q[0], &x, 0.105).max(apart(&q_dot[0], &v, 2.1))
        });
        judge(&format!("dry friction, t = {t} s"), errors, 100.0);
    }
}

/// The torque rises by `slope` until it overcomes spring and breakaway torque. From there on the rotor slips: phi - phi_0 =
/// rise T_c/k (1 - cos) + slope/k (tau - sin/omega). If the spring pulls from the start, plain precision releases the rotor late, when the
/// torque is too large by a relative 1e-9.
#[test]
fn a_release_by_a_rising_torque_is_accurate_to_double_double() {
    for (rise, phi) in [(0.0, 0.0), (0.25, 0.0), (0.0, 0.005), (0.25, 0.005)] {
        let (slope, t) = (16.0, 0.5);
        let scene = scene(
            "friction_oscillator",
            &[
                "effects=[\"dry_friction\", \"torques\"]",
                &format!("start.phi=\"{phi:?} rad\""),
                &format!("parameters.rise={rise:?}"),
                "parameters.T_motor={ramp={to=\"32 N*m\", duration=\"2 s\"}}",
                &format!("run.t_end=\"{t:?} s\""),
            ],
        );
        let torque = exact(T_C) * (exact(1.0) + exact(rise)) + exact(K) * exact(phi);
        let (omega, tau) = (exact(K).root(), exact(t) - torque / exact(slope));
        let (sine, cosine) = (omega.clone() * tau.clone()).sine_cosine();
        let jump = exact(rise) * exact(T_C) / exact(K);
        let x = jump.clone() * (exact(1.0) - cosine.clone())
            + exact(slope) / exact(K) * (tau - sine.clone() / omega.clone());
        let v = jump * omega * sine + exact(slope) / exact(K) * (exact(1.0) - cosine);
        let errors = in_both(&scene, |now| {
            let [q, q_dot] = of(&now.state);
            let moved = q[0].clone() - exact(phi);
            apart(&moved, &x, x.approx()).max(apart(&q_dot[0], &v, v.approx()))
        });
        println!("release, rise {rise}, from {phi} rad: plain {:.1e}, compensated {:.1e}", errors[0], errors[1]);
        assert!(errors[0] < 1e-7 && errors[1] < 1e-27, "{errors:?}");
    }
}
