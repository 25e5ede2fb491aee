//! A gear pair between a motor and a load, on torsional shafts.

use gearsim_derive::{Model, Start};

use crate::components::{damping, driven, loaded, pair, pressure_tangent, rotor, shaft};

/// Coordinates: the mean rotation and the mesh deflection of the pair, and the twists of the two shafts.
pub fn gear_pair_shafts(m: &mut Model) {
    m.title("a gear pair between motor and load, on torsional shafts");
    m.source("standard torsional model, e.g. Kahraman & Singh (1991), J. Sound Vib. 146(1); phase as Oh, Grosh & Barber (2005)");

    let gears = pair(m, "", "1", "2");
    let psi_m = m.coordinate("psi_m", "rad", Start::Static, "twist of the motor's shaft");
    let psi_l = m.coordinate("psi_l", "rad", Start::Static, "twist of the load's shaft");
    let (theta_m, theta_l) = (gears.theta1 + psi_m, gears.theta2 - psi_l);

    rotor(m, "m", "motor", theta_m);
    rotor(m, "1", "driving gear", gears.theta1);
    rotor(m, "2", "driven gear", gears.theta2);
    rotor(m, "l", "load", theta_l);
    shaft(m, "m", "motor's shaft", psi_m, theta_m);
    shaft(m, "l", "load's shaft", psi_l, gears.theta2);
    let tangent = pressure_tangent(m);
    gears.mesh(m, "12", "mesh", tangent);
    driven(m, "motor", "motor", theta_m);
    loaded(m, "load", "load", theta_l);
    damping(m);
    m.motion("speed", "rad/s", &[(gears.theta, gears.n1)], "rotational speed of the driving gear");
}
