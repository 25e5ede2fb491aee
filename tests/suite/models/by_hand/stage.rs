//! The planetary stage that several models have in common: its numbers and its kinematics.

use super::Numbers;

/// A stage with three planets.
pub const STAGE: Numbers = &[
    ("Z_s", 27.0),
    ("Z_r", 99.0),
    ("r_s", 0.7),
    ("alpha", 0.41),
    ("I_s", 0.4),
    ("I_c", 2.7),
    ("I_r", 3.7),
    ("I_p", 0.3),
    ("m_p", 0.8),
    ("k_r", 9.1),
    ("k_s1", 5.1),
    ("k_r1", 6.1),
    ("k_s2", 5.2),
    ("k_r2", 6.2),
    ("k_s3", 5.3),
    ("k_r3", 6.3),
];

/// The torsional supports of sun and carrier.
pub const SUPPORTS: [(&str, f64); 2] = [("k_s", 2.3), ("k_c", 3.1)];

/// The mesh stiffnesses of planets 4 to 7.
pub const FURTHER: [(&str, f64); 8] = [
    ("k_s4", 5.4),
    ("k_r4", 6.4),
    ("k_s5", 5.5),
    ("k_r5", 6.5),
    ("k_s6", 5.6),
    ("k_r6", 6.6),
    ("k_s7", 5.7),
    ("k_r7", 6.7),
];

/// Base radii of sun, planet and ring, and the radius of the circle of planet centres.
pub fn radii(p: &impl Fn(&str) -> f64) -> [f64; 4] {
    let [r_s, r_r] = [p("r_s"), p("r_s") * p("Z_r") / p("Z_s")];
    [r_s, (r_r - r_s) / 2.0, r_r, (r_r + r_s) / 2.0 / p("alpha").cos()]
}

/// Absolute rotations of the sun and the carrier, and a function for that of a planet. Its argument is the planet's coordinate u:
/// base radius times the rotation beyond rolling.
pub fn rotations(p: &impl Fn(&str) -> f64, theta: f64, theta_c: f64) -> (f64, f64, impl Fn(f64) -> f64) {
    let [_, r_p, ..] = radii(p);
    let carrier = theta / p("Z_r") + theta_c;
    let (z_s, z_p) = (p("Z_s"), (p("Z_r") - p("Z_s")) / 2.0);
    (carrier + theta / z_s, carrier, move |beyond| carrier - theta / z_p + beyond / r_p)
}
