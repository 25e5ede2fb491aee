//! Independent references for gearsim: what its results are compared with, sharing none of its code.

pub mod oh2005;
pub mod precise;
