//! A folder whose files are whole: a file has its name only once it is complete and on the disk.

use std::io::{self, BufWriter, Write};
use std::path::{Component, Path, PathBuf};

use tempfile::{Builder, NamedTempFile};

use super::{OutputError, fault, staging};

/// The buffered writer that a file is written to; it gets its final name later.
pub type Sink<'a> = &'a mut (dyn Write + Send);

/// Beginning of the names of temporary files and folders.
pub(super) const TEMPORARY: &str = ".gearsim-";

/// A folder and the files written to it so far. Each file appears under its name as soon as it is complete. Other files stay.
#[derive(Debug)]
pub struct WholeFiles {
    path: PathBuf,
    files: Vec<String>,
}

impl WholeFiles {
    /// Opens the folder at `path`; creates it and its parents if missing.
    ///
    /// Errors: [`OutputError::NotAFolder`], [`OutputError::CreateFolder`].
    pub fn create(path: impl Into<PathBuf>) -> Result<Self, OutputError> {
        let path = path.into();
        if path.exists() && !path.is_dir() {
            return Err(OutputError::NotAFolder { path });
        }
        create_folder(&path)?;
        Ok(WholeFiles { path, files: vec![] })
    }

    /// Checks that [`WholeFiles::create`] would succeed and the folder could be written to. Creates nothing that stays.
    ///
    /// Errors: [`OutputError::NotAFolder`], [`OutputError::CreateFolder`], [`OutputError::Write`].
    pub fn probe(path: &Path) -> Result<(), OutputError> {
        if path.is_dir() {
            let unwritable = |source| OutputError::Write { path: path.to_owned(), source };
            return tempfile::tempfile_in(path).map(drop).map_err(unwritable);
        }
        if path.exists() {
            return Err(OutputError::NotAFolder { path: path.to_owned() });
        }
        // The new folder will be created in its nearest existing ancestor.
        let above = path.ancestors().skip(1).find(|above| above.exists());
        let above = above.filter(|above| !above.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let cannot = |source| OutputError::CreateFolder { path: path.to_owned(), source };
        tempfile::tempfile_in(above).map(drop).map_err(cannot)
    }

    /// Path of the folder.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Names of the files written, relative to the folder, in the order of writing.
    pub fn files(&self) -> &[String] {
        &self.files
    }

    /// Removes the temporary files and folders of commands that were interrupted. Those of a running process are locked. What cannot
    /// be removed stays until the next time.
    pub fn clear_leftovers(&self) {
        staging::clear(&self.path);
        for entry in std::fs::read_dir(&self.path).into_iter().flatten().flatten() {
            if entry.file_name().to_string_lossy().starts_with(TEMPORARY) {
                // This fails for a folder, which `staging::clear` has already handled.
                let _ = std::fs::remove_file(entry.path());
            }
        }
    }

    /// Writes the file `name` with `fill`; the name may contain a subfolder: `plots/energy.svg`.
    ///
    /// `fill` writes to a temporary file in the same folder. It gets the final name only when it is complete and on the disk. If
    /// anything fails, an older file of that name is unchanged.
    ///
    /// Errors: those of `fill`; [`OutputError::BadName`], [`OutputError::CreateFolder`], [`OutputError::Write`].
    pub fn write(
        &mut self,
        name: &str,
        fill: impl FnOnce(Sink<'_>) -> Result<(), OutputError>,
    ) -> Result<(), OutputError> {
        let path = self.resolve(name)?;
        let folder = path.parent().unwrap_or(&self.path);
        create_folder(folder)?;
        let failed = |source: io::Error| OutputError::Write { path: path.clone(), source };

        fault::point().map_err(failed)?;
        let mut sink = BufWriter::new(fault::Faulty(temporary_in(folder).map_err(failed)?));
        fill(&mut sink).map_err(|e| e.at(&path))?;
        let file = sink.into_inner().map_err(|e| failed(e.into_error()))?.0;
        fault::point().map_err(failed)?;
        // Without this, a crash of the machine may leave an empty file under the final name.
        file.as_file().sync_all().map_err(failed)?;
        fault::point().map_err(failed)?;
        file.persist(&path).map_err(|e| failed(e.error))?;

        if !self.files.iter().any(|f| f == name) {
            self.files.push(name.to_owned());
        }
        Ok(())
    }

    /// Writes the file `name` with the given content. Errors: as [`WholeFiles::write`].
    pub fn write_bytes(&mut self, name: &str, content: &[u8]) -> Result<(), OutputError> {
        self.write(name, |sink| Ok(sink.write_all(content)?))
    }

    /// The full path of `name`, which must stay inside the folder.
    fn resolve(&self, name: &str) -> Result<PathBuf, OutputError> {
        match is_inside(name) {
            true => Ok(self.path.join(name)),
            false => Err(OutputError::BadName { name: name.to_owned() }),
        }
    }
}

/// Whether `name` is the name of a file inside a folder.
pub(super) fn is_inside(name: &str) -> bool {
    !name.is_empty() && Path::new(name).components().all(|c| matches!(c, Component::Normal(_)))
}

pub(super) fn create_folder(path: &Path) -> Result<(), OutputError> {
    std::fs::create_dir_all(path).map_err(|source| OutputError::CreateFolder { path: path.to_owned(), source })
}

/// A temporary file whose permissions are those of an ordinary new file (0666 less the umask), since it becomes the final file.
fn temporary_in(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = Builder::new();
    builder.prefix(TEMPORARY);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    builder.tempfile_in(folder)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let mut names: Vec<_> =
            std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn files_are_written_and_listed_once() {
        let root = tempfile::tempdir().unwrap();
        let mut folder = WholeFiles::create(root.path().join("a/b")).unwrap();
        folder.write_bytes("plots/energy.svg", b"<svg/>").unwrap();
        folder.write_bytes("summary.json", b"1").unwrap();
        folder.write_bytes("summary.json", b"2").unwrap();
        assert_eq!(folder.files(), ["plots/energy.svg", "summary.json"]);
        assert_eq!(std::fs::read(folder.path().join("summary.json")).unwrap(), b"2");
        assert_eq!(names(folder.path()), ["plots", "summary.json"]);
    }

    #[test]
    fn a_failing_writer_leaves_no_file_and_keeps_an_older_one() {
        let root = tempfile::tempdir().unwrap();
        let mut folder = WholeFiles::create(root.path()).unwrap();
        let fail = |sink: Sink<'_>| {
            sink.write_all(b"half")?;
            Err(OutputError::format("CSV", "stopped"))
        };
        assert!(folder.write("trajectory.csv", fail).is_err());
        assert!(names(root.path()).is_empty());
        assert!(folder.files().is_empty());

        folder.write_bytes("trajectory.csv", b"whole").unwrap();
        assert!(folder.write("trajectory.csv", fail).is_err());
        assert_eq!(std::fs::read(root.path().join("trajectory.csv")).unwrap(), b"whole");
        assert_eq!(names(root.path()), ["trajectory.csv"]);
    }

    #[test]
    fn names_outside_the_folder_are_refused() {
        let root = tempfile::tempdir().unwrap();
        let mut folder = WholeFiles::create(root.path()).unwrap();
        for name in ["", "../x", "/etc/x", "a/../../x"] {
            assert!(matches!(folder.write_bytes(name, b""), Err(OutputError::BadName { .. })), "{name}");
        }
    }

    #[test]
    fn errors_of_folders_suggest_another_one() {
        let root = tempfile::tempdir().unwrap();
        let file = root.path().join("file");
        std::fs::write(&file, "").unwrap();
        let at = WholeFiles::create(&file).unwrap_err().to_string();
        assert!(at.contains("it is a file; choose another"), "{at}");
        let below = WholeFiles::create(file.join("deeper")).unwrap_err().to_string();
        assert!(below.starts_with("cannot create folder") && below.contains("choose another"), "{below}");
    }
}
