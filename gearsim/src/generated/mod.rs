//! The derived models. Every file beside this one is written by `cargo xtask derive`; only this list is by hand.

use crate::run::Entry;

#[rustfmt::skip]
pub mod backlash_oscillator;
#[rustfmt::skip]
pub mod belt_drive;
#[rustfmt::skip]
pub mod chain_2;
#[rustfmt::skip]
pub mod chain_32;
#[rustfmt::skip]
pub mod chain_5;
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

/// Every model the program knows: one line each, with its number of coordinates. A static, so that the engine is compiled for
/// each number of coordinates here, and not again in whatever links this.
pub static MODELS: &[Entry] = &[
    Entry::new::<gear_pair::GearPair, 2>(),
    Entry::new::<backlash_oscillator::BacklashOscillator, 1>(),
    Entry::new::<gear_pair_shafts::GearPairShafts, 4>(),
    Entry::new::<gear_pair_bearings::GearPairBearings, 6>(),
    Entry::new::<geared_branches::GearedBranches, 4>(),
    Entry::new::<two_stage::TwoStage, 6>(),
    Entry::new::<idler::Idler, 3>(),
    Entry::new::<belt_drive::BeltDrive, 3>(),
    Entry::new::<planetary_3::Planetary3, 6>(),
    Entry::new::<planetary_4::Planetary4, 7>(),
    Entry::new::<planetary_5::Planetary5, 8>(),
    Entry::new::<planetary_6::Planetary6, 9>(),
    Entry::new::<planetary_7::Planetary7, 10>(),
    Entry::new::<planar_planetary_3::PlanarPlanetary3, 18>(),
    Entry::new::<planar_planetary_4::PlanarPlanetary4, 21>(),
    Entry::new::<planar_planetary_5::PlanarPlanetary5, 24>(),
    Entry::new::<wind_turbine::WindTurbine, 9>(),
    Entry::new::<chain_2::Chain2, 2>(),
    Entry::new::<chain_5::Chain5, 5>(),
    Entry::new::<chain_32::Chain32, 32>(),
];
