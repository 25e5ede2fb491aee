//! A model as a new author writes it, following the guide at the head of `models/src/lib.rs`.

use gearsim_derive::{Model, Range, Start, half};
use gearsim_models::components::mesh_stiffness;

/// A rotor on a spring to the ground, whose stiffness steps with the angle of a second rotor that turns freely.
#[allow(non_snake_case)] // the field's symbols
pub fn spring_rotor(m: &mut Model) {
    m.title("a rotor on a spring that another rotor switches");
    m.source("the guide to models");

    let J1 = m.parameter("J1", "kg*m^2", Some(1.0), Range::Positive, "moment of inertia of the switching rotor");
    let J2 = m.parameter("J2", "kg*m^2", None, Range::Positive, "moment of inertia of the sprung rotor");
    let T1 = m.parameter("T1", "N*m", Some(0.0), Range::Any, "torque on the switching rotor");

    let alpha = m.coordinate("alpha", "rad", Start::At(0.0), "angle of the switching rotor");
    let beta = m.coordinate("beta", "rad", Start::Static, "angle of the sprung rotor");
    m.kinetic(half(J1 * alpha.dot().sq()));
    m.kinetic(half(J2 * beta.dot().sq()));

    let k = mesh_stiffness(m, "k", "N*m", alpha, 1.0, "stiffness of the spring to the ground");
    m.potential(half(k.value * beta.sq()));

    m.effect("torque", "constant torque on the switching rotor", |m| {
        m.torque("drive", T1, alpha, "torque T1 on the switching rotor");
    });
    m.motion("speed", "rad/s", &[(alpha, 1.into())], "rotational speed of the switching rotor");
}
