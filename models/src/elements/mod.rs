//! The elements of trains: models of one part each, from which scenes with `model = "train"` are put together without a compiler.
//!
//! An element has coordinates of its own, for example the twist of a shaft. A train adds the energies of its elements, each with its
//! coordinates at x = R q, so the forces of the train are the sum of R^T f. The functions here call the components of models and add
//! nothing to them. Every element has the part name `x` and the description `{}`; a train replaces both by the name of the part.
//!
//! The derivation proves that M is positive definite, but an element such as a spring has no inertia. It therefore has a test inertia `J`
//! in place of the bodies at its ends. In trains J is zero, because the rotors have the inertia.

mod bodies;
mod springs;
mod switches;
mod torques;

use gearsim_derive::{Entry, Expr, Model, Range, Start, half};

/// All elements, one line each.
pub const ELEMENTS: &[Entry] = &[
    ("element_rotor", bodies::rotor),
    ("element_planets", bodies::planets),
    ("element_shaft", springs::shaft),
    ("element_support", springs::support),
    ("element_thrust_bearing", springs::thrust_bearing),
    ("element_mesh", springs::mesh),
    ("element_mesh_with_friction", springs::mesh_with_friction),
    ("element_viscous", torques::viscous),
    ("element_drive", torques::drive),
    ("element_load", torques::load),
    ("element_governor", torques::governor),
    ("element_dc_motor", torques::dc_motor),
    ("element_induction_motor", torques::induction_motor),
    ("element_traction_motor", torques::traction_motor),
    ("element_fan", torques::fan),
    ("element_dry_friction", switches::dry_friction),
    ("element_clutch", switches::clutch),
    ("element_end_stop", switches::end_stop),
];

/// Declares a coordinate of an element and its test inertia, named after it.
fn coordinate(m: &mut Model, name: &str, unit: &str, doc: &str) -> Expr {
    let x = m.coordinate(name, unit, Start::Static, doc);
    let inertia = if unit == "m" { "kg" } else { "kg*m^2" };
    let test = m.parameter(&format!("J_{name}"), inertia, None, Range::Positive, "test inertia, 0 in trains");
    m.kinetic(half(test * x.dot().sq()));
    x
}

/// Damping in proportion to the stiffness of all springs so far. Declares `beta_K`.
#[allow(non_snake_case)] // the field's symbol
fn damping(m: &mut Model) {
    let beta_K = m.parameter("beta_K", "s", Some(0.0), Range::NotNegative, "damping in proportion to stiffness");
    m.effect("damping", "Rayleigh damping, C = alpha_M M + beta_K K at the mid stiffness", |m| {
        m.rayleigh(0.into(), beta_K);
    });
}
