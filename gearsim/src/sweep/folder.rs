//! The folder of a sweep. `sweep.json` is the manifest. While the sweep runs, `parts/` holds the rows finished so far; a file is
//! complete or absent. At the end, `sweep.parquet` holds all rows in the order of their points, and `parts/` is removed. Until the
//! results are evaluated, the folder says that it is incomplete ([`begin`], [`end`]).
//!
//! A part may hold any points. After an interruption only the points that are in no file run again.

use std::collections::BTreeMap;
use std::fs::File;
use std::path::{Path, PathBuf};

use super::manifest::{self, Layout, Manifest};
use super::row::{self, Row};
use super::{Error, impossible, spectra};
use crate::output::{OutputError, Table, WholeFiles, marker, parquet};

/// File of the rows, in the order of their points.
pub const ROWS: &str = "sweep.parquet";
/// File of the spectra, if they are stored, in the same order.
pub const SPECTRA: &str = "spectra.parquet";
/// Subfolder of the rows of a sweep that is not finished.
const PARTS: &str = "parts";
/// Metadata key of the manifest in every Parquet file.
const PROVENANCE: &str = "sweep";

/// Text of the marker of the folder while it is incomplete.
const UNFINISHED: &str = "\
gearsim sweep or merge writes to this folder, or was interrupted.
Every file is whole, but some may be missing or belong to an earlier command.
The same command run again completes the results. A sweep runs only the points that are missing.
";

/// Rows by point number.
pub type Rows = BTreeMap<usize, Row>;

/// The folder of a running sweep.
pub struct Folder {
    path: PathBuf,
    parts: WholeFiles,
    manifest: Manifest,
    layout: Layout,
    /// File lock, held while this process writes to the folder.
    _lock: File,
}

impl Folder {
    /// Opens the folder at `path` for the sweep of `manifest`. The folder is new, or holds finished points of the same sweep.
    ///
    /// # Errors
    /// If the folder holds another sweep, if another process writes to it, or if it cannot be written to.
    pub fn open(path: &Path, manifest: Manifest, layout: Layout) -> Result<Self, Error> {
        refuse_another(path, &manifest)?;
        let mut folder = WholeFiles::create(path)?;
        let parts = WholeFiles::create(path.join(PARTS))?;
        let lock = path.join(PARTS).join("lock");
        let unwritable = |source| OutputError::Write { path: lock.clone(), source };
        let file = File::create(&lock).map_err(unwritable)?;
        match file.try_lock() {
            Ok(()) => {}
            Err(std::fs::TryLockError::WouldBlock) => {
                let what = format!("another gearsim process writes to {}", path.display());
                return impossible(what, "wait until it ends, or choose another folder: one per shard");
            }
            // The file system does not support locks: run without one.
            Err(std::fs::TryLockError::Error(_)) => {}
        }
        parts.clear_leftovers();
        folder.clear_leftovers();
        begin(path)?;
        folder.write_bytes(manifest::FILE, manifest.json()?.as_bytes())?;
        Ok(Folder { path: path.to_owned(), parts, manifest, layout, _lock: file })
    }

    /// Path of the folder.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The rows finished so far.
    ///
    /// # Errors
    /// [`OutputError::Read`].
    pub fn rows(&self) -> Result<Rows, OutputError> {
        rows(&self.path, &self.manifest, &self.layout)
    }

    /// Writes rows to a new part.
    ///
    /// # Errors
    /// Those of writing the files.
    pub fn keep(&mut self, rows: &[Row]) -> Result<(), OutputError> {
        let rows = in_order(rows);
        let Some(first) = rows.first() else { return Ok(()) };
        let names = (&*part("rows", first.point), &*part("spectra", first.point));
        write(&mut self.parts, names, &self.manifest, &self.layout, &rows).map(drop)
    }

    /// Writes a part from the bytes of its file, which [`table_in_bytes`] has made; `first` is its first point.
    ///
    /// # Errors
    /// Those of writing the file.
    pub fn keep_bytes(&mut self, first: usize, bytes: &[u8]) -> Result<(), OutputError> {
        self.parts.write_bytes(&part("rows", first), bytes)
    }

    /// The manifest of the sweep.
    pub fn manifest(&self) -> &Manifest {
        &self.manifest
    }

    /// Joins the parts to one file and removes them; returns the rows, and their table. The folder says that it is incomplete until [`end`].
    ///
    /// # Errors
    /// Those of reading and writing the files. The parts are kept then.
    pub fn finish(self) -> Result<(Rows, Table), OutputError> {
        let rows = self.rows()?;
        let mut folder = WholeFiles::create(&self.path)?;
        let ordered: Vec<&Row> = rows.values().collect();
        let table = write(&mut folder, (ROWS, SPECTRA), &self.manifest, &self.layout, &ordered)?;
        let parts = self.path.join(PARTS);
        std::fs::remove_dir_all(&parts).map_err(|source| OutputError::Write { path: parts, source })?;
        Ok((rows, table))
    }
}

/// Rows in the order of their points.
pub fn in_order(rows: &[Row]) -> Vec<&Row> {
    let mut rows: Vec<&Row> = rows.iter().collect();
    rows.sort_by_key(|row| row.point);
    rows
}

/// Name of the file of the part whose first point is `first`. No other part has this point, so that the name is free.
fn part(prefix: &str, first: usize) -> String {
    format!("{prefix}-{first:08}.parquet")
}

