//! What the text of a scene states: the numbers that sliders change, effects, and the places of values.

use toml_edit::{Document, Item, Value};

use crate::scene::quantity;
use crate::scene::text::Text;

/// A number in the text, with or without a unit.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Leaf {
    /// Tables, keys and places in arrays that lead to it.
    pub path: Vec<String>,
    /// The number as written.
    pub number: f64,
    /// Its unit as written; empty for a plain number.
    pub unit: String,
    /// Whether it is written as a whole number.
    pub whole: bool,
}

impl Leaf {
    /// Its path as one text: `laws.k.steps.0.value`.
    pub fn key(&self) -> String {
        self.path.join(".")
    }
}

impl Text {
    /// Its numbers, in the order of the text.
    pub(super) fn leaves(&self) -> Vec<Leaf> {
        let mut leaves = vec![];
        visit(self.0.as_item(), &mut vec![], &mut |path, value| {
            let (number, unit, whole) = match value {
                Value::Integer(x) => (*x.value() as f64, "", true),
                Value::Float(x) => (*x.value(), "", false),
                Value::String(text) => match quantity::split(text.value()) {
                    // A text that is only a number is a name: trains call rotors `1` and `2`.
                    Ok((number, unit)) if !unit.is_empty() => (number, unit, false),
                    _ => return,
                },
                _ => return,
            };
            leaves.push(Leaf { path: path.to_vec(), number, unit: unit.into(), whole });
        });
        leaves
    }

    /// The item at a path of tables.
    pub fn at(&self, path: &[&str]) -> Option<&Item> {
        path.iter().try_fold(self.0.as_item(), |item, key| item.get(key))
    }

    /// The names in the list `key` at the top.
    pub fn names(&self, key: &str) -> Vec<String> {
        let list = self.0.get(key).and_then(Item::as_array);
        list.into_iter().flatten().filter_map(|name| Some(name.as_str()?.to_owned())).collect()
    }

    /// Writes the names to the list `key` at the top.
    pub fn set_names(&mut self, key: &str, names: &[&str]) {
        self.put(&[key], Value::from_iter(names.iter().copied()));
    }

    /// Writes a number with the unit that the text has at its place. If the number is the same, nothing is changed.
    pub(super) fn set(&mut self, leaf: &Leaf, number: f64) {
        if leaf.number != number {
            let path: Vec<_> = leaf.path.iter().map(String::as_str).collect();
            self.put(&path, with_unit(number, &leaf.unit));
        }
    }

    /// Removes a key from a table.
    pub fn remove(&mut self, table: &str, key: &str) {
        if let Some(table) = self.0.get_mut(table).and_then(Item::as_table_like_mut) {
            table.remove(key);
        }
    }
}

/// A number with a unit as a value of a scene; a plain number where the unit is empty or 1.
pub(super) fn with_unit(number: f64, unit: &str) -> Value {
    let size = number.abs();
    match unit {
        "" | "1" if number.fract() == 0.0 && size < 1e15 => Value::from(number as i64),
        "" | "1" => Value::from(number),
        unit if number == 0.0 || (1e-4..1e15).contains(&size) => Value::from(format!("{number} {unit}")),
        unit => Value::from(format!("{number:e} {unit}")),
    }
}

/// The key of the innermost value at a byte of a text.
pub(super) fn key_at(text: &str, offset: usize) -> Option<String> {
    let document = Document::parse(text).ok()?;
    let mut found = None;
    visit(document.as_item(), &mut vec![], &mut |path, value| {
        if value.span().is_some_and(|span| span.contains(&offset)) {
            found = Some(path.join("."));
        }
    });
    found
}

/// Calls `see` for each value below `item`. It is called for a value before it is called for the values in it.
fn visit(item: &Item, path: &mut Vec<String>, see: &mut dyn FnMut(&[String], &Value)) {
    match item {
        Item::None => {}
        Item::Value(value) => within(value, path, see),
        Item::Table(table) => step_all(table.iter(), path, &mut |item, path| visit(item, path, see)),
        Item::ArrayOfTables(tables) => {
            for (i, table) in tables.iter().enumerate() {
                path.push(i.to_string());
                step_all(table.iter(), path, &mut |item, path| visit(item, path, see));
                path.pop();
            }
        }
    }
}

fn within(value: &Value, path: &mut Vec<String>, see: &mut dyn FnMut(&[String], &Value)) {
    see(path, value);
    match value {
        Value::InlineTable(table) => step_all(table.iter(), path, &mut |value, path| within(value, path, see)),
        Value::Array(array) => {
            let numbered = array.iter().enumerate().map(|(i, value)| (i.to_string(), value));
            step_all(numbered, path, &mut |value, path| within(value, path, see));
        }
        _ => {}
    }
}

fn step_all<T>(
    entries: impl Iterator<Item = (impl ToString, T)>,
    path: &mut Vec<String>,
    into: &mut dyn FnMut(T, &mut Vec<String>),
) {
    for (key, entry) in entries {
        path.push(key.to_string());
        into(entry, path);
        path.pop();
    }
}
