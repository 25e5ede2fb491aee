//! Independent reference solutions for the tests of gearsim. They share no code with it.

pub mod oh2005;
pub mod precise;
