//! A motor that drives a rotor through an overrunning clutch.

use gearsim_derive::{Model, Start};

use crate::components::{driven, dry_friction, loaded, overrunning_clutch, rotor, viscous};

/// Coordinates: the rotations of both rotors.
pub fn freewheel(m: &mut Model) {
    m.title("a motor, an overrunning clutch and a rotor with dry friction");
    m.source("compare Modelica.Mechanics.Rotational.Examples.OneWayClutch and .Friction");

    let theta1 = m.coordinate("theta1", "rad", Start::At(0.0), "rotation of the motor");
    let theta2 = m.coordinate("theta2", "rad", Start::At(0.0), "rotation of the driven rotor");
    rotor(m, "1", "motor", theta1);
    rotor(m, "2", "driven rotor", theta2);
    overrunning_clutch(m, "", "clutch", theta1 - theta2);
    dry_friction(m, "2", "bearings of the driven rotor", ["rad", "N*m"], theta2);
    viscous(m, "2", "driven rotor", theta2);
    driven(m, "motor", "motor", theta1);
    loaded(m, "load", "driven rotor", theta2);
    m.motion("speed", "rad/s", &[(theta1, 1.into()), (theta2, 1.into())], "rotational speed of both rotors");
}
