//! Tests of scene files: what they mean, and what is said of mistakes in them.

mod errors;
mod fixture;
mod friction;
mod mistakes;
mod quantities;
mod scenes;
mod teeth;
