//! Overrides: `--set parameters.T0="20 N*m"` replaces values in the tree of a scene before the tree is checked.

use super::document::{self, KeyEntry, Node, Origin, Place, Value};
use super::mistake::Report;

/// Largest depth of a key, more than any scene has. The tree is walked recursively, so its depth must be limited.
const MAX_DEPTH: usize = 16;

/// Where overrides come from, as messages show them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Setting {
    /// Name of the text in messages.
    pub source: &'static str,
    /// The option before the value; empty if there is none.
    pub option: &'static str,
}

/// Options of the command line.
pub(super) const SET: Setting = Setting { source: "command line", option: "--set " };
/// A point of a sweep.
pub(super) const VARY: Setting = Setting { source: "command line", option: "--vary " };
/// A point of a sweep that a program defines.
pub(super) const AXES: Setting = Setting { source: "axes set in code", option: "" };
/// A program that uses the library.
pub(super) const CODE: Setting = Setting { source: "values set in code", option: "" };

/// Writes an override into the tree. Mistakes in its form are reported here; its value is checked with the scene.
/// Messages quote it as the user typed it.
pub(super) fn apply(root: &mut Node, from: Setting, text: &str, report: &mut Report) {
    let Setting { source, option } = from;
    let source = report.source(source, &format!("{option}{text}"));
    let origin = Origin { source, offset: option.len() };
    let Some((path, value)) = text.split_once('=') else {
        let help = format!("write {option}KEY=VALUE, e.g. {option}run.t_end=\"1 s\"");
        return report.add(&origin.place(0..text.len()), "an override without a value", "no `=`", help);
    };
    let Some(keys) = keys(path, origin) else {
        let help = "write the key with its tables, separated by dots: parameters.T0, laws.k.steps.0.value";
        return report.add(&origin.place(0..path.len()), "an override with an invalid key", "not a key", help);
    };
    if let Some(node) = read_value(value, option, Origin { source, offset: option.len() + path.len() + 1 }, report) {
        set(root, &keys, node, option, report);
    }
}

/// Splits a path into its keys; `None` if one is empty, or there are more than [`MAX_DEPTH`].
fn keys(path: &str, origin: Origin) -> Option<Vec<(&str, Place)>> {
    let mut keys = Vec::new();
    let mut at = 0;
    for part in path.split('.') {
        let key = part.trim();
        if key.is_empty() || keys.len() == MAX_DEPTH {
            return None;
        }
        let start = at + part.len() - part.trim_start().len();
        keys.push((key, origin.place(start..start + key.len())));
        at += part.len() + 1;
    }
    Some(keys)
}

/// Reads a TOML value. A text that is not valid TOML and does not begin like a TOML string, array or table is taken as a string,
/// because shells remove quotes.
fn read_value(text: &str, option: &str, origin: Origin, report: &mut Report) -> Option<Node> {
    let trimmed = text.trim();
    let start = text.len() - text.trim_start().len();
    let origin = Origin { offset: origin.offset + start, ..origin };
    let place = origin.place(0..trimmed.len());
    if trimmed.is_empty() {
        report.add(&place, "an override without a value", "nothing after `=`", format!("write {option}KEY=VALUE"));
        return None;
    }
    match document::read_value(trimmed, origin) {
        Ok(node) => Some(node),
        Err(error) if trimmed.starts_with(['"', '\'', '[', '{']) => {
            document::report_value(&error, trimmed, origin, report);
            None
        }
        Err(_) => Some(Node { value: Value::Text(trimmed.to_string()), place }),
    }
}

fn set(node: &mut Node, keys: &[(&str, Place)], value: Node, option: &str, report: &mut Report) {
    let Some(((key, place), rest)) = keys.split_first() else {
        *node = value;
        return;
    };
    match &mut node.value {
        Value::Table(entries) => {
            let index = entries.iter().position(|entry| entry.key == *key).unwrap_or_else(|| {
                let node = Node { value: Value::Table(Vec::new()), place: place.clone() };
                entries.push(KeyEntry { key: key.to_string(), place: place.clone(), node });
                entries.len() - 1
            });
            // An existing key keeps its place: the parts of a train are in the order of the text.
            set(&mut entries[index].node, rest, value, option, report);
        }
        Value::Array(items) => {
            let count = items.len();
            match key.parse::<usize>().ok().and_then(|index| items.get_mut(index)) {
                Some(item) => set(item, rest, value, option, report),
                None => {
                    let help = match count {
                        0 => format!("set the whole array: {option}KEY=[...]"),
                        _ => format!("its entries are numbered from 0 to {}", count - 1),
                    };
                    report.add(place, format!("no entry `{key}` in an array of {count}"), "no such entry", help);
                }
            }
        }
        _ => {
            let help = "the key before it has a single value, not a table: leave out this part of the key";
            report.add(place, format!("`{key}` cannot be set inside a single value"), "too deep", help);
        }
    }
}
