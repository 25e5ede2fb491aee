//! A planetary stage with n planets: sun, ring and carrier turn, the planets' centres are fixed to the carrier.

use gearsim_derive::{Model, Start};

use crate::components::{damping, drive, ground, load, rotor, stage};

/// Phase, carrier, ring, and what each of `n` planets turns beyond rolling.
pub fn planetary(m: &mut Model, n: usize) {
    m.title(&format!("a planetary stage with {n} planets, torsional"));
    m.source("Lin & Parker (1999), J. Vib. Acoust. 121(3), with centres held; phase on the sun");

    let stage = stage(m);
    let theta_r = m.coordinate("theta_r", "rad", Start::Static, "rotation of the ring");
    rotor(m, "s", "sun", stage.theta_s);
    rotor(m, "c", "carrier without planets", stage.theta_c);
    rotor(m, "r", "ring", theta_r);
    ground(m, "r", "ring's torsional support", theta_r);
    stage.planets(m, n, theta_r);
    drive(m, "motor", "sun", stage.theta_s);
    load(m, "load", "carrier", stage.theta_c);
    damping(m);
    m.motion("speed", "rad/s", &[(stage.theta, stage.per_sun)], "rotational speed of the sun, ring at rest");
}
