//! An electric axle, from motor to wheel: overrunning clutch, two stages of gears, half shaft, wheel and vehicle.

use gearsim_derive::{Model, Start};

use crate::components::{
    damping, driven, dry_friction, loaded, overrunning_clutch, pair, pressure_tangent, rotor, shaft, viscous,
};

/// Coordinates: the rotation of the motor, the mean rotation and the deflection of each mesh, and the twist of the half shaft.
pub fn electric_axle(m: &mut Model) {
    m.title("an electric axle with an overrunning clutch and two stages");
    m.source("standard torsional model; phases as Oh, Grosh & Barber (2005)");

    let theta_m = m.coordinate("theta_m", "rad", Start::At(0.0), "rotation of the motor");
    let (first, second) = (pair(m, "1", "1", "2"), pair(m, "2", "3", "4"));
    let psi = m.coordinate("psi", "rad", Start::Static, "twist of the half shaft");
    let wheel = second.theta2 - psi;

    rotor(m, "m", "motor", theta_m);
    let gears = [("1", first.theta1), ("2", first.theta2), ("3", second.theta1), ("4", second.theta2)];
    for (part, theta) in gears {
        rotor(m, part, &format!("gear {part}"), theta);
    }
    rotor(m, "w", "wheel and vehicle", wheel);
    overrunning_clutch(m, "", "clutch between motor and gear 1", theta_m - first.theta1);
    shaft(m, "c", "intermediate shaft", first.theta2 - second.theta1, first.theta2);
    shaft(m, "h", "half shaft", psi, second.theta2);

    let tangent = pressure_tangent(m);
    first.mesh(m, "12", "mesh of gears 1 and 2", tangent);
    second.mesh(m, "34", "mesh of gears 3 and 4", tangent);

    driven(m, "motor", "motor", theta_m);
    loaded(m, "load", "wheel, by slope and air", wheel);
    dry_friction(m, "w", "rolling wheel", ["rad", "N*m"], wheel);
    viscous(m, "w", "wheel", wheel);
    damping(m);
    let (fast, slow) = (first.n1, first.n1 / first.n2 * second.n1);
    let speeds = [(theta_m, 1.into()), (first.theta, fast), (second.theta, slow)];
    m.motion("speed", "rad/s", &speeds, "rotational speed of the motor");
}
