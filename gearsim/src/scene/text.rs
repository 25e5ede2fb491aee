//! The text of a scene as a tree whose values can be set. Comments and layout stay.

use std::fmt;

use toml_edit::{DocumentMut, InlineTable, Item, Table, TableLike, Value};

/// The text of a scene.
#[derive(Debug, Clone)]
pub(crate) struct Text(pub(crate) DocumentMut);

impl Text {
    /// Reads a text; `None` if it is not TOML.
    pub(crate) fn parse(text: &str) -> Option<Text> {
        text.parse().ok().map(Text)
    }

    /// Sets a value as the option `--set` does: `parameters.T0=20 N*m`. If it is not a TOML value, it is set as a string.
    pub(crate) fn set_as_option(&mut self, setting: &str) {
        if let Some((key, written)) = setting.split_once('=') {
            let path: Vec<&str> = key.split('.').map(str::trim).collect();
            self.put(&path, value(written.trim()).unwrap_or_else(|| Value::from(written.trim())));
        }
    }

    /// Writes a value at a path. Missing tables are created; existing items along the path must be tables or entries of arrays.
    pub(crate) fn put(&mut self, path: &[&str], mut value: Value) {
        if let Some(slot) = find(self.0.as_item_mut(), path) {
            *value.decor_mut() = slot.decor().clone();
            *slot = value;
        } else if let [tables @ .., key] = path
            && let Some(table) = table_at(self.0.as_table_mut(), tables, 0)
        {
            table.insert(key, Item::Value(value));
        }
    }
}

impl fmt::Display for Text {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// The TOML value that `text` states; `None` if it is none.
pub(crate) fn value(text: &str) -> Option<Value> {
    text.parse().ok()
}

/// The table at a path, whose first key is at `depth`; missing tables are created. A new table within a table that has only values
/// is written inline, so that the keys of the latter stay in their order.
fn table_at<'a>(table: &'a mut dyn TableLike, path: &[&str], depth: usize) -> Option<&'a mut dyn TableLike> {
    let Some((key, rest)) = path.split_first() else { return Some(table) };
    let in_lines = depth > 0 && table.iter().all(|(_, item)| item.is_value());
    let new = || if in_lines { Item::Value(InlineTable::new().into()) } else { Item::Table(Table::new()) };
    let entry = |rest: &[&str]| rest.first().and_then(|place| place.parse::<usize>().ok());
    match table.entry(key).or_insert_with(new) {
        Item::ArrayOfTables(tables) => table_at(tables.get_mut(entry(rest)?)?, &rest[1..], depth + 2),
        Item::Value(Value::Array(array)) => {
            table_at(array.get_mut(entry(rest)?)?.as_inline_table_mut()?, &rest[1..], depth + 2)
        }
        item => table_at(item.as_table_like_mut()?, rest, depth + 1),
    }
}

/// The value at a path.
fn find<'a>(item: &'a mut Item, path: &[&str]) -> Option<&'a mut Value> {
    let Some((key, rest)) = path.split_first() else { return item.as_value_mut() };
    match item {
        Item::None => None,
        Item::Value(value) => find_in(value, path),
        Item::Table(table) => find(table.get_mut(key)?, rest),
        Item::ArrayOfTables(tables) => {
            let (next, rest) = rest.split_first()?;
            find(tables.get_mut(key.parse().ok()?)?.get_mut(next)?, rest)
        }
    }
}

fn find_in<'a>(value: &'a mut Value, path: &[&str]) -> Option<&'a mut Value> {
    let Some((key, rest)) = path.split_first() else { return Some(value) };
    match value {
        Value::InlineTable(table) => find_in(table.get_mut(key)?, rest),
        Value::Array(array) => find_in(array.get_mut(key.parse().ok()?)?, rest),
        _ => None,
    }
}
