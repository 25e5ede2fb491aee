//! The model whose parts a scene lists, and its elements: the only model that is not a file of `cargo xtask derive`.

use crate::engine::equations::{Derived, Functions};
use crate::engine::train::Elements;
use crate::model::Model;

const fn element<D: Derived>() -> (&'static Model, Functions) {
    (&D::MODEL, Functions::of::<D>())
}

/// The elements, in the order of `gearsim_models::ELEMENTS`.
pub static ELEMENTS: Elements = Elements(&[
    element::<super::element_rotor::ElementRotor>(),
    element::<super::element_planets::ElementPlanets>(),
    element::<super::element_shaft::ElementShaft>(),
    element::<super::element_support::ElementSupport>(),
    element::<super::element_thrust_bearing::ElementThrustBearing>(),
    element::<super::element_mesh::ElementMesh>(),
    element::<super::element_mesh_with_friction::ElementMeshWithFriction>(),
    element::<super::element_viscous::ElementViscous>(),
    element::<super::element_drive::ElementDrive>(),
    element::<super::element_load::ElementLoad>(),
    element::<super::element_governor::ElementGovernor>(),
    element::<super::element_dc_motor::ElementDcMotor>(),
    element::<super::element_induction_motor::ElementInductionMotor>(),
    element::<super::element_traction_motor::ElementTractionMotor>(),
    element::<super::element_fan::ElementFan>(),
    element::<super::element_dry_friction::ElementDryFriction>(),
    element::<super::element_clutch::ElementClutch>(),
]);

/// The train without parts.
pub static TRAIN: Model = Model {
    name: "train",
    title: "a drivetrain whose rotors, shafts, meshes, planets and torques the scene lists",
    source: "put together from derived elements, each with the proofs of its file",
    coordinates: &[],
    parameters: &[],
    laws: &[],
    motions: &[],
    effects: &[],
    torques: &[],
    outputs: &[],
    switches: &[],
    nonlinear: "",
    nonlinear_with: &[],
    equations: concat!(include_str!("train.txt"), include_str!("train.toml")),
    latex: "",
    relative: &[],
    elements: &[
        &super::element_rotor::ElementRotor::MODEL,
        &super::element_planets::ElementPlanets::MODEL,
        &super::element_shaft::ElementShaft::MODEL,
        &super::element_support::ElementSupport::MODEL,
        &super::element_thrust_bearing::ElementThrustBearing::MODEL,
        &super::element_mesh::ElementMesh::MODEL,
        &super::element_mesh_with_friction::ElementMeshWithFriction::MODEL,
        &super::element_viscous::ElementViscous::MODEL,
        &super::element_drive::ElementDrive::MODEL,
        &super::element_load::ElementLoad::MODEL,
        &super::element_governor::ElementGovernor::MODEL,
        &super::element_dc_motor::ElementDcMotor::MODEL,
        &super::element_induction_motor::ElementInductionMotor::MODEL,
        &super::element_traction_motor::ElementTractionMotor::MODEL,
        &super::element_fan::ElementFan::MODEL,
        &super::element_dry_friction::ElementDryFriction::MODEL,
        &super::element_clutch::ElementClutch::MODEL,
    ],
};

/// A scene to start from.
pub const TRAIN_SCENE: &str = include_str!("train.toml");
