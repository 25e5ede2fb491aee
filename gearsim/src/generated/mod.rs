//! The derived models. Every file beside this one is written by `cargo xtask derive`; only this list is written by hand.

#[rustfmt::skip]
pub mod gear_pair;
