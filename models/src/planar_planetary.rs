//! A planetary stage with n planets in the plane, Lin & Parker (1999): x, y and rotation of every body, 3 (n + 3) coordinates.

use gearsim_derive::{Model, Start};

use crate::components::{Gear, bearing, damping, driven, ground, loaded, planar_rotor, stage, torsional_support};

/// Sun, ring and carrier on bearings, `n` planets on bearings on the carrier.
pub fn planar_planetary(m: &mut Model, n: usize) {
    m.title(&format!("a planetary stage with {n} planets, in the plane"));
    m.source("Lin & Parker (1999), J. Vib. Acoust. 121(3), doi:10.1115/1.2893982, without gyroscopic terms; phase on the sun");

    let stage = stage(m);
    let theta_r = m.coordinate("theta_r", "rad", Start::Static, "rotation of the ring");
    let bodies = [("s", "sun", stage.theta_s), ("c", "carrier", stage.theta_c), ("r", "ring", theta_r)];
    let [sun, carrier, ring] = bodies.map(|(part, what, theta)| {
        let centre = ["x", "y"].map(|axis| {
            m.coordinate(&format!("{axis}_{part}"), "m", Start::Static, &format!("{axis} of the centre of the {what}"))
        });
        planar_rotor(m, part, what, centre, theta);
        bearing(m, part, &format!("bearing of the {what}"), centre);
        centre
    });
    ground(m, "r", "ring's torsional support", theta_r);
    torsional_support(m, "s", "sun's torsional support", stage.theta_s);
    torsional_support(m, "c", "carrier's torsional support", stage.theta_c);
    let gear = |[x, y]: [_; 2], u| Gear { x, y, u };
    let (sun, ring) = (gear(sun, stage.r_s * stage.theta_s), gear(ring, stage.r_r * theta_r));
    stage.planets_on_bearings(m, n, sun, (ring, theta_r), gear(carrier, stage.a * stage.theta_c));
    driven(m, "motor", "sun", stage.theta_s);
    loaded(m, "load", "carrier", stage.theta_c);
    damping(m);
    m.motion("speed", "rad/s", &[(stage.theta, stage.per_sun)], "rotational speed of the sun, ring at rest");
}
