//! Puts the staged files of a result in the place of an earlier one.
//!
//! A result is a set of files and its index, a JSON file that names the others: `summary.json` of a run. Every earlier result with
//! the same index, or with a file of the same name, is removed: first its index, then its other files. Then the new files are renamed,
//! their index last. Meanwhile the folder has the file [`MARKER`]. It says that the folder is incomplete, and lists the files.

use std::collections::BTreeSet;
use std::fs;
use std::io::{self, Read};
use std::path::Path;

use serde_json::Value;

use super::marker::{self, MARKER, remove};
use super::whole::{create_folder, is_inside};
use super::{OutputError, fault};

/// First lines of the marker; the names of files follow, one a line.
const SAYS: &str = "\
gearsim was interrupted while it replaced the results in this folder.
Every file is whole, but some may be missing. The same command run again replaces them:
";
/// The page of a result. The page itself names the index file of that result: [`belongs`].
pub const PAGE: &str = "page.html";
/// The index files of all commands that list their files.
const INDEXES: [&str; 4] = ["summary.json", "compare.json", "modes.json", "floquet.json"];

/// Replaces earlier results in `folder` by the files `new` in the folder `staging`; `index` is one of them.
///
/// Errors: [`OutputError::Write`]. Before the marker is written, nothing has changed.
pub(super) fn swap(folder: &Path, staging: &Path, new: &[String], index: &str) -> Result<(), OutputError> {
    for name in new {
        let path = folder.join(name);
        if path.is_dir() {
            let source = io::Error::other("a folder has this name; remove it, or choose another");
            return Err(OutputError::Write { path, source });
        }
    }
    let old = earlier(folder, new, index);
    // `old` begins with the index files, so that they are removed first.
    let listed: BTreeSet<&str> = old.iter().chain(new).map(String::as_str).collect();
    let list: String = listed.iter().map(|name| format!("{name}\n")).collect();
    // Results of another kind in the same folder may be incomplete too.
    let other = marker::read(folder).filter(|text| !text.starts_with(SAYS));
    marker::write(folder, &format!("{SAYS}{list}"))?;
    old.iter().try_for_each(|name| remove(&folder.join(name)))?;
    let (last, others): (Vec<&String>, Vec<_>) = new.iter().partition(|name| *name == index);
    for name in others.into_iter().chain(last) {
        let to = folder.join(name);
        to.parent().map_or(Ok(()), create_folder)?;
        let renamed = fault::point().and_then(|()| fs::rename(staging.join(name), &to));
        renamed.map_err(|source| OutputError::Write { path: to, source })?;
    }
    match other {
        Some(text) => marker::write(folder, &text),
        None => remove(&folder.join(MARKER)),
    }
}

/// The files of earlier results that the result with the files `new` replaces: index files first.
fn earlier(folder: &Path, new: &[String], index: &str) -> Vec<String> {
    let (mut indexes, mut files) = (vec![], vec![]);
    for known in INDEXES {
        let Some(owned) = fs::read(folder.join(known)).ok().and_then(|bytes| owned(&bytes)) else { continue };
        if known == index || owned.iter().any(|name| new.contains(name)) {
            indexes.push(known.to_owned());
            files.extend(owned);
        }
    }
    let replaced = |owner: &String| owner == index || indexes.contains(owner);
    if page_of(folder).as_ref().is_some_and(replaced) && !files.iter().any(|name| name == PAGE) {
        files.push(PAGE.to_owned());
    }
    let marked = marker::read(folder).unwrap_or_default();
    files.extend(marked.strip_prefix(SAYS).into_iter().flat_map(str::lines).map(str::to_owned));
    files.retain(|name| is_inside(name) && folder.join(name).is_file());
    indexes.extend(files);
    indexes
}

/// An element of the head of a page that says to which index file it belongs; it is among the first `HEAD` bytes.
#[cfg(any(test, feature = "html"))]
pub fn belongs(index: &str) -> String {
    format!("{BELONGS}{index}\">")
}

const BELONGS: &str = "<meta name=\"gearsim-result\" content=\"";
const HEAD: u64 = 1024;

/// The index file to which the page in a folder belongs; `None` if there is no page of gearsim.
fn page_of(folder: &Path) -> Option<String> {
    let mut head = vec![];
    fs::File::open(folder.join(PAGE)).ok()?.take(HEAD).read_to_end(&mut head).ok()?;
    let head = String::from_utf8_lossy(&head);
    let (_, rest) = head.split_once(BELONGS)?;
    Some(rest.split_once('"')?.0.to_owned())
}

/// The files that an index names: those in its lists `files` and `plots`. `None` if it was not written by gearsim.
fn owned(index: &[u8]) -> Option<Vec<String>> {
    let (mut files, mut ours) = (vec![], false);
    visit(&serde_json::from_slice(index).ok()?, &mut files, &mut ours);
    ours.then_some(files)
}

fn visit(value: &Value, files: &mut Vec<String>, ours: &mut bool) {
    match value {
        Value::Object(map) => {
            for (key, value) in map {
                match (key.as_str(), value) {
                    ("files" | "plots", Value::Array(names)) => {
                        files.extend(names.iter().filter_map(Value::as_str).map(str::to_owned));
                    }
                    ("program", Value::String(name)) => *ours |= name == "gearsim",
                    _ => visit(value, files, ours),
                }
            }
        }
        Value::Array(items) => items.iter().for_each(|item| visit(item, files, ours)),
        _ => {}
    }
}
