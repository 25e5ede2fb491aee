//! What can go wrong when results are written, in words that say what to do.

use std::io;
use std::path::{Path, PathBuf};

/// Why an output could not be written or read.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// A folder could not be created.
    #[error("cannot create folder {path}: {}", reason(source))]
    CreateFolder {
        /// The folder.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// Something that is not a folder stands where the folder should be.
    #[error("cannot use {path} as an output folder: it is a file; choose another with --out")]
    NotAFolder {
        /// The path in question.
        path: PathBuf,
    },
    /// A file could not be written.
    #[error("cannot write {path}: {}", reason(source))]
    Write {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// A file could not be read.
    #[error("cannot read {path}: {why}")]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        why: String,
    },
    /// A file name would leave the output folder.
    #[error("`{name}` is not a file name inside the output folder")]
    BadName {
        /// The name.
        name: String,
    },
    /// The columns of a table have different lengths.
    #[error("column `{column}` has {rows} rows, the table has {expected}")]
    Ragged {
        /// The column that differs.
        column: String,
        /// Its rows.
        rows: usize,
        /// The rows of the columns before it.
        expected: usize,
    },
    /// The data could not be brought into the file format.
    #[error("cannot write {format}: {why}")]
    Format {
        /// The format, e.g. `Parquet`.
        format: &'static str,
        /// Why.
        why: String,
    },
    /// The sink given to a writer failed.
    #[error(transparent)]
    Sink(#[from] io::Error),
}

impl OutputError {
    /// A [`OutputError::Format`] with `why` in words.
    pub(crate) fn format(format: &'static str, why: impl std::fmt::Display) -> Self {
        OutputError::Format { format, why: why.to_string() }
    }

    /// Names `path` in an error of a sink; leaves other errors as they are.
    pub(crate) fn at(self, path: &Path) -> Self {
        match self {
            OutputError::Sink(source) => OutputError::Write { path: path.to_owned(), source },
            other => other,
        }
    }
}

/// The system's reason, and what the reader can do about it.
fn reason(error: &io::Error) -> String {
    use io::ErrorKind::*;
    match error.kind() {
        PermissionDenied => "permission denied; choose another folder with --out".into(),
        ReadOnlyFilesystem => "the file system is read-only; choose another folder with --out".into(),
        NotADirectory | AlreadyExists => "a part of the path is a file, not a folder; choose another with --out".into(),
        StorageFull | QuotaExceeded => {
            "no space left; free some, record at a lower rate, or choose another folder with --out".into()
        }
        InvalidFilename => "the name is not valid here; choose another with --out".into(),
        _ => error.to_string(),
    }
}
