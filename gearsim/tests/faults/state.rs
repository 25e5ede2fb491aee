//! What a folder holds: the earlier result, the new one, or an incomplete one.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use gearsim::__private::MARKER;
use serde_json::Value;

use crate::prepared::Prepared;
use crate::readable::readable;

/// The content of files by their paths in a folder.
pub type Files = BTreeMap<PathBuf, Vec<u8>>;

/// What a folder holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum State {
    Old,
    New,
    Incomplete,
}

/// Beginning of the names of temporary files and folders.
const TEMPORARY: &str = ".gearsim-";
/// The subfolder of the files that were whole when a write failed.
const PARTIAL: &str = "out/incomplete";
/// The lock of a sweep is no part of its result.
const LOCK: &str = "out/parts/lock";

/// The files in a folder and in its subfolders.
pub fn files(folder: &Path) -> Files {
    let mut files = Files::new();
    add(folder, Path::new(""), &mut files);
    files
}

fn add(root: &Path, below: &Path, files: &mut Files) {
    for entry in std::fs::read_dir(root.join(below)).unwrap().map(Result::unwrap) {
        let path = below.join(entry.file_name());
        match entry.path().is_dir() {
            true => add(root, &path, files),
            false => drop(files.insert(path, std::fs::read(entry.path()).unwrap())),
        }
    }
}

/// Whether a file is left over from a command that was interrupted.
pub fn is_leftover(path: &Path) -> bool {
    path.starts_with(PARTIAL) || path.iter().any(|name| name.to_string_lossy().starts_with(TEMPORARY))
}

/// The state of the folder `place`. The error says what is wrong with it.
pub fn state(prepared: &Prepared, place: &Path) -> Result<State, String> {
    let mut there = files(place);
    for (path, content) in there.iter().filter(|(path, _)| path.starts_with(PARTIAL)) {
        readable(path, content)?;
    }
    there.retain(|path, _| !is_leftover(path) && path != Path::new(LOCK));
    let new = differences(&there, &prepared.new, prepared.command.repeatable);
    if new.is_empty() {
        return Ok(State::New);
    }
    let old = differences(&there, &prepared.old, true);
    if old.is_empty() {
        return Ok(State::Old);
    }
    match there.get(&Path::new("out").join(MARKER)) {
        None => Err(format!("neither the old result, but {old:?}, nor the new one, but {new:?}")),
        Some(_) => there.iter().try_for_each(|(path, content)| readable(path, content)).map(|()| State::Incomplete),
    }
}

/// The files that are missing, too many, or different. With `repeatable` the same bytes are expected, otherwise files that can be read.
fn differences(there: &Files, expected: &Files, repeatable: bool) -> Vec<String> {
    let paths: BTreeSet<&PathBuf> = there.keys().chain(expected.keys()).collect();
    let differs = |path: &Path| match (there.get(path), expected.get(path)) {
        (Some(_), None) => Some("too many"),
        (None, _) => Some("missing"),
        (Some(a), Some(b)) if a == b => None,
        (Some(a), _) if !repeatable && readable(path, a).is_ok() => None,
        (Some(a), Some(b)) if path.extension().is_some_and(|e| e == "json") && untimed(a) == untimed(b) => None,
        _ => Some("different"),
    };
    let found = paths.into_iter().filter_map(|path| Some(format!("{} {}", path.display(), differs(path)?)));
    found.collect()
}

/// A JSON document without its processor times; `None` if it cannot be read.
fn untimed(json: &[u8]) -> Option<Value> {
    fn clear(value: &mut Value) {
        match value {
            Value::Object(map) => {
                map.remove("cpu_seconds");
                map.values_mut().for_each(clear);
            }
            Value::Array(values) => values.iter_mut().for_each(clear),
            _ => {}
        }
    }
    let mut value = serde_json::from_slice(json).ok()?;
    clear(&mut value);
    Some(value)
}
