//! The derived models. The files beside this one are written by `cargo derive`; only this list is by hand.

#[rustfmt::skip]
pub mod my_axle;

/// The models of this crate: one line each.
pub static MODELS: &[gearsim::Entry] = &[
    gearsim::Entry::new::<my_axle::MyAxle>(), //
];
