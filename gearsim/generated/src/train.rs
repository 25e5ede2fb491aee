//! The model whose parts a scene lists, and its elements: the only model that is not a file of `cargo xtask derive`.

use gearsim::interface::{Derived, Functions};
use gearsim::model::Model;

const fn element<D: Derived>() -> (&'static Model, Functions) {
    (&D::MODEL, Functions::of::<D>())
}

/// The elements, once for each of the two lists.
macro_rules! elements {
    ($($file:ident::$element:ident,)*) => {
        /// The elements, in the order of `gearsim_models::ELEMENTS`: description and functions of each.
        pub static ELEMENTS: &[(&Model, Functions)] = &[$(element::<super::$file::$element>()),*];
        const MODELS: &[&Model] = &[$(&super::$file::$element::MODEL),*];
    };
}

elements! {
    element_rotor::ElementRotor,
    element_planets::ElementPlanets,
    element_shaft::ElementShaft,
    element_support::ElementSupport,
    element_thrust_bearing::ElementThrustBearing,
    element_mesh::ElementMesh,
    element_mesh_with_friction::ElementMeshWithFriction,
    element_viscous::ElementViscous,
    element_drive::ElementDrive,
    element_load::ElementLoad,
    element_governor::ElementGovernor,
    element_dc_motor::ElementDcMotor,
    element_induction_motor::ElementInductionMotor,
    element_traction_motor::ElementTractionMotor,
    element_fan::ElementFan,
    element_dry_friction::ElementDryFriction,
    element_clutch::ElementClutch,
    element_end_stop::ElementEndStop,
}

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
    elements: MODELS,
};

/// A scene to start from.
pub const TRAIN_SCENE: &str = include_str!("train.toml");
