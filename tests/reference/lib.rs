//! Independent reference solutions for the tests of gearsim, and drivetrains that are stated in two ways. They share no code with it.

pub mod oh2005;
pub mod precise;
pub mod trains;
