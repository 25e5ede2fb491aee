//! A gear pair between a motor and a load, on torsional shafts.

use gearsim_derive::{Model, Start};

use crate::components::{
    damping, dc_motor, drive, fan, governor, induction_motor, load, pair, pressure_tangent, rotor, shaft,
};

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
    drive(m, "motor", "motor", theta_m);
    load(m, "load", "load", theta_l);
    // The speeds on which motors and fan depend: named, so that the equations are written in them.
    let (omega_m, omega_l) = (m.deflection("theta_m", theta_m).dot(), m.deflection("theta_l", theta_l).dot());
    governor(m, "motor", "motor", theta_m, omega_m);
    dc_motor(m, "motor", "motor", theta_m, omega_m);
    induction_motor(m, "motor", "motor", theta_m, omega_m);
    fan(m, "load", "load", theta_l, omega_l);
    damping(m);
    // One motor at most.
    m.exclude("speed_governor", &["dc_motor", "induction_motor"]);
    m.exclude("dc_motor", &["induction_motor"]);
    m.motion("speed", "rad/s", &[(gears.theta, gears.n1)], "rotational speed of the driving gear");
}
