//! Parametric instability: independently computed boundaries, and Floquet multipliers compared with 50 digits.

use gearsim::__private::{Inside, linear};
use gearsim::analysis::floquet::{Aperiodic, Floquet, FloquetError, Verdict};
use gearsim::scene::Scene;
use gearsim_tests::precise::number::{Real, Scalar};

use crate::common;
use crate::damped::cell;
use crate::models::{DAMPERS, FIRST_ENDS, LEVELS, scene};

/// The Floquet analysis of the gear pair of Oh, Grosh & Barber (2005), k1 : k2 = 1.43 : 2.78, with two tooth pairs over 0.725 of a
/// pitch, in steady rotation. The mesh frequency is `ratio` times the natural frequency at the mean stiffness, and the damping ratio
/// `zeta` is relative to that frequency.
fn pair(base: &Scene, zeta: f64, ratio: f64) -> Floquet {
    let system = |scene: &Scene| common::model("gear_pair").system(scene).expect("the gear pair is linear");
    let mut scene = base.clone();
    let law = &scene.laws[0];
    // The model's zeta is relative to the mid stiffness.
    let of = |name: &str| base.model.parameters.iter().position(|p| p.name == name).expect("a parameter");
    scene.parameters[of("zeta")] = zeta * (law.mean() / law.mid()).sqrt();
    scene.start.motions = vec![0.0; scene.start.motions.len()];
    scene.start.q_dot[0] = Some(1.0);
    let natural = linear::floquet(&scene, &system(&scene)).expect("a system with multipliers").natural;
    scene.start.q_dot[0] = Some(ratio * natural * std::f64::consts::TAU);
    linear::floquet(&scene, &system(&scene)).expect("a system with multipliers")
}

fn base() -> Scene {
    let widths = 0.275 * std::f64::consts::TAU;
    let steps =
        format!("laws.k.steps=[{{ value = \"1.43 kN*m\", width = \"{widths:?} rad\" }}, {{ value = \"2.78 kN*m\" }}]");
    common::scene("oh2005/energy_300rpm", &[steps])
}

/// The ratio at which instability begins, between a stable and an unstable ratio, by bisection.
fn boundary(base: &Scene, zeta: f64, mut stable: f64, mut unstable: f64) -> f64 {
    let grows = |ratio: f64| pair(base, zeta, ratio).verdict.is_unstable();
    assert!(!grows(stable) && grows(unstable), "zeta {zeta}: no boundary between {stable} and {unstable}");
    while (stable - unstable).abs() > 1e-7 {
        let middle = 0.5 * (stable + unstable);
        if grows(middle) { unstable = middle } else { stable = middle }
    }
    0.5 * (stable + unstable)
}

/// Boundaries of the parametric instability of the gear pair of Oh, Grosh & Barber (2005), as the ratio of mesh frequency to the natural
/// frequency at the mean stiffness. They were computed independently from the numbers of the paper.
#[test]
fn the_gear_pair_is_unstable_where_meissners_equation_is() {
    let base = base();
    for (zeta, inside, printed) in [
        (0.0, 2.0, [1.868, 2.131]),
        (0.0, 1.0, [0.944, 1.045]),
        (0.05, 2.0, [1.911, 2.083]),
        (0.05, 0.993, [0.982, 1.0045]),
    ] {
        let found = [0.85, 1.15].map(|side| boundary(&base, zeta, side * inside, inside));
        println!("zeta {zeta}: {:.4} to {:.4}, printed {} to {}", found[0], found[1], printed[0], printed[1]);
        for (found, printed) in found.into_iter().zip(printed) {
            // Printed to three decimals; some are truncated, not rounded.
            assert!((found - printed).abs() < 1e-3, "{found}, not {printed}");
        }
    }
    let growing =
        (0..=400).map(|i| 0.8 + 0.0035 * f64::from(i)).find(|ratio| pair(&base, 0.1, *ratio).verdict.is_unstable());
    assert_eq!(growing, None, "with zeta = 0.1 no ratio is unstable");
}

