//! A second engine with 50 and more digits and its own search for the first crossing. Engines in `f64` are compared with it.
//!
//! Cells are linear and have any number of modes: underdamped, critically damped, overdamped or without stiffness. A number is an
//! integer of dashu with an exponent ([`number`]). The motion of a mode is in [`cell`], the first crossing in [`crossing`], any linear
//! cell by its matrix exponential in [`exponential`]. The gear pair of Oh, Grosh & Barber is built on these in [`mod@scene`].

pub mod cell;
pub mod crossing;
mod elementary;
pub mod exponential;
mod judge;
pub mod number;
#[cfg(test)]
mod number_tests;
pub mod refine;
mod rough;
#[cfg(test)]
mod rough_tests;
pub mod scene;
#[cfg(test)]
mod scene_tests;
#[cfg(test)]
mod tests;

pub use cell::Mode;
pub use crossing::{Root, first_crossing};
pub use scene::{Run, scene};
