//! Independent reference solutions for the tests of gearsim, and drivetrains that are stated in two ways. This crate shares no code with
//! gearsim.

pub mod oh2005;
pub mod precise;
pub mod trains;
