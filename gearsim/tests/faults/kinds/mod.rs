//! The kinds of faults.

mod calls;
pub mod disk;
mod file_size;
mod killed;
mod memory;
mod stdout;

use crate::fault::Fault;
use crate::prepared::Prepared;

/// The faults of one kind for a command.
type Kind = fn(&Prepared) -> Vec<Fault>;

/// All kinds, by the names of their columns.
pub const KINDS: &[(&str, Kind)] = &[
    ("killed", killed::faults),
    ("file size", file_size::faults),
    ("disk full", disk::faults),
    ("stdout", stdout::faults),
    ("memory", memory::faults),
    ("calls fail", calls::failing),
    ("killed at call", calls::killed),
];
