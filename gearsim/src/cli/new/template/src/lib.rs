//! The models of this crate, for its program and its tests.

pub mod generated;
