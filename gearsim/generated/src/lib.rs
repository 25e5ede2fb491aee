//! The derived models of gearsim, and the elements of trains. The files beside this one are written by `cargo xtask derive`; only this list
//! and `train.rs` are by hand. [`gearsim`](https://docs.rs/gearsim) runs scenes of them.
//!
//! The elements are always there, so that scenes with `model = "train"` need no feature.

// The code of `equations!` names the crate `::gearsim`. It needs only the equations of it.
extern crate gearsim_equations as gearsim;

mod train;

pub use train::{ELEMENTS, TRAIN, TRAIN_SCENE};

/// Declares the file of each model, and the list of their types.
macro_rules! models {
    ($($module:ident::$model:ident,)*) => {
        $(
            #[cfg(feature = "models")]
            pub mod $module;
        )*

        /// The types of the models.
        #[cfg(feature = "models")]
        pub mod models {
            $(pub use super::$module::$model;)*
        }

        /// The list `[m!(Model), .., last]` of all models, with a macro `m` of the caller.
        #[cfg(feature = "models")]
        #[macro_export]
        macro_rules! each_model {
            ($m:ident, $last:expr) => {
                [$($m!($crate::models::$model),)* $last]
            };
        }
    };
}

/// Without models the list is that of the last one.
#[cfg(not(feature = "models"))]
#[macro_export]
macro_rules! each_model {
    ($m:ident, $last:expr) => {
        [$last]
    };
}

// One line each. Files that a macro declares are not formatted: they stay as derived.
models! {
    gear_pair::GearPair,
    backlash_oscillator::BacklashOscillator,
    friction_oscillator::FrictionOscillator,
    freewheel::Freewheel,
    electric_axle::ElectricAxle,
    gear_pair_shafts::GearPairShafts,
    gear_pair_bearings::GearPairBearings,
    geared_branches::GearedBranches,
    two_stage::TwoStage,
    idler::Idler,
    belt_drive::BeltDrive,
    crank_drive::CrankDrive,
    cardan_drive::CardanDrive,
    planetary_3::Planetary3,
    planar_planetary_3::PlanarPlanetary3,
    planar_planetary_4::PlanarPlanetary4,
    planar_planetary_5::PlanarPlanetary5,
    wind_turbine::WindTurbine,
    chain_2::Chain2,
    chain_5::Chain5,
    chain_32::Chain32,
}

#[rustfmt::skip]
pub mod element_clutch;
#[rustfmt::skip]
pub mod element_dc_motor;
#[rustfmt::skip]
pub mod element_drive;
#[rustfmt::skip]
pub mod element_dry_friction;
#[rustfmt::skip]
pub mod element_end_stop;
#[rustfmt::skip]
pub mod element_fan;
#[rustfmt::skip]
pub mod element_governor;
#[rustfmt::skip]
pub mod element_induction_motor;
#[rustfmt::skip]
pub mod element_load;
#[rustfmt::skip]
pub mod element_mesh;
#[rustfmt::skip]
pub mod element_mesh_with_friction;
#[rustfmt::skip]
pub mod element_planets;
#[rustfmt::skip]
pub mod element_rotor;
#[rustfmt::skip]
pub mod element_shaft;
#[rustfmt::skip]
pub mod element_support;
#[rustfmt::skip]
pub mod element_thrust_bearing;
#[rustfmt::skip]
pub mod element_traction_motor;
#[rustfmt::skip]
pub mod element_viscous;
