//! The files that a run writes: a folder with its trajectory, its summary and its plots.
//!
//! [`table::Table`] is a table of columns with units, e.g. of a trajectory. [`parquet`] and [`csv`] write it, [`summary`] defines
//! `summary.json`. A result is written completely or not at all.

mod checksum;
pub mod csv;
pub(crate) mod document;
mod error;
pub(crate) mod fault;
mod files;
pub(crate) mod lines;
pub(crate) mod load_spectrum;
pub(crate) mod marker;
pub(crate) mod number;
pub mod parquet;
pub(crate) mod remarks;
pub(crate) mod staging;
pub mod summary;
mod swap;
pub mod table;
pub(crate) mod unit;
pub(crate) mod wav;
mod whole;

pub use error::OutputError;
pub(crate) use files::OutputFolder;
pub use summary::Summary;
pub(crate) use swap::PAGE;
#[cfg(any(test, feature = "html"))]
pub(crate) use swap::belongs;
pub use table::Table;
pub use whole::Sink;
pub(crate) use whole::WholeFiles;

#[cfg(test)]
pub(crate) mod conforms;
#[cfg(test)]
pub(crate) mod fixture;
