//! Analysis of trajectories after a run, and of the equations without a run.

pub(crate) mod absurd;
pub(crate) mod advise;
pub(crate) mod digits;
pub mod dynamic_factor;
#[cfg(feature = "html")]
pub(crate) mod engaged;
pub mod floquet;
pub(crate) mod from_teeth;
pub mod modes;
pub mod orders;
pub(crate) mod pulling;
pub mod rainflow;
pub(crate) mod sampling;
pub mod sound;
pub mod spectrum;
pub mod statistics;
pub(crate) mod steady;
pub(crate) mod turn;
pub(crate) mod work_precision;
