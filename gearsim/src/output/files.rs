//! The output folder of a command. The files of a result are written to a folder of their own inside it, and take the place of an
//! earlier result when all of them are whole ([`super::swap`]). Until then the earlier result is unchanged.

use std::path::{Path, PathBuf};

use super::staging::{Staging, lock};
use super::whole::create_folder;
use super::{OutputError, Sink, WholeFiles, fault, swap};

/// Subfolder of the files that were whole when a command failed to write another one.
const PARTIAL: &str = "incomplete";

/// An output folder, and the result that is being written to it.
#[derive(Debug)]
pub struct OutputFolder {
    path: PathBuf,
    staged: WholeFiles,
    /// The folder of the staged files; removed with all in it when dropped.
    staging: Option<Staging>,
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
        clear(&path)?;
        let staging = Staging::create(&path).map_err(failed)?;
        let staged = WholeFiles::create(staging.path())?;
        Ok(OutputFolder { path, staged, staging: Some(staging) })
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
        let Some(staging) = self.staging.take() else { return error };
        // Files that were moved to their places before the error are in the folder itself.
        let is_staged = |name: &&String| staging.path().join(name).exists();
        let files: Vec<_> = self.files().iter().filter(is_staged).cloned().collect();
        let replaced = !to.exists() || std::fs::remove_dir_all(&to).is_ok();
        if files.is_empty() || fault::point().is_err() || !replaced || staging.rename(&to).is_err() {
            return error;
        }
        OutputError::Partial { error: Box::new(error), path: to, files }
    }
}

/// Removes from the folder at `path` what interrupted commands and failed writes left.
fn clear(path: &Path) -> Result<(), OutputError> {
    // The lock waits for a process that is replacing a result: its temporary file must not be removed.
    let _folder = lock(path, true);
    WholeFiles::create(path)?.clear_leftovers();
    let _ = std::fs::remove_dir_all(path.join(PARTIAL));
    Ok(())
}

#[cfg(test)]
mod tests;
