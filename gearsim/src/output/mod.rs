//! What a run leaves behind: a folder with its trajectory, its summary and its plots.
//!
//! [`table::Table`] is the trajectory as columns with units; [`parquet`] and [`csv`] write it, [`summary`] is
//! `summary.json`, and [`files::OutputFolder`] puts each file in place whole or not at all.

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
