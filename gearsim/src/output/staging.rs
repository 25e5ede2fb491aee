//! A temporary folder in the folder of a result, in which files wait until all of them are whole.

use std::fs::File;
use std::io;
use std::path::Path;

use tempfile::{Builder, TempDir};

use super::fault;
use super::whole::TEMPORARY;

/// A temporary folder; removed with all in it when dropped. It is locked, so that other processes do not remove it as a leftover.
#[derive(Debug)]
pub(crate) struct Staging {
    folder: TempDir,
    _lock: Option<File>,
}

impl Staging {
    /// Creates a temporary folder in `folder`, and removes those that interrupted commands left there.
    ///
    /// Errors: those of creating it.
    pub(crate) fn create(folder: &Path) -> io::Result<Self> {
        // Another process that clears the folder must not find the new one before it is locked.
        let _folder = lock(folder, true);
        clear(folder);
        // The permissions of an ordinary new folder, since it may become the folder of a partial result.
        let mut builder = Builder::new();
        builder.prefix(TEMPORARY);
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            builder.permissions(std::fs::Permissions::from_mode(0o777));
        }
        let folder = builder.tempdir_in(folder)?;
        let lock = lock(folder.path(), false);
        Ok(Staging { folder, _lock: lock })
    }

    /// Path of the folder.
    pub(crate) fn path(&self) -> &Path {
        self.folder.path()
    }

    /// Gives the folder the name `to`, so that it stays.
    ///
    /// Errors: those of renaming it.
    pub(crate) fn rename(mut self, to: &Path) -> io::Result<()> {
        std::fs::rename(self.path(), to)?;
        self.folder.disable_cleanup(true);
        Ok(())
    }
}

impl Drop for Staging {
    fn drop(&mut self) {
        // A process that is killed does not clear up.
        if fault::point().is_err() {
            self.folder.disable_cleanup(true);
        }
    }
}

/// Removes the temporary folders of commands that were interrupted. Those of a running process are locked. What cannot be removed
/// stays until the next time.
pub(super) fn clear(folder: &Path) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let (name, path) = (entry.file_name(), entry.path());
        let ours = name.to_string_lossy().starts_with(TEMPORARY) && path.is_dir();
        if ours && lock(&path, false).is_some() {
            let _ = std::fs::remove_dir_all(&path);
        }
    }
}

/// Locks a folder until the file is closed; `None` if it is locked, or if the file system has no locks. `wait`: waits for the lock.
pub(super) fn lock(folder: &Path, wait: bool) -> Option<File> {
    let file = File::open(folder).ok()?;
    let locked = if wait { file.lock().is_ok() } else { file.try_lock().is_ok() };
    locked.then_some(file)
}
