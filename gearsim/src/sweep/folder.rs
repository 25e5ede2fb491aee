//! The folder of a sweep: `sweep.json`, which says what it is; `parts/`, rows as they come in, each file whole or not
//! there; in the end `sweep.parquet`, all rows in the order of their points, and no parts.
//!
//! A part holds any points. What is there need not run again, whatever was interrupted or removed.

use std::collections::BTreeMap;
use std::fs::File;
use std::path::{Path, PathBuf};

use super::manifest::{self, Layout, Manifest};
use super::row::{self, Row};
use super::{Error, impossible, spectra};
use crate::output::{OutputError, OutputFolder, Table, parquet};

/// The rows, in the order of their points.
pub const ROWS: &str = "sweep.parquet";
/// The spectra, if they are kept, in the same order.
pub const SPECTRA: &str = "spectra.parquet";
/// Where rows are until all are there.
const PARTS: &str = "parts";
/// Name under which the manifest stands in every file.
const PROVENANCE: &str = "sweep";

/// Rows by the number of their point.
pub type Rows = BTreeMap<usize, Row>;

/// The folder of a sweep, while it is filled.
pub struct Folder<'a> {
    path: PathBuf,
    parts: OutputFolder,
    manifest: &'a Manifest,
    layout: &'a Layout,
    /// Held as long as this process fills the folder.
    _lock: File,
}

impl<'a> Folder<'a> {
    /// Opens the folder at `path` for the sweep of `manifest`: a new one, or one that this sweep was begun in.
    ///
    /// # Errors
    /// Where the folder holds another sweep, another process fills it, or it cannot be written to.
    pub fn open(path: &Path, manifest: &'a Manifest, layout: &'a Layout) -> Result<Self, Error> {
        refuse_another(path, manifest)?;
        let mut folder = OutputFolder::create(path)?;
        let parts = OutputFolder::create(path.join(PARTS))?;
        let lock = path.join(PARTS).join("lock");
        let unwritable = |source| OutputError::Write { path: lock.clone(), source };
        let file = File::create(&lock).map_err(unwritable)?;
        match file.try_lock() {
            Ok(()) => {}
            Err(std::fs::TryLockError::WouldBlock) => {
                let what = format!("another gearsim is at work in {}", path.display());
                return impossible(what, "let it end, or choose another folder with --out: one for each shard");
            }
            // A file system that knows no locks is no reason not to run.
            Err(std::fs::TryLockError::Error(_)) => {}
        }
        folder.write_bytes(manifest::FILE, manifest.json()?.as_bytes())?;
        Ok(Folder { path: path.to_owned(), parts, manifest, layout, _lock: file })
    }

    /// The rows that are there.
    ///
    /// # Errors
    /// [`OutputError::Read`].
    pub fn rows(&self) -> Result<Rows, OutputError> {
        rows(&self.path, self.manifest, self.layout)
    }

    /// Puts rows into a part of their own.
    ///
    /// # Errors
    /// Those of writing.
    pub fn keep(&mut self, rows: &[Row]) -> Result<(), OutputError> {
        let rows: Rows = rows.iter().map(|row| (row.point, row.clone())).collect();
        let Some(first) = rows.keys().next() else { return Ok(()) };
        // No other part has this point, so none has this name.
        let name = format!("{first:08}.parquet");
        write(&mut self.parts, (&format!("rows-{name}"), &format!("spectra-{name}")), self.manifest, self.layout, &rows)
    }

    /// Joins the parts to one file.
    ///
    /// # Errors
    /// Those of reading and writing; the parts are still there then.
    pub fn finish(self) -> Result<Rows, OutputError> {
        let rows = self.rows()?;
        let mut folder = OutputFolder::create(&self.path)?;
        write(&mut folder, (ROWS, SPECTRA), self.manifest, self.layout, &rows)?;
        let parts = self.path.join(PARTS);
        std::fs::remove_dir_all(&parts).map_err(|source| OutputError::Write { path: parts, source })?;
        Ok(rows)
    }
}

/// Refuses a folder that holds another sweep than that of `manifest`.
///
/// # Errors
/// [`Error::Impossible`], and where its manifest cannot be read.
pub fn refuse_another(path: &Path, manifest: &Manifest) -> Result<(), Error> {
    let Some(other) = Manifest::read(path)? else { return Ok(()) };
    let differences = manifest.differences(&other);
    if differences.is_empty() {
        return Ok(());
    }
    let what = format!("{} holds another sweep\n  {}", path.display(), differences.join("\n  "));
    impossible(what, "choose another folder with --out, or remove that one")
}

/// The rows in the folder at `path` that belong to the sweep of `manifest`, those of its parts included.
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
            for (point, line) in spectra::read(&table).ok_or_else(|| broken(&file))? {
                // A line may stand in a part and in the whole.
                if let Some(row) = all.get_mut(&point)
                    && row.spectra.iter().all(|other| other.coordinate != line.coordinate)
                {
                    row.spectra.push(line);
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

/// Writes rows, and before them their spectra: rows that are there are there with all that belongs to them.
pub(super) fn write(
    folder: &mut OutputFolder,
    (rows_name, spectra_name): (&str, &str),
    manifest: &Manifest,
    layout: &Layout,
    rows: &Rows,
) -> Result<(), OutputError> {
    let json = manifest.json()?;
    let provenance = [
        ("program", manifest.program.as_str()),
        ("version", &manifest.version),
        ("commit", manifest.commit.as_deref().unwrap_or_default()),
        ("scene", &manifest.scene),
        ("scene_sha256", &manifest.scene_sha256),
        ("model", &manifest.model),
        (PROVENANCE, &json),
    ];
    if manifest.spectra {
        let table = spectra::table(rows.values().map(|row| (row.point, row.spectra.as_slice())))?;
        folder.write(spectra_name, |sink| parquet::write(&table, provenance, sink))?;
    }
    let table = row::table(&layout.plan, &layout.columns, &layout.units, &rows.values().collect::<Vec<_>>())?;
    folder.write(rows_name, |sink| parquet::write(&table, provenance, sink))
}

/// The names of the files in a folder, sorted; none if it is not there.
fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut names: Vec<_> = entries.filter_map(|entry| entry.file_name().into_string().ok()).collect();
    names.sort();
    names
}
