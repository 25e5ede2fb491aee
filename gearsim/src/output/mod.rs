//! The files that a run writes: a folder with its trajectory, its summary and its plots.
//!
//! [`table::Table`] is a table of columns with units, e.g. of a trajectory. [`parquet`] and [`csv`] write it, [`summary`] defines
//! `summary.json`, and [`files::OutputFolder`] writes every file completely or not at all.

pub mod csv;
mod error;
pub mod files;
pub mod parquet;
pub mod summary;
pub mod table;

pub use error::OutputError;
pub use files::OutputFolder;
pub use summary::Summary;
pub use table::Table;

#[cfg(test)]
pub(crate) mod fixture;
