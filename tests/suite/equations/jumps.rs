//! Eqs. (9), (11): transmission and reflection at random steps, compared with the hand-written rule and checked for energy.

use gearsim::__private::{Passage, Side, Surface};
use gearsim_tests::oh2005::{Jump, State};

use crate::TOLERANCE;
use crate::points::{POINTS, STIFFNESS_STEP, points};

/// The engine's rule with the generated G, M⁻¹n/G and dV gives the same speeds after a step as the rule by hand, and the same decision
/// between transmission and reflection. theta' is drawn around the critical speed sqrt(M2 |dk|) |phi|, because otherwise all points would
/// lie on one side of it.
#[test]
fn speeds_after_a_step_equal_those_of_the_paper() {
    let (mut transmitted, mut reflected, mut worst, mut created) = (0, 0, 0.0f64, 0.0f64);
    for (i, p) in points(POINTS).enumerate() {
        let (equations, pair) = (p.equations(STIFFNESS_STEP), p.pair(0));
        let critical = (pair.m2() * p.dk.abs()).sqrt() * p.phi.abs();
        // Ratios from 1e-4 to 1e4, but none within 0.1% of 1, where the square of the speed after the step is ill-conditioned.
        let ratio = 10f64.powf((i % 8001) as f64 / 1000.0 - 4.0);
        if (ratio - 1.0).abs() < 1e-3 || critical == 0.0 {
            continue;
        }
        let theta_dot = (ratio * critical).copysign(p.theta_dot);
        let mut q_dot = [theta_dot, p.phi_dot].into();
        let side = if theta_dot > 0.0 { Side::Upper } else { Side::Lower };
        let passage =
            Surface::new(&*equations, 0, &p.q()).pass(&mut q_dot, side, equations.step(0, &p.q(), &p.values(), p.dk));
        let by_hand = pair.jump(p.dk, p.phi, theta_dot, p.phi_dot);
        let (passed, theta_after, phi_after) = match by_hand {
            Jump::Transmit { theta_dot, phi_dot } => (true, theta_dot, phi_dot),
            Jump::Reflect { theta_dot, phi_dot } => (false, theta_dot, phi_dot),
        };
        assert_eq!(passage == Passage::Transmitted, passed, "{p:?}");
        if passed {
            transmitted += 1
        } else {
            reflected += 1
        }
        // theta'+^2 = theta'-^2 - M2 dk phi^2 loses |dk phi^2|/theta'+^2 of its digits; |M1| <= M2.
        let square = theta_dot * theta_dot + critical * critical;
        let conditioned = square / theta_after.abs();
        let error = ((q_dot[0] - theta_after) / conditioned)
            .abs()
            .max(((q_dot[1] - phi_after) / (conditioned + p.phi_dot.abs())).abs());
        worst = worst.max(error);

        let before = State { theta: p.theta, theta_dot, phi: p.phi, phi_dot: p.phi_dot };
        let after = State { theta_dot: q_dot[0], phi_dot: q_dot[1], ..before };
        let k = if passed { p.k + p.dk } else { p.k };
        let gained = (pair.kinetic(&after) - pair.kinetic(&before)) + (k - p.k) * p.phi * p.phi;
        let m = pair.i1 / pair.n1.powi(2) + pair.i2 / pair.n2.powi(2);
        let size = [theta_dot, p.phi_dot, q_dot[0], q_dot[1]].into_iter().fold(0.0f64, |m, v| m.max(v.abs()));
        let scale = m * size * size + (p.dk * p.phi * p.phi).abs();
        created = created.max(gained.abs() / scale);
    }
    println!("{transmitted} transmitted, {reflected} reflected; speeds {worst:.1e}, energy created {created:.1e}");
    assert!(transmitted > 1000 && reflected > 1000, "{transmitted} {reflected}");
    assert!(worst < TOLERANCE && created < TOLERANCE, "speeds {worst:e}, energy {created:e}");
}

/// The comparison detects a compliance that is wrong by 1e-12.
#[test]
fn a_wrong_compliance_is_detected() {
    let detected = points(POINTS).filter(|p| p.dk < 0.0).any(|p| {
        let (equations, pair) = (p.equations(STIFFNESS_STEP), p.pair(0));
        let theta_dot = (pair.m2() * p.dk.abs()).sqrt() * p.phi.abs();
        let mut surface = Surface::new(&*equations, 0, &p.q());
        surface.compliance *= 1.0 + 1e-12;
        let mut q_dot = [theta_dot, p.phi_dot].into();
        surface.pass(&mut q_dot, Side::Upper, equations.step(0, &p.q(), &p.values(), p.dk));
        let Jump::Transmit { theta_dot: expected, .. } = pair.jump(p.dk, p.phi, theta_dot, p.phi_dot) else {
            return false;
        };
        (q_dot[0] / expected - 1.0).abs() > TOLERANCE
    });
    assert!(detected);
}
