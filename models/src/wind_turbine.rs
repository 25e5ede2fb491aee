//! The drivetrain of a wind turbine: rotor, planetary stage with a fixed ring, parallel stage, generator.

use gearsim_derive::{Model, Start};

use crate::components::{damping, driven, loaded, pair, pressure_tangent_of, rotor, shaft, stage};

/// Coordinates: the phases of both stages, the rotations in excess of rigid rolling, and the twists of the low-speed and the
/// high-speed shaft.
pub fn wind_turbine(m: &mut Model) {
    m.title("a wind turbine's train: rotor, planetary stage, parallel stage, generator");
    m.source("standard torsional model, e.g. Peeters, Vandepitte & Sas (2006), Wind Energy 9(1-2)");

    let (planetary, gears) = (stage(m), pair(m, "2", "1", "2"));
    let psi_l = m.coordinate("psi_l", "rad", Start::Static, "twist of the low-speed shaft");
    let psi_h = m.coordinate("psi_h", "rad", Start::Static, "twist of the high-speed shaft");
    let (theta_b, theta_g) = (planetary.theta_c + psi_l, gears.theta2 - psi_h);

    rotor(m, "b", "rotor with its blades", theta_b);
    rotor(m, "c", "carrier without planets", planetary.theta_c);
    rotor(m, "s", "sun", planetary.theta_s);
    rotor(m, "1", "wheel of the parallel stage", gears.theta1);
    rotor(m, "2", "pinion of the parallel stage", gears.theta2);
    rotor(m, "g", "generator", theta_g);
    shaft(m, "l", "low-speed shaft", psi_l, theta_b);
    shaft(m, "i", "intermediate shaft", planetary.theta_s - gears.theta1, planetary.theta_s);
    shaft(m, "h", "high-speed shaft", psi_h, gears.theta2);
    planetary.planets(m, 3, 0.into());
    let what = "mesh of the parallel stage";
    let tangent = pressure_tangent_of(m, "12", what);
    gears.mesh(m, "12", what, tangent);
    driven(m, "wind", "rotor", theta_b);
    loaded(m, "generator", "generator", theta_g);
    damping(m);
    let speeds = [(planetary.theta, planetary.per_sun), (gears.theta, gears.n1)];
    m.motion("speed", "rad/s", &speeds, "rotational speed of the sun");
}
