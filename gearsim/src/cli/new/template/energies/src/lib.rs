//! The drivetrains of this crate. How to write one: the documentation of `gearsim_models`.

mod my_axle;

/// All models: one line each.
pub const MODELS: &[gearsim_derive::Entry] = &[
    ("my_axle", my_axle::my_axle), //
];

/// Where they are, for the heads of the derived files.
pub const HOME: gearsim_derive::Home<'_> = gearsim_derive::Home { energies: "energies/src", command: "cargo derive" };
