//! The mean friction loss of a mesh in steady rotation, compared with the loss factor of Ohlendorf (Niemann & Winter,
//! Maschinenelemente II).

use std::f64::consts::{PI, TAU};

use crate::{Teeth, run, unaccounted, work};

/// H_v = pi (u + 1)/(z1 u) (1 - eps + eps_1² + eps_2²) for spur gears.
///
/// It also follows from the definition of the effect. The pitch point is where one pair is in contact. Where two pairs are in
/// contact, each bears half the force. So the mean of the arm over a pitch p is
///
///   1/2 (integral of |xi| over the whole path) + 1/2 (integral over the part with one pair)
///   = (g_f² + g_a² + (p - g_f)² + (p - g_a)²)/(4 p) = p/2 (1 - eps + eps_1² + eps_2²),
///
/// and mu F arm (omega1 + omega2) over F r_b1 omega1 is mu H_v, with p = 2 pi r_b1/z1.
fn loss_factor(teeth: &Teeth) -> f64 {
    let (p, [z1, z2], [before, after]) = (teeth.base_pitch(), teeth.z, teeth.paths());
    let (e1, e2, u) = (before / p, after / p, z2 / z1);
    PI * (u + 1.0) / (z1 * u) * (1.0 - e1 - e2 + e1 * e1 + e2 * e2)
}

/// Friction loss, divided by the work of the drive and by mu, over whole pitches of a mesh with constant stiffness. Damping has removed the
/// vibration.
fn found(mu: f64, module: f64, z: [f64; 2], k: &str) -> f64 {
    let teeth = format!("teeth=[{}, {}], module=\"{module} m\", face_width=\"7 mm\"", z[0], z[1]);
    let outcome = run(&[
        r#"effects=["stiffness_step", "sliding_friction", "torques", "damping"]"#,
        &format!("parameters.mu={mu}"),
        "parameters.zeta=0.5",
        &format!("parameters.N1={}", z[0]),
        &format!("parameters.N2={}", z[1]),
        k,
        &format!("laws.side={{{teeth}}}"),
        r#"laws.arm={teeth_of="side"}"#,
        "start={speed=\"600 rpm\"}",
        "run={t_end=\"0.1 s\", tolerance=1e-11}",
        "output={rate=\"1 MHz\", events=false}",
    ]);
    assert!(unaccounted(&outcome) < 1e-10, "{:e}", unaccounted(&outcome));
    let t = &outcome.trajectory;
    // From one whole pitch to another, without the first three.
    let at =
        |pitches: f64| t.q[0].iter().position(|theta| *theta >= pitches * TAU).expect("a run of this many pitches");
    let (first, last) = (at(3.0), at((t.q[0][t.len() - 1] / TAU).floor()));
    let over = |torque| work(&outcome, torque)[last] - work(&outcome, torque)[first];
    -(over("slide") + over("roll")) / over("drive") / mu
}

/// The loss agrees with the loss factor to first order in mu: a tenth of the friction gives a tenth of the difference.
#[test]
fn the_mean_loss_agrees_with_ohlendorfs_loss_factor() {
    const CONSTANT: &str = r#"laws.k={steps=[{value="2780 N*m"}]}"#;
    for (z, module) in [([24.0, 96.0], 6.35e-3), ([30.0, 40.0], 4e-3)] {
        let expected = loss_factor(&Teeth { z, module });
        let off = [1e-3, 1e-2].map(|mu| found(mu, module, z, CONSTANT) / expected - 1.0);
        println!("{z:?}: H_v = {expected:.6}, off by {:.1e} at mu = 1e-3, {:.1e} at 1e-2", off[0], off[1]);
        assert!(off[0].abs() < 3e-4 && off[1].abs() < 3e-3, "{z:?}: {off:?}");
    }
}
