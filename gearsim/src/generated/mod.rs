//! The derived models. Every file beside this one is written by `cargo xtask derive`; only this list is by hand.

use crate::engine::Entry;

#[rustfmt::skip]
pub mod gear_pair;

/// Every model the program knows: one line each, with its number of coordinates.
pub const MODELS: &[Entry] = &[
    Entry::new::<gear_pair::GearPair, 2>(), //
];