/// Marks the folder at `path` as incomplete.
///
/// # Errors
/// [`OutputError::Write`].
pub fn begin(path: &Path) -> Result<(), OutputError> {
    marker::mark(path, UNFINISHED)
}

/// Removes the marker that the folder at `path` is incomplete, when its rows are written and evaluated.
///
/// # Errors
/// [`OutputError::Write`].
pub fn end(path: &Path) -> Result<(), OutputError> {
    marker::unmark(path, UNFINISHED)
}

/// Checks that the folder at `path` does not hold another sweep than that of `manifest`.
///
/// # Errors
/// [`Error::Impossible`] if it does, and [`OutputError::Read`] if its manifest cannot be read.
pub fn refuse_another(path: &Path, manifest: &Manifest) -> Result<(), Error> {
    let Some(other) = Manifest::read(path)? else { return Ok(()) };
    let differences = manifest.differences(&other);
    if differences.is_empty() {
        return Ok(());
    }
    let what = format!("{} holds another sweep\n  {}", path.display(), differences.join("\n  "));
    impossible(what, "choose another folder, or remove this one")
}

/// The rows of the sweep of `manifest` in the folder at `path`, with those in `parts/`.
///
/// # Errors
/// [`OutputError::Read`].
pub fn rows(path: &Path, manifest: &Manifest, layout: &Layout) -> Result<Rows, OutputError> {
    let parts = names(&path.join(PARTS));
    let of = |prefix: &str, whole: &str| {
        let parts = parts.iter().filter(|name| name.starts_with(prefix)).map(|name| path.join(PARTS).join(name));
        let files = [path.join(whole)].into_iter().chain(parts).filter(|file| file.exists());
        files.collect::<Vec<_>>()
    };
    let broken =
        |file: &Path| OutputError::Read { path: file.to_owned(), why: "remove it: its points run again".into() };

    let mut all = Rows::new();
    for file in of("rows-", ROWS) {
        if let Some(table) = read(&file, manifest)? {
            let rows = row::read(&table, &layout.columns).ok_or_else(|| broken(&file))?;
            all.extend(rows.into_iter().filter(|row| row.point < manifest.points).map(|row| (row.point, row)));
        }
    }
    for file in of("spectra-", SPECTRA) {
        if let Some(table) = read(&file, manifest)? {
            for (point, spectrum) in spectra::read(&table).ok_or_else(|| broken(&file))? {
                // The same spectrum may be both in a part and in the joined file.
                if let Some(row) = all.get_mut(&point)
                    && row.spectra.iter().all(|other| other.coordinate != spectrum.coordinate)
                {
                    row.spectra.push(spectrum);
                }
            }
        }
    }
    Ok(all)
}

/// The table in a file; `None` if it belongs to another sweep.
fn read(file: &Path, manifest: &Manifest) -> Result<Option<Table>, OutputError> {
    let (table, provenance) = parquet::read(file).map_err(|error| match error {
        OutputError::Read { path, why } => {
            OutputError::Read { path, why: format!("{why}; remove it, and its points run again") }
        }
        other => other,
    })?;
    let json = manifest.json()?;
    let ours = provenance.iter().any(|(name, value)| name == PROVENANCE && *value == json);
    Ok(ours.then_some(table))
}

/// Writes rows in the order of their points to the file `rows_name`, and their spectra, if the manifest asks for them, to `spectra_name`.
/// The spectra are written first, so that a row on disk always has its spectra. Returns the table of the rows.
pub(super) fn write(
    folder: &mut WholeFiles,
    (rows_name, spectra_name): (&str, &str),
    manifest: &Manifest,
    layout: &Layout,
    rows: &[&Row],
) -> Result<Table, OutputError> {
    let json = manifest.json()?;
    if manifest.spectra {
        let table = spectra::table(rows.iter().map(|row| (row.point, row.spectra.as_slice())))?;
        folder.write(spectra_name, |sink| parquet::write(&table, provenance(manifest, &json), sink))?;
    }
    let table = row::table(&layout.plan, &layout.columns, &layout.units, rows)?;
    folder.write(rows_name, |sink| parquet::write(&table, provenance(manifest, &json), sink))?;
    Ok(table)
}

/// The bytes of the file of a part with these rows, of a sweep without spectra. The rows are in the order of their points.
///
/// # Errors
/// [`OutputError::Format`].
pub fn table_in_bytes(manifest: &Manifest, layout: &Layout, rows: &[&Row]) -> Result<Vec<u8>, OutputError> {
    let (json, mut bytes) = (manifest.json()?, vec![]);
    let table = row::table(&layout.plan, &layout.columns, &layout.units, rows)?;
    parquet::write(&table, provenance(manifest, &json), &mut bytes)?;
    Ok(bytes)
}

/// The metadata of a file of rows; `json` is the manifest as text.
fn provenance<'a>(manifest: &'a Manifest, json: &'a str) -> [(&'static str, &'a str); 7] {
    [
        ("program", &manifest.program),
        ("version", &manifest.program_version),
        ("commit", manifest.commit.as_deref().unwrap_or_default()),
        ("scene", &manifest.scene),
        ("scene_sha256", &manifest.scene_sha256),
        ("model", &manifest.model),
        (PROVENANCE, json),
    ]
}

/// The names of the files in a folder, sorted; empty if the folder does not exist.
fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut names: Vec<_> = entries.filter_map(|entry| entry.file_name().into_string().ok()).collect();
    names.sort();
    names
}
