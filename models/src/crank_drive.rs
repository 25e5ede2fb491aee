//! A gear pair that turns a slider-crank, as in a compressor or a press.

use gearsim_derive::{Model, Range};

use crate::components::{damping, driven, loaded, pair, pressure_tangent, rotor, slider_crank};

/// Coordinates: those of the gear pair. The crank is on the driven gear's shaft; the place of its piston follows from that rotation.
pub fn crank_drive(m: &mut Model) {
    m.title("a gear pair that turns a slider-crank");
    m.source("gears as Oh, Grosh & Barber (2005); slider-crank of textbooks, e.g. Shigley & Uicker, Ch. 14");

    let gears = pair(m, "", "1", "2");
    rotor(m, "1", "driving gear", gears.theta1);
    rotor(m, "2", "driven gear with the crank", gears.theta2);
    let x = slider_crank(m, "p", "piston", gears.theta2);
    let tangent = pressure_tangent(m);
    gears.mesh(m, "12", "mesh", tangent);
    driven(m, "motor", "driving gear", gears.theta1);
    loaded(m, "load", "driven gear", gears.theta2);
    m.effect("torques", "constant torques of motor and load", |m| {
        let force = m.parameter("F_p", "N", Some(0.0), Range::Any, "force on the piston, towards the crank");
        m.torque("piston", force, -x, "force on the piston, towards the crank");
    });
    damping(m);
    m.motion("speed", "rad/s", &[(gears.theta, gears.n1)], "rotational speed of the driving gear");
}
