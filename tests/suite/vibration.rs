//! Modes, damping that couples them, and the stability of steady rotation: against published numbers, closed forms and the
//! matrix exponential in 50 digits.

#[path = "vibration/apart.rs"]
mod apart;
mod common;
#[path = "vibration/damped.rs"]
mod damped;
#[path = "vibration/frequencies.rs"]
mod frequencies;
#[path = "vibration/models.rs"]
mod models;
#[path = "vibration/stability.rs"]
mod stability;

// Where the expansion of the model finds the engine, as it does within gearsim.
use gearsim::{engine, model};
