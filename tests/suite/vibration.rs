//! Modes, damping that couples modes, and the stability of steady rotation: compared with published numbers, with closed forms and
//! with the matrix exponential in 50 digits.

#[path = "vibration/apart.rs"]
mod apart;
mod common;
#[path = "vibration/curves.rs"]
mod curves;
#[path = "vibration/damped.rs"]
mod damped;
#[path = "vibration/frequencies.rs"]
mod frequencies;
#[path = "vibration/models.rs"]
mod models;
#[path = "vibration/stability.rs"]
mod stability;