#[test]
fn each_kind_of_stability_is_recognised() {
    let base = base();
    assert_eq!(pair(&base, 0.05, 1.5).verdict, Verdict::Stable);
    assert_eq!(pair(&base, 0.0, 1.5).verdict, Verdict::Neutral);
    assert_eq!(pair(&base, 0.0, 2.0).verdict, Verdict::Alternating);
    assert_eq!(pair(&base, 0.0, 1.0).verdict, Verdict::Growing);
    let edge = boundary(&base, 0.0, 1.7, 2.0);
    let near = [-1e-7, -1e-8, 1e-8, 1e-7].map(|d| pair(&base, 0.0, edge + d).verdict);
    assert!(near.contains(&Verdict::Neutral) && near.contains(&Verdict::Alternating), "{near:?}");
    // The border itself, where the trace is -2 except for rounding errors.
    let (mut stable, mut unstable) = (edge - 1e-6, edge + 1e-6);
    let verdict = loop {
        let middle = 0.5 * (stable + unstable);
        match pair(&base, 0.0, middle).verdict {
            Verdict::Alternating => unstable = middle,
            Verdict::Neutral => stable = middle,
            other => break other,
        }
        assert!(unstable - stable > 1e-15, "no border between {stable} and {unstable}");
    };
    assert_eq!(verdict, Verdict::Border);
}

/// Damping couples two vibrations with a rotor that has no spring. The trace and the determinant of the monodromy matrix are compared
/// with 50 digits.
#[test]
fn multipliers_with_coupled_damping_agree_with_the_matrix_exponential() {
    for (c1, c2, speed) in [(0.05, 0.3, 2.0), (0.4, 0.0, 1.1), (3.0, 9.0, 0.7)] {
        let scene = scene(&format!(
            "parameters = {{ c1 = \"{c1:?} N*m*s\", c2 = \"{c2:?} N*m*s\" }}\nstart.speed = \"{speed:?} rad/s\"\nrun.t_end = \"1 s\""
        ));
        let system = DAMPERS.system(&scene).expect("a linear model");
        let floquet = linear::floquet(&scene, &system).expect("a system with multipliers");
        assert_eq!(floquet.rigid, 0);
        assert!((floquet.period - 1.0 / speed).abs() < 1e-15);
        let steps = [(LEVELS[0], FIRST_ENDS), (LEVELS[1], 1.0 - FIRST_ENDS)];
        let steps = steps.map(|(k, width)| cell(k, c1, c2, 0.0).over(&(Real::exact(width) / Real::exact(speed))));
        let mut trace = 0.0;
        for i in 0..6 {
            let unit =
                |from: usize| (0..3).map(|j| Real::exact(f64::from(u8::from(from + j == i)))).collect::<Vec<_>>();
            let (mut q, mut v) = (unit(0), unit(3));
            for step in &steps {
                (q, v) = step.of(&q, &v);
            }
            trace += if i < 3 { q[i].approx() } else { v[i - 3].approx() };
        }
        // The rotor without a spring may rest at any angle. This gives a multiplier 1, which is left out.
        assert_eq!(floquet.multipliers.len(), 5);
        let sum: f64 = floquet.multipliers.iter().map(|z| z.re).sum();
        assert!((sum + 1.0 - trace).abs() < 1e-12, "{sum} + 1, not {trace}");
        // det = e^{-trace(M⁻¹C) T}.
        let determinant = (-(2.0 * c1 + c2 / 0.5) / speed).exp();
        let product = floquet.multipliers.iter().product::<nalgebra::Complex<f64>>();
        assert!((product.re - determinant).abs() < 1e-12, "{product}, not {determinant}");
        assert_eq!(floquet.verdict.is_unstable(), floquet.growth() > 0.0);
    }
}

#[test]
fn a_system_that_is_not_periodic_is_refused() {
    let refused = |base: &Scene| {
        let system = common::model("gear_pair").system(base).expect("the gear pair is linear");
        linear::floquet(base, &system).expect_err("no period")
    };
    let still = common::scene("oh2005/energy_300rpm", &["start.speed=0 rpm".into()]);
    assert_eq!(refused(&still), FloquetError::Aperiodic(Aperiodic::Still { law: "k" }));
    let constant = common::scene("oh2005/energy_300rpm", &["effects=[\"damping\"]".into()]);
    assert_eq!(refused(&constant), FloquetError::Aperiodic(Aperiodic::Constant));
}
