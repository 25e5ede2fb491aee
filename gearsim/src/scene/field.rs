//! Readers of single values: quantities, text, flags, arrays, tables, lists of names.

mod quantity;

pub(super) use quantity::{out_of_range, quantity};

use super::document::{KeyEntry, Node, Value};
use super::keys::choices;
use super::mistake::Report;

/// Reports that a value has the wrong type; `expected` is the right one.
pub(super) fn wrong_type(path: &str, node: &Node, expected: &str, help: &str, report: &mut Report) {
    let found = match node.value {
        Value::Text(_) => "text",
        Value::Number(_) => "a number",
        Value::Flag(_) => "true or false",
        Value::Date => "a date",
        Value::Array(_) => "an array",
        Value::Table(_) => "a table",
    };
    report.add(&node.place, format!("`{path}` must be {expected}, not {found}"), found, help);
}

pub(super) fn text<'a>(path: &str, node: &'a Node, report: &mut Report) -> Option<&'a str> {
    match &node.value {
        Value::Text(text) => Some(text),
        _ => {
            wrong_type(path, node, "text", "put it in quotes: \"...\"", report);
            None
        }
    }
}

pub(super) fn flag(path: &str, node: &Node, report: &mut Report) -> Option<bool> {
    match node.value {
        Value::Flag(flag) => Some(flag),
        _ => {
            wrong_type(path, node, "true or false", "write true or false, without quotes", report);
            None
        }
    }
}

pub(super) fn array<'a>(path: &str, node: &'a Node, example: &str, report: &mut Report) -> Option<&'a [Node]> {
    match &node.value {
        Value::Array(items) => Some(items),
        _ => {
            wrong_type(path, node, "an array", &format!("write for example {example}"), report);
            None
        }
    }
}

pub(super) fn table<'a>(path: &str, node: &'a Node, report: &mut Report) -> Option<&'a [KeyEntry]> {
    match &node.value {
        Value::Table(entries) => Some(entries),
        _ => {
            wrong_type(path, node, "a table", &format!("write [{path}], and its keys on the lines below"), report);
            None
        }
    }
}

/// Reads a name and returns its index in `allowed`; `noun` says in messages what the name stands for.
pub(super) fn choice(path: &str, node: &Node, noun: &str, allowed: &[&str], report: &mut Report) -> Option<usize> {
    let name = text(path, node, report)?;
    let chosen = allowed.iter().position(|known| *known == name);
    if chosen.is_none() {
        let message = format!("there is no {noun} `{name}`");
        report.add(&node.place, message, format!("unknown {noun}"), choices(name, allowed));
    }
    chosen
}

/// Reads an array of distinct names and returns their indices in `allowed`; `noun` says in messages what a name stands for.
pub(super) fn names(path: &str, node: &Node, noun: &str, allowed: &[&str], report: &mut Report) -> Option<Vec<usize>> {
    names_or(path, node, noun, (allowed, &|name| choices(name, allowed)), report)
}

/// The names that are allowed, and the help for another name.
pub(super) type Allowed<'a> = (&'a [&'a str], &'a dyn Fn(&str) -> String);

/// As [`names`]; `help` makes the help text for an unknown name.
pub(super) fn names_or(
    path: &str,
    node: &Node,
    noun: &str,
    (allowed, help): Allowed<'_>,
    report: &mut Report,
) -> Option<Vec<usize>> {
    let example = format!("{:?}", &allowed[..allowed.len().min(2)]);
    let items = array(path, node, &example, report)?;
    let mut chosen = Vec::new();
    for (i, item) in items.iter().enumerate() {
        let Some(name) = text(&format!("{path}.{i}"), item, report) else {
            continue;
        };
        match allowed.iter().position(|known| *known == name) {
            None => {
                report.add(&item.place, format!("there is no {noun} `{name}`"), format!("unknown {noun}"), help(name))
            }
            Some(index) if chosen.contains(&index) => {
                report.add(&item.place, format!("`{name}` is named twice in `{path}`"), "again", "name it once");
            }
            Some(index) => chosen.push(index),
        }
    }
    Some(chosen)
}
