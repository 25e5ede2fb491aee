//! The engine.

pub mod equations;
