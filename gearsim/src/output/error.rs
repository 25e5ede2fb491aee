//! The errors of writing and reading results. The messages say what to do.

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
        /// The error of the operating system.
        source: io::Error,
    },
    /// The path of the folder is that of a file.
    #[error("cannot use {path} as an output folder: it is a file; choose another")]
    NotAFolder {
        /// The path.
        path: PathBuf,
    },
    /// A file could not be written.
    #[error("cannot write {path}: {}", reason(source))]
    Write {
        /// The file.
        path: PathBuf,
        /// The error of the operating system.
        source: io::Error,
    },
    /// A result could not be written completely.
    #[error("{error}\n  written before, and kept in {}: {}", path.display(), files.join(", "))]
    Partial {
        /// Why.
        error: Box<OutputError>,
        /// The folder of the files that are whole.
        path: PathBuf,
        /// Their names.
        files: Vec<String>,
    },
    /// A file could not be read.
    #[error("cannot read {path}: {why}")]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        why: String,
    },
    /// A file name that is empty or leads out of the output folder.
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
        /// Its number of rows.
        rows: usize,
        /// The number of rows of the columns before it.
        expected: usize,
    },
    /// The data cannot be written in the file format.
    #[error("cannot write {format}: {why}")]
    Format {
        /// The format, e.g. `Parquet`.
        format: &'static str,
        /// Why.
        why: String,
    },
    /// Writing to a sink failed, before the path of the file is known.
    #[error(transparent)]
    Sink(#[from] io::Error),
}

impl OutputError {
    /// A [`OutputError::Format`] with `why` in words.
    pub(crate) fn format(format: &'static str, why: impl std::fmt::Display) -> Self {
        OutputError::Format { format, why: why.to_string() }
    }

    /// The error for a reader who knows the folder `to`, but not the temporary folder `from` in it.
    pub(crate) fn moved(self, from: &Path, to: &Path) -> Self {
        let moved = |path: PathBuf| path.strip_prefix(from).map(|name| to.join(name)).unwrap_or(path);
        match self {
            OutputError::Write { path, source } => OutputError::Write { path: moved(path), source },
            OutputError::CreateFolder { path, source } => OutputError::CreateFolder { path: moved(path), source },
            other => other,
        }
    }

    /// Adds `path` to an error of a sink; other errors are returned unchanged.
    pub(crate) fn at(self, path: &Path) -> Self {
        match self {
            OutputError::Sink(source) => OutputError::Write { path: path.to_owned(), source },
            other => other,
        }
    }
}

/// The reason given by the operating system, and what to do.
fn reason(error: &io::Error) -> String {
    use io::ErrorKind::*;
    match error.kind() {
        PermissionDenied => "permission denied; choose another folder".into(),
        ReadOnlyFilesystem => "the file system is read-only; choose another folder".into(),
        NotADirectory | AlreadyExists => "a part of the path is a file, not a folder; choose another".into(),
        StorageFull | QuotaExceeded => {
            "no space left; free some, record at a lower rate, or choose another folder".into()
        }
        FileTooLarge => {
            "it would be larger than a file may be here (`ulimit -f`, or the file system); record at a lower rate, or \
                         choose another folder"
                .into()
        }
        InvalidFilename => "the name is not valid here; choose another".into(),
        _ => error.to_string(),
    }
}
