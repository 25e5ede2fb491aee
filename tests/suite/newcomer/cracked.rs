//! A model whose laws share a phase and have different periods.

use gearsim_derive::{Model, Range, Start, half};
use gearsim_models::components::mesh_stiffness;

/// The sprung rotor of [`model`](crate::model) with two more stiffnesses: a cracked tooth lowers the stiffness once in three pitches,
/// and a second mesh has four teeth in the same three pitches.
#[allow(non_snake_case)] // the field's symbols
pub fn cracked_rotor(m: &mut Model) {
    m.title("a rotor on a spring that another rotor switches, with a cracked tooth");
    m.source("the guide to models");

    let J1 = m.parameter("J1", "kg*m^2", Some(1.0), Range::Positive, "moment of inertia of the switching rotor");
    let J2 = m.parameter("J2", "kg*m^2", None, Range::Positive, "moment of inertia of the sprung rotor");
    let alpha = m.coordinate("alpha", "rad", Start::At(0.0), "angle of the switching rotor");
    let beta = m.coordinate("beta", "rad", Start::Static, "angle of the sprung rotor");
    m.kinetic(half(J1 * alpha.dot().sq()));
    m.kinetic(half(J2 * beta.dot().sq()));

    let c = mesh_stiffness(m, "c", "N*m", alpha, 3.0, "stiffness that the crack takes, once in three pitches");
    let k = mesh_stiffness(m, "k", "N*m", alpha, 1.0, "stiffness of the spring to the ground");
    let g = mesh_stiffness(m, "g", "N*m", alpha, 0.75, "stiffness of a second mesh");
    m.potential(half((k.value - c.value + g.value) * beta.sq()));
    m.motion("speed", "rad/s", &[(alpha, 1.into())], "rotational speed of the switching rotor");
}
