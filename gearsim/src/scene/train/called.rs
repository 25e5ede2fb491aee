//! What messages call the values that [`tables`](super::tables) moves: the keys at which the author wrote them.

use std::collections::HashMap;

use crate::scene::document::{KeyEntry, Node, Place, Value};
use crate::scene::keys;
use crate::scene::mistake::{Home, Report};

/// The keys and values of the tables, by their places in the text.
pub(super) type Places = HashMap<(usize, usize, usize), (String, Node)>;

/// The keys of the values in the tables.
pub(super) fn places(entries: &[KeyEntry], tables: &[&str]) -> Places {
    fn walk(path: &str, node: &Node, depth: usize, places: &mut Places) {
        let inner: Vec<(String, &Node)> = match &node.value {
            Value::Table(entries) => entries.iter().map(|e| (format!("{path}.{}", e.key), &e.node)).collect(),
            Value::Array(items) => items.iter().enumerate().map(|(i, item)| (format!("{path}.{i}"), item)).collect(),
            _ => vec![],
        };
        if depth > 2 || depth == 2 && !matches!(node.value, Value::Table(_)) {
            places.insert(of_place(&node.place), (path.into(), node.clone()));
        }
        inner.iter().for_each(|(path, node)| walk(path, node, depth + 1, places));
    }
    let mut places = HashMap::new();
    let tables = entries.iter().filter(|entry| tables.contains(&entry.key.as_str()));
    tables.for_each(|entry| walk(&entry.key, &entry.node, 1, &mut places));
    places
}

fn of_place(place: &Place) -> (usize, usize, usize) {
    (place.source, place.span.start, place.span.end)
}

/// Gives the report the keys of the moved values, so that messages name the keys in the tables. A parameter that is overridden keeps its
/// own name.
pub(super) fn call(
    names: Vec<(String, Node)>,
    homes: Vec<(String, Home)>,
    places: &Places,
    entries: &[KeyEntry],
    report: &mut Report,
) {
    for (name, moved) in names {
        let mut path = name.split('.');
        let table = path.next().and_then(|table| keys::get(entries, table));
        let Some(Node { value: Value::Table(table), .. }) = table else { continue };
        let used = path.next().and_then(|key| keys::get(table, key));
        // An override of the parameter has another source.
        let stays = used.is_some_and(|node| node.place.source == moved.place.source);
        let Some((key, stated)) = places.get(&of_place(&moved.place)).filter(|_| stays) else { continue };
        // A base radius that is computed from a module is not the value at the key, and keeps its own name. Laws of planets have an
        // additional phase.
        let is_table = [&stated.value, &moved.value].iter().any(|value| matches!(value, Value::Table(_)));
        if is_table || stated.is_same(&moved) {
            report.stated.written(name, key.clone());
        }
    }
    homes.into_iter().for_each(|(name, home)| report.stated.belongs(name, home));
}
