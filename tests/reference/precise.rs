//! A second engine in 50 and more digits, with its own way to the first crossing: what `f64` engines are compared with.
//!
//! Cells are linear, of any number of modes, under-, critically and overdamped or without stiffness. Numbers are
//! dashu's integers with an exponent ([`number`]), the motion of a mode is in [`cell`], the first crossing in
//! [`crossing`], any linear cell by its matrix exponential in [`exponential`], the gear pair of Oh, Grosh & Barber on top of them in [`mod@scene`].

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
