//! A two-stage gearbox: gears 1 and 2, countershaft, gears 3 and 4, between motor and load.

use gearsim_derive::{Model, Start};

use crate::components::{damping, driven, loaded, pair, pressure_tangent, rotor, shaft};

/// Coordinates: the mean rotation and the deflection of each mesh, and the twists of the shafts of motor and load.
pub fn two_stage(m: &mut Model) {
    m.title("a two-stage gearbox with a countershaft");
    m.source("standard torsional model; phases as Oh, Grosh & Barber (2005)");

    let (first, second) = (pair(m, "1", "1", "2"), pair(m, "2", "3", "4"));
    let psi_m = m.coordinate("psi_m", "rad", Start::Static, "twist of the motor's shaft");
    let psi_l = m.coordinate("psi_l", "rad", Start::Static, "twist of the load's shaft");
    let (theta_m, theta_l) = (first.theta1 + psi_m, second.theta2 - psi_l);

    let rotations = [first.theta1, first.theta2, second.theta1, second.theta2];
    rotor(m, "m", "motor", theta_m);
    for (part, theta) in ["1", "2", "3", "4"].into_iter().zip(rotations) {
        rotor(m, part, &format!("gear {part}"), theta);
    }
    rotor(m, "l", "load", theta_l);
    shaft(m, "m", "motor's shaft", psi_m, theta_m);
    shaft(m, "c", "countershaft", first.theta2 - second.theta1, first.theta2);
    shaft(m, "l", "load's shaft", psi_l, second.theta2);
    let tangent = pressure_tangent(m);
    first.mesh(m, "12", "mesh of gears 1 and 2", tangent);
    second.mesh(m, "34", "mesh of gears 3 and 4", tangent);
    driven(m, "motor", "motor", theta_m);
    loaded(m, "load", "load", theta_l);
    damping(m);
    let speeds = [(first.theta, first.n1), (second.theta, first.n1 / first.n2 * second.n1)];
    m.motion("speed", "rad/s", &speeds, "rotational speed of the first gear");
}
