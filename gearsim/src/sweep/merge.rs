//! Joins the results of a sweep from many machines. The bytes are the same as if one machine had run all points.

use std::path::{Path, PathBuf};

use super::folder::{self, ROWS, Rows, SPECTRA};
use super::manifest::{self, Layout, Manifest};
use super::{Error, impossible};
use crate::output::WholeFiles;
use crate::run::Entry;

/// Maximum number of ranges of points that a message lists; the points of the others are only counted.
const LISTED: usize = 8;

/// Refuses a folder `out` for the joined results that is one of the folders `from`: its shard would be lost.
///
/// # Errors
/// [`Error::Impossible`].
pub fn refuse_input(from: &[PathBuf], out: &Path) -> Result<(), Error> {
    let same = |a: &Path, b: &Path| match (a.canonicalize(), b.canonicalize()) {
        (Ok(a), Ok(b)) => a == b,
        _ => a == b,
    };
    match from.iter().find(|folder| same(folder, out)) {
        Some(folder) => {
            let what = format!("--out {} is one of the folders to merge", folder.display());
            impossible(what, "choose another folder for the joined results: the shards are kept")
        }
        None => Ok(()),
    }
}

/// Reads the results in the folders `from`, which together hold all points of one sweep.
///
/// # Errors
/// If the folders hold different sweeps, or if a point is missing or present twice.
pub fn gather(from: &[PathBuf], entries: &[Entry]) -> Result<(Manifest, Layout, Rows), Error> {
    let (mut whole, mut all): (Option<(Manifest, Layout, &PathBuf)>, Rows) = (None, Rows::new());
    let (mut twice, mut where_twice) = (vec![], None);
    for path in from {
        let Some(manifest) = Manifest::read(path)? else {
            let what = format!("{} holds no sweep: it has no {}", path.display(), manifest::FILE);
            return impossible(what, "give folders written by `gearsim sweep`");
        };
        let (first, layout, first_path) = match &mut whole {
            Some(whole) => whole,
            None => {
                let layout = manifest.layout(entries)?;
                whole.insert((manifest.clone(), layout, path))
            }
        };
        let differences = manifest.differences(first);
        if !differences.is_empty() {
            let (here, there) = (path.display(), first_path.display());
            let what = format!("{here} and {there} hold different sweeps\n  {}", differences.join("\n  "));
            return impossible(what, "merge shards of one sweep: the same scene, axes and program");
        }
        for (point, row) in folder::rows(path, &manifest, layout)? {
            if all.insert(point, row).is_some() {
                twice.push(point);
                where_twice = Some(path);
            }
        }
    }
    let Some((manifest, layout, _)) = whole else {
        return impossible("there is nothing to merge", "give the folders of the shards");
    };
    if let Some(path) = where_twice {
        let what = format!("points {} are in {} and in a folder before it", ranges(&twice), path.display());
        return impossible(what, "give every shard once");
    }
    let missing: Vec<usize> = (0..manifest.points).filter(|point| !all.contains_key(point)).collect();
    if !missing.is_empty() {
        let (n, points) = (missing.len(), manifest.points);
        let what = format!("{n} of {points} points are missing: {}", ranges(&missing));
        return impossible(what, "run the missing or interrupted shards; a shard that is run again continues");
    }
    Ok((manifest, layout, all))
}

/// Writes the results of [`gather`] to the folder `out`. The folder says that it is incomplete until [`folder::end`].
///
/// # Errors
/// If the folder holds another sweep, or cannot be written to.
pub fn write(out: &Path, manifest: &Manifest, layout: &Layout, rows: &Rows) -> Result<(), Error> {
    folder::refuse_another(out, manifest)?;
    let mut folder = WholeFiles::create(out)?;
    folder.clear_leftovers();
    folder::begin(out)?;
    folder.write_bytes(manifest::FILE, manifest.json()?.as_bytes())?;
    folder::write(&mut folder, (ROWS, SPECTRA), manifest, layout, &rows.values().collect::<Vec<_>>())?;
    Ok(())
}

/// Ascending numbers as ranges: `3, 7-9`.
fn ranges(points: &[usize]) -> String {
    let runs: Vec<&[usize]> = points.chunk_by(|a, b| a + 1 == *b).collect();
    let short = |run: &&[usize]| match run {
        [only] => only.to_string(),
        run => format!("{}-{}", run[0], run[run.len() - 1]),
    };
    let mut text = runs.iter().take(LISTED).map(short).collect::<Vec<_>>().join(", ");
    if runs.len() > LISTED {
        let more: usize = runs[LISTED..].iter().map(|run| run.len()).sum();
        text += &format!(" and {more} more");
    }
    text
}

#[test]
fn ascending_numbers_are_shown_as_ranges() {
    assert_eq!(ranges(&[3, 7, 8, 9, 11]), "3, 7-9, 11");
    assert_eq!(ranges(&(0..20).map(|i| 2 * i).collect::<Vec<_>>()), "0, 2, 4, 6, 8, 10, 12, 14 and 12 more");
}
