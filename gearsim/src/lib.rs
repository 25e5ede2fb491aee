//! gearsim: energy-conserving simulation of gear systems.

pub mod analysis;
pub mod engine;
pub mod generated;
pub mod model;
pub mod output;
pub mod plot;
pub mod scene;
pub mod trajectory;
