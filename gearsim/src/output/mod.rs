//! The files that a run writes: a folder with its trajectory, its summary and its plots.
//!
//! [`table::Table`] is a table of columns with units, e.g. of a trajectory. [`parquet`] and [`csv`] write it, [`summary`] defines
//! `summary.json`. [`OutputFolder`] writes a result completely or not at all, [`WholeFiles`] single files.

mod checksum;
pub mod csv;
pub mod document;
mod error;
pub(crate) mod fault;
mod files;
pub mod lines;
pub mod load_spectrum;
pub(crate) mod marker;
pub(crate) mod number;
pub mod parquet;
pub(crate) mod staging;
pub mod summary;
mod swap;
pub mod table;
pub mod wav;
mod whole;

pub use error::OutputError;
pub use files::OutputFolder;
pub use marker::MARKER;
pub use summary::Summary;
pub use swap::{PAGE, belongs};
pub use table::Table;
pub use whole::{Sink, WholeFiles};

#[cfg(test)]
pub(crate) mod fixture;
