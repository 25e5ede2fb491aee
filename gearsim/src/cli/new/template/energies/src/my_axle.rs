//! A motor that drives a wheel through a gear pair and a shaft.

use gearsim_derive::{Model, Start};
use gearsim_models::components::{damping, drive, load, pair, pressure_tangent, rotor, shaft};

/// Coordinates: the mean rotation and the mesh deflection of the pair, and the twist of the shaft.
pub fn my_axle(m: &mut Model) {
    m.title("a motor that drives a wheel through a gear pair and a shaft");
    m.source("the tutorial of gearsim");

    let gears = pair(m, "", "1", "2");
    let psi = m.coordinate("psi", "rad", Start::Static, "twist of the shaft");
    let wheel = gears.theta2 - psi;

    rotor(m, "1", "motor with the driving gear", gears.theta1);
    rotor(m, "2", "driven gear", gears.theta2);
    rotor(m, "w", "wheel", wheel);
    shaft(m, "s", "shaft", psi, gears.theta2);
    let tangent = pressure_tangent(m);
    gears.mesh(m, "12", "mesh", tangent);
    drive(m, "motor", "motor", gears.theta1);
    load(m, "wheel", "wheel", wheel);
    damping(m);
    m.motion("speed", "rad/s", &[(gears.theta, gears.n1)], "rotational speed of the motor");
}
