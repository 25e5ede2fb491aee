//! Analysis of trajectories after a run, and of the equations without a run.

pub mod advise;
pub mod digits;
pub mod dynamic_factor;
#[cfg(feature = "html")]
pub mod engaged;
pub mod floquet;
pub mod from_teeth;
pub mod modes;
pub mod orders;
pub mod rainflow;
pub mod sound;
pub mod spectrum;
pub mod statistics;
pub mod steady;
pub mod turn;
pub mod work_precision;
