//! What the commands of this project share with the programs that they start.

pub mod callgrind;
