//! What is computed from a recording after the run.

pub mod spectrum;
pub mod work_precision;
