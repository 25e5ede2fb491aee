//! What is computed from a recording after the run, and from the equations without one.

pub mod advise;
pub mod digits;
pub mod floquet;
pub mod modes;
pub mod spectrum;
pub mod steady;
pub mod work_precision;
