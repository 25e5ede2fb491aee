//! Two shafts geared rigidly: motor and disc on the first shaft, a disc on the second.

use gearsim_derive::{GearData, Model, Start};

use crate::components::{damping, driven, geared, loaded, rotor, shaft};

/// Coordinates: the rotations of motor, gear and disc of the first shaft, and of the disc of the second shaft.
#[allow(non_snake_case)] // the field's symbols
pub fn geared_branches(m: &mut Model) {
    m.title("two shafts geared rigidly, with a motor and two discs");
    m.source("Friswell, Penny, Garvey & Lees (2010), Dynamics of Rotating Machines, Ch. 9: geared systems");

    let N1 = m.gear_data(GearData::Teeth, "N1", Some(1.0), "number of teeth of the first shaft's gear");
    let N2 = m.gear_data(GearData::Teeth, "N2", Some(1.0), "number of teeth of the second shaft's gear");
    let theta1 = m.coordinate("theta1", "rad", Start::At(0.0), "rotation of the first shaft's gear");
    let theta2 = geared(theta1, N1, N2);
    let [theta_m, theta_a, theta_b] =
        [("theta_m", "motor"), ("theta_a", "first shaft's disc"), ("theta_b", "second shaft's disc")]
            .map(|(name, what)| m.coordinate(name, "rad", Start::Static, &format!("rotation of the {what}")));

    rotor(m, "m", "motor", theta_m);
    rotor(m, "1", "first shaft's gear", theta1);
    rotor(m, "2", "second shaft's gear", theta2);
    rotor(m, "a", "first shaft's disc", theta_a);
    rotor(m, "b", "second shaft's disc", theta_b);
    shaft(m, "m", "motor's shaft", theta_m - theta1, theta_m);
    shaft(m, "a", "shaft to the first disc", theta1 - theta_a, theta1);
    shaft(m, "b", "shaft to the second disc", theta2 - theta_b, theta2);
    driven(m, "motor", "motor", theta_m);
    loaded(m, "load", "second shaft's disc", theta_b);
    damping(m);
    let speeds = [(theta_m, 1.into()), (theta1, 1.into()), (theta_a, 1.into()), (theta_b, N1 / N2)];
    m.motion("speed", "rad/s", &speeds, "rotational speed of the first shaft");
}
