//! An idler train: gear 1 drives gear 3 through the idler 2.

use gearsim_derive::{GearData, Model, Start};

use crate::components::{Sliding, damping, driven, loaded, mesh_with_play, pressure_tangent, rotor, sliding_friction};

/// Coordinates: the rotation of the idler times its number of teeth, which is the phase of both meshes, and the deflections of
/// the two meshes.
#[allow(non_snake_case)] // the field's symbols
pub fn idler(m: &mut Model) {
    m.title("two gears with an idler between them");
    m.source("standard torsional model; phase as Oh, Grosh & Barber (2005), on the idler");

    let [N1, N2, N3] = ["1", "2", "3"].map(|gear| {
        m.gear_data(GearData::Teeth, &format!("N{gear}"), None, &format!("number of teeth of gear {gear}"))
    });
    let r2 = m.gear_data(GearData::BaseRadius, "r2", None, "base radius of the idler");
    let h = m.constant("h", r2 / N2);
    let theta = m.coordinate("theta", "rad", Start::At(0.0), "rotation of the idler times N2; one pitch is 2 pi");
    let delta1 = m.coordinate("delta1", "m", Start::Static, "deflection of the mesh of gears 1 and 2");
    let delta2 = m.coordinate("delta2", "m", Start::Static, "deflection of the mesh of gears 2 and 3");
    let (theta1, theta3) = ((theta + delta1 / h) / N1, (theta - delta2 / h) / N3);

    rotor(m, "1", "driving gear", theta1);
    rotor(m, "2", "idler", theta / N2);
    rotor(m, "3", "driven gear", theta3);
    let mesh1 = mesh_with_play(m, "12", "mesh of gears 1 and 2", theta, delta1, h * theta + delta1);
    let mesh2 = mesh_with_play(m, "23", "mesh of gears 2 and 3", theta, delta2, h * theta);
    let tangent = pressure_tangent(m);
    let sliding = |delta, psi| Sliding { phase: theta, tau: tangent * delta, psi };
    sliding_friction(m, "12", "mesh of gears 1 and 2", "m", mesh1, sliding(delta1, theta1 + theta / N2));
    sliding_friction(m, "23", "mesh of gears 2 and 3", "m", mesh2, sliding(delta2, theta / N2 + theta3));
    driven(m, "motor", "driving gear", theta1);
    loaded(m, "load", "driven gear", theta3);
    damping(m);
    m.motion("speed", "rad/s", &[(theta, N1)], "rotational speed of the driving gear");
}
