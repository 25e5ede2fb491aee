//! Overrides: `--set parameters.T0="20 N*m"` written over the tree of a scene before it is checked.

use super::document::{self, Entry, Node, Origin, Place, Value};
use super::error::Report;

/// Keys deeper than any that a scene has: the tree is walked recursively, so its depth must have an end.
const MAX_DEPTH: usize = 16;

/// Writes an override into the tree. What is wrong with its form is reported; its value is checked with the scene.
/// `option` is shown before it where it is quoted, so that it looks as it was typed.
pub(super) fn apply(root: &mut Node, option: &str, text: &str, report: &mut Report) {
    let source = report.source("command line", &format!("{option}{text}"));
    let origin = Origin { source, offset: option.len() };
    let Some((path, value)) = text.split_once('=') else {
        let help = "write --set KEY=VALUE, e.g. --set run.t_end=\"1 s\"";
        return report.add(&origin.place(0..text.len()), "an override without a value", "no `=`", help);
    };
    let Some(keys) = keys(path, origin) else {
        let help = "write the key as in the file, its tables before it: parameters.T0, laws.k.steps.0.value";
        return report.add(&origin.place(0..path.len()), "an override of no possible key", "not a key", help);
    };
    if let Some(node) = read_value(value, Origin { source, offset: option.len() + path.len() + 1 }, report) {
        set(root, &keys, node, report);
    }
}

/// The keys of a path; `None` if one is empty, or there are too many.
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

/// A TOML value; what is none, and does not look as if it should be, is text: shells eat quotes.
fn read_value(text: &str, origin: Origin, report: &mut Report) -> Option<Node> {
    let trimmed = text.trim();
    let start = text.len() - text.trim_start().len();
    let origin = Origin { offset: origin.offset + start, ..origin };
    let place = origin.place(0..trimmed.len());
    if trimmed.is_empty() {
        report.add(&place, "an override without a value", "nothing after `=`", "write --set KEY=VALUE");
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

fn set(node: &mut Node, keys: &[(&str, Place)], value: Node, report: &mut Report) {
    let Some(((key, place), rest)) = keys.split_first() else {
        *node = value;
        return;
    };
    match &mut node.value {
        Value::Table(entries) => {
            let index = entries.iter().position(|entry| entry.key == *key).unwrap_or_else(|| {
                let node = Node { value: Value::Table(Vec::new()), place: place.clone() };
                entries.push(Entry { key: key.to_string(), place: place.clone(), node });
                entries.len() - 1
            });
            if rest.is_empty() {
                entries[index].place = place.clone();
            }
            set(&mut entries[index].node, rest, value, report);
        }
        Value::Array(items) => {
            let count = items.len();
            match key.parse::<usize>().ok().and_then(|index| items.get_mut(index)) {
                Some(item) => set(item, rest, value, report),
                None => {
                    let help = match count {
                        0 => "set the whole array: --set KEY=[...]".to_string(),
                        _ => format!("its entries are numbered from 0 to {}", count - 1),
                    };
                    report.add(place, format!("no entry `{key}` in an array of {count}"), "no such entry", help);
                }
            }
        }
        _ => {
            let help = "leave out what follows the key of the value";
            report.add(place, format!("nothing can be set by `{key}` inside a single value"), "too deep", help);
        }
    }
}
