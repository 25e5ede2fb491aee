//! The file that says that a folder is incomplete.

use std::fs;
use std::io;
use std::path::Path;

use super::{OutputError, WholeFiles, fault};

/// Name of the file.
pub const MARKER: &str = "INCOMPLETE";

/// Marks the folder at `path` as incomplete, with `text`, unless it has a marker already.
///
/// Errors: [`OutputError::CreateFolder`], [`OutputError::Write`].
pub(crate) fn mark(path: &Path, text: &str) -> Result<(), OutputError> {
    if path.join(MARKER).exists() { Ok(()) } else { write(path, text) }
}

/// Removes what [`mark`] wrote with the same `text`.
///
/// Errors: [`OutputError::Write`].
pub(crate) fn unmark(path: &Path, text: &str) -> Result<(), OutputError> {
    let marked = read(path).is_some_and(|there| there == text);
    if marked { remove(&path.join(MARKER)) } else { Ok(()) }
}

/// The text of the marker in the folder at `path`; `None` if the folder has none.
pub(super) fn read(path: &Path) -> Option<String> {
    fs::read_to_string(path.join(MARKER)).ok()
}

/// Writes the marker with `text`, in the place of another one.
///
/// Errors: [`OutputError::CreateFolder`], [`OutputError::Write`].
pub(super) fn write(path: &Path, text: &str) -> Result<(), OutputError> {
    // If this write is interrupted, its temporary file is removed with other leftovers.
    WholeFiles::create(path)?.write_bytes(MARKER, text.as_bytes())
}

/// Removes a file, if it is there.
///
/// Errors: [`OutputError::Write`].
pub(crate) fn remove(path: &Path) -> Result<(), OutputError> {
    match fault::point().and_then(|()| fs::remove_file(path)) {
        Err(source) if source.kind() != io::ErrorKind::NotFound => {
            Err(OutputError::Write { path: path.to_owned(), source })
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_removes_its_own_marker_only() {
        let root = tempfile::tempdir().unwrap();
        mark(root.path(), "of a run\n").unwrap();
        mark(root.path(), "of a sweep\n").unwrap();
        unmark(root.path(), "of a sweep\n").unwrap();
        assert_eq!(read(root.path()).as_deref(), Some("of a run\n"));
        unmark(root.path(), "of a run\n").unwrap();
        assert_eq!(read(root.path()), None);
    }
}
