//! Functions that the commands of xtask and the programs in `chores` both use.

pub mod callgrind;
