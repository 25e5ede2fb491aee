//! Tests of scene files: the meaning of their keys, and the messages for mistakes.

mod fixture;
mod friction;
mod gear_data;
mod hostile;
mod mistakes;
mod parts;
mod quantities;
mod scenes;
mod spectrum;
mod teeth;
mod trains;
mod transmission_error;
