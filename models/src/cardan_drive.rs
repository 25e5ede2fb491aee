//! A gear pair whose driven shaft turns a load through a universal joint, as in the drive of a rolling mill.

use gearsim_derive::{Model, Range, half};

use crate::components::{damping, driven, machines, pair, pressure_tangent, rotor, universal_joint};

/// Coordinates: those of the gear pair. The shaft behind the joint is rigid: its speed follows from the rotation of the driven gear.
pub fn cardan_drive(m: &mut Model) {
    m.title("a gear pair that turns a load through a universal joint");
    m.source("gears as Oh, Grosh & Barber (2005); joint as Seherr-Thoss, Schmelz & Aucktor, Universal Joints and Driveshafts, Ch. 1");

    let gears = pair(m, "", "1", "2");
    rotor(m, "1", "driving gear", gears.theta1);
    rotor(m, "2", "driven gear", gears.theta2);
    let speed = universal_joint(m, "", gears.theta2);
    let inertia = m.parameter("I_o", "kg*m^2", None, Range::Positive, "moment of inertia behind the joint");
    m.kinetic(half(inertia * speed.sq()));
    let tangent = pressure_tangent(m);
    gears.mesh(m, "12", "mesh", tangent);
    driven(m, "motor", "driving gear", gears.theta1);
    m.effect("torques", "constant torques of motor and load", |m| {
        let doc = "load torque behind the joint, against its rotation";
        let load = m.parameter("T_load", "N*m", None, Range::Any, doc);
        m.torque_along("load", load, -speed, doc);
    });
    // The machines act on the shaft before the joint, where the speed is linear in the speeds of the coordinates.
    machines(m, "2", "driven gear", gears.theta2);
    damping(m);
    m.motion("speed", "rad/s", &[(gears.theta, gears.n1)], "rotational speed of the driving gear");
}
