//! Compensated precision, in which state and time have 32 digits, against closed forms and against sums in 50 digits.

mod common;

#[path = "compensated/coupled.rs"]
mod coupled;
#[path = "compensated/digits.rs"]
mod digits;
#[path = "compensated/energy.rs"]
mod energy;
#[path = "compensated/forced.rs"]
mod forced;
#[path = "compensated/friction.rs"]
mod friction;
#[path = "compensated/play.rs"]
mod play;
#[path = "compensated/scenes.rs"]
mod scenes;
