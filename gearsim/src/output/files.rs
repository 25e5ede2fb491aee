//! The output folder of a command. The files of a result are written to a folder of their own inside it, and take the place of an
//! earlier result when all of them are whole ([`super::swap`]). Until then the earlier result is unchanged.

use std::fs::File;
use std::path::{Path, PathBuf};

use tempfile::{Builder, TempDir};

use super::whole::{TEMPORARY, create_folder};
use super::{OutputError, Sink, WholeFiles, fault, swap};

/// Subfolder of the files that were whole when a command failed to write another one.
const PARTIAL: &str = "incomplete";

/// An output folder, and the result that is being written to it.
#[derive(Debug)]
pub struct OutputFolder {
    path: PathBuf,
    staged: WholeFiles,
    /// The folder of the staged files; removed with all in it when dropped.
    staging: Option<TempDir>,
    /// Lock that tells other processes that the staged files are not left over. Held while this process writes.
    _lock: Option<File>,
}

impl OutputFolder {
    /// Opens the folder at `path`; creates it and its parents if missing. Removes what interrupted commands left in it.
    ///
    /// Errors: [`OutputError::NotAFolder`], [`OutputError::CreateFolder`], [`OutputError::Write`].
    pub fn create(path: impl Into<PathBuf>) -> Result<Self, OutputError> {
        let path = path.into();
        if path.exists() && !path.is_dir() {
            return Err(OutputError::NotAFolder { path });
        }
        create_folder(&path)?;
        let failed = |source| OutputError::Write { path: path.clone(), source };
        fault::point().map_err(failed)?;
        // Another process that opens the folder must not find the staging folder before it is locked.
        let _folder = lock(&path, true);
        WholeFiles::create(&path)?.clear_leftovers();
        let _ = std::fs::remove_dir_all(path.join(PARTIAL));
        let staging = staging_in(&path).map_err(failed)?;
        let lock = lock(staging.path(), false);
        let staged = WholeFiles::create(staging.path())?;
        Ok(OutputFolder { path, staged, staging: Some(staging), _lock: lock })
    }

    /// Checks that [`OutputFolder::create`] would succeed and the folder could be written to. Creates nothing that stays.
    ///
    /// Errors: [`OutputError::NotAFolder`], [`OutputError::CreateFolder`], [`OutputError::Write`].
    pub fn probe(path: &Path) -> Result<(), OutputError> {
        WholeFiles::probe(path)
    }

    /// Path of the folder.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Names of the files written, relative to the folder, in the order of writing.
    pub fn files(&self) -> &[String] {
        self.staged.files()
    }

    /// Writes the file `name` of the result with `fill`. It appears in the folder with [`OutputFolder::commit`].
    ///
    /// Errors: those of [`WholeFiles::write`]. If other files of the result are whole, they are kept in the subfolder `incomplete`, and
    /// the error is an [`OutputError::Partial`].
    pub fn write(
        &mut self,
        name: &str,
        fill: impl FnOnce(Sink<'_>) -> Result<(), OutputError>,
    ) -> Result<(), OutputError> {
        let written = self.staged.write(name, fill).map_err(|error| error.moved(self.staged.path(), &self.path));
        written.map_err(|error| self.keep_partial(error))
    }

    /// Writes the file `name` with the given content. Errors: as [`OutputFolder::write`].
    pub fn write_bytes(&mut self, name: &str, content: &[u8]) -> Result<(), OutputError> {
        self.write(name, |sink| Ok(std::io::Write::write_all(sink, content)?))
    }

    /// Puts the files written in the place of an earlier result. `index` is the file of the result that names its other files; it
    /// appears last.
    ///
    /// Errors: [`OutputError::Write`], [`OutputError::Partial`].
    pub fn commit(&mut self, index: &str) -> Result<(), OutputError> {
        let _folder = lock(&self.path, true);
        let swapped = swap::swap(&self.path, self.staged.path(), self.staged.files(), index);
        swapped.map_err(|error| self.keep_partial(error))?;
        self.staging.take();
        Ok(())
    }

    /// Keeps the files that are whole, because what was computed would be lost otherwise.
    fn keep_partial(&mut self, error: OutputError) -> OutputError {
        let to = self.path.join(PARTIAL);
        let kept = match &self.staging {
            Some(staging) if !self.staged.files().is_empty() && fault::point().is_ok() => {
                (!to.exists() || std::fs::remove_dir_all(&to).is_ok()) && std::fs::rename(staging.path(), &to).is_ok()
            }
            _ => false,
        };
        if !kept {
            return error;
        }
        self.staging.take();
        OutputError::Partial { error: Box::new(error), path: to, files: self.files().to_vec() }
    }
}

impl Drop for OutputFolder {
    fn drop(&mut self) {
        // A process that is killed does not clear up.
        if fault::point().is_err() {
            self.staging.take().map(TempDir::keep);
        }
    }
}

/// A temporary folder with the permissions of an ordinary new folder, since it may become the folder of a partial result.
fn staging_in(folder: &Path) -> std::io::Result<TempDir> {
    let mut builder = Builder::new();
    builder.prefix(TEMPORARY);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(std::fs::Permissions::from_mode(0o777));
    }
    builder.tempdir_in(folder)
}

/// Locks a folder until the file is closed; `None` if it is locked, or if the file system has no locks. `wait`: waits for the lock.
pub(super) fn lock(folder: &Path, wait: bool) -> Option<File> {
    let file = File::open(folder).ok()?;
    let locked = if wait { file.lock().is_ok() } else { file.try_lock().is_ok() };
    locked.then_some(file)
}

#[cfg(test)]
mod tests;
