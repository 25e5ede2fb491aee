//! The derived models. The files beside this one are written by `cargo xtask derive`; only this list and `train.rs` are by hand.

mod train;

use crate::run::Entry;
pub use train::{ELEMENTS, TRAIN, TRAIN_SCENE};

#[rustfmt::skip]
pub mod backlash_oscillator;
#[rustfmt::skip]
pub mod belt_drive;
#[rustfmt::skip]
pub mod cardan_drive;
#[rustfmt::skip]
pub mod chain_2;
#[rustfmt::skip]
pub mod chain_32;
#[rustfmt::skip]
pub mod chain_5;
#[rustfmt::skip]
pub mod crank_drive;
#[rustfmt::skip]
pub mod electric_axle;
#[rustfmt::skip]
pub mod element_clutch;
#[rustfmt::skip]
pub mod element_dc_motor;
#[rustfmt::skip]
pub mod element_drive;
#[rustfmt::skip]
pub mod element_dry_friction;
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
pub mod element_viscous;
#[rustfmt::skip]
pub mod freewheel;
#[rustfmt::skip]
pub mod friction_oscillator;
#[rustfmt::skip]
pub mod gear_pair;
#[rustfmt::skip]
pub mod gear_pair_bearings;
#[rustfmt::skip]
pub mod gear_pair_shafts;
#[rustfmt::skip]
pub mod geared_branches;
#[rustfmt::skip]
pub mod idler;
#[rustfmt::skip]
pub mod planar_planetary_3;
#[rustfmt::skip]
pub mod planar_planetary_4;
#[rustfmt::skip]
pub mod planar_planetary_5;
#[rustfmt::skip]
pub mod planetary_3;
#[rustfmt::skip]
pub mod planetary_4;
#[rustfmt::skip]
pub mod planetary_5;
#[rustfmt::skip]
pub mod planetary_6;
#[rustfmt::skip]
pub mod planetary_7;
#[rustfmt::skip]
pub mod two_stage;
#[rustfmt::skip]
pub mod wind_turbine;

/// Every model the program knows: one line each.
pub static MODELS: &[Entry] = &[
    Entry::new::<gear_pair::GearPair>(),
    Entry::new::<backlash_oscillator::BacklashOscillator>(),
    Entry::new::<friction_oscillator::FrictionOscillator>(),
    Entry::new::<freewheel::Freewheel>(),
    Entry::new::<electric_axle::ElectricAxle>(),
    Entry::new::<gear_pair_shafts::GearPairShafts>(),
    Entry::new::<gear_pair_bearings::GearPairBearings>(),
    Entry::new::<geared_branches::GearedBranches>(),
    Entry::new::<two_stage::TwoStage>(),
    Entry::new::<idler::Idler>(),
    Entry::new::<belt_drive::BeltDrive>(),
    Entry::new::<crank_drive::CrankDrive>(),
    Entry::new::<cardan_drive::CardanDrive>(),
    Entry::new::<planetary_3::Planetary3>(),
    Entry::new::<planetary_4::Planetary4>(),
    Entry::new::<planetary_5::Planetary5>(),
    Entry::new::<planetary_6::Planetary6>(),
    Entry::new::<planetary_7::Planetary7>(),
    Entry::new::<planar_planetary_3::PlanarPlanetary3>(),
    Entry::new::<planar_planetary_4::PlanarPlanetary4>(),
    Entry::new::<planar_planetary_5::PlanarPlanetary5>(),
    Entry::new::<wind_turbine::WindTurbine>(),
    Entry::new::<chain_2::Chain2>(),
    Entry::new::<chain_5::Chain5>(),
    Entry::new::<chain_32::Chain32>(),
    Entry::train(&TRAIN, &ELEMENTS),
];
