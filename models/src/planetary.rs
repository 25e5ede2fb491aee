//! A torsional planetary stage with n planets: sun, ring and carrier rotate, the centres of the planets are fixed to the carrier.

use gearsim_derive::{Model, Start};

use crate::components::{damping, driven, ground, loaded, rotor, stage, torsional_support};

/// Coordinates: the phase, the rotation of the ring, and the rotations of the carrier and of each of `n` planets in excess of
/// rigid rolling.
pub fn planetary(m: &mut Model, n: usize) {
    m.title(&format!("a planetary stage with {n} planets, torsional"));
    m.source("Lin & Parker (1999), J. Vib. Acoust. 121(3), with centres held; phase on the sun");

    let stage = stage(m);
    let theta_r = m.coordinate("theta_r", "rad", Start::Static, "rotation of the ring");
    rotor(m, "s", "sun", stage.theta_s);
    rotor(m, "c", "carrier without planets", stage.theta_c);
    rotor(m, "r", "ring", theta_r);
    ground(m, "r", "ring's torsional support", theta_r);
    torsional_support(m, "s", "sun's torsional support", stage.theta_s);
    torsional_support(m, "c", "carrier's torsional support", stage.theta_c);
    stage.planets(m, n, theta_r);
    driven(m, "motor", "sun", stage.theta_s);
    loaded(m, "load", "carrier", stage.theta_c);
    damping(m);
    m.motion("speed", "rad/s", &[(stage.theta, stage.per_sun)], "rotational speed of the sun, ring at rest");
}
