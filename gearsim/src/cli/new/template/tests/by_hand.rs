//! The derived equations against Newton's laws for each rotor, written by hand.

use gearsim::{Error, Scene};

/// The scene of this crate without play and damping: k12 is then the only law.
fn scene() -> Result<Scene, Error> {
    gearsim::add_models(my_axle::generated::MODELS);
    let scene = Scene::load(concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/my_axle.toml"))?;
    scene.with("effects", r#"["stiffness_step", "torques"]"#)
}

/// Accelerations [SI] of theta, s and psi at the mesh stiffness `k` [N/m].
#[allow(non_snake_case)] // the field's symbols
fn by_hand(scene: &Scene, [_, s, psi]: [f64; 3], k: f64) -> [f64; 3] {
    let p = |name: &str| scene.parameter(name).unwrap();
    let (N1, N2, r1) = (p("N1"), p("N2"), p("r1"));
    let r2 = r1 * N2 / N1;
    let (mesh, shaft) = (k * s, p("k_s") * psi);
    let motor = (p("T_motor") - r1 * mesh) / p("I1");
    let gear = (r2 * mesh - shaft) / p("I2");
    let wheel = (shaft - p("T_wheel")) / p("I_w");
    [(N1 * motor + N2 * gear) / 2.0, r1 * motor - r2 * gear, gear - wheel]
}

#[test]
fn the_derived_equations_are_newtons() -> Result<(), Error> {
    let scene = scene()?;
    for (q, k) in [([0.3, 5e-6, 0.01], 220e6), ([4.1, -2e-6, 0.0125], 350e6)] {
        let derived = scene.acceleration(&q, &[157.0, 0.01, -0.2], &[k])?;
        for (derived, hand) in derived.iter().zip(by_hand(&scene, q, k)) {
            assert!((derived - hand).abs() <= 1e-12 * hand.abs(), "derived {derived}, by hand {hand}");
        }
    }
    Ok(())
}

#[test]
fn a_run_conserves_energy() -> Result<(), Error> {
    let results = scene()?.run()?;
    results.check()?;
    let run = results.trajectory();
    assert!(run.residual.iter().all(|residual| residual.abs() < 1e-9 * run.largest_energy()));
    // Static tooth force: 50 N m on a base radius of 28 mm.
    let force = results.observed("mesh_force_12")?.mean.0;
    assert!((force / (50.0 / 0.028) - 1.0).abs() < 0.05, "{force} N");
    Ok(())
}
