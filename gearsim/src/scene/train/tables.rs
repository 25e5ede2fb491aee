//! Moves the values in the tables of a train to `[parameters]` and `[laws]`, where the values of every model are.

use std::collections::HashMap;

use super::draft::Draft;
use super::{KEYS, called};
use crate::scene::document::{KeyEntry, Node, Place, Value};
use crate::scene::keys;
use crate::scene::mistake::Report;
use crate::scene::quantity::Quantity;

/// Moves the values, and removes the tables of the train from `entries`. `None` if a value is stated twice.
pub(super) fn fill(mut draft: Draft, entries: &mut Vec<KeyEntry>, end: &Place, report: &mut Report) -> Option<Draft> {
    let tables = keys::names(&[KEYS]);
    let places = called::places(entries, &tables);
    entries.retain(|entry| !tables.contains(&entry.key.as_str()));
    let before = report.len();
    let values = std::mem::take(&mut draft.values);
    let laws = std::mem::take(&mut draft.laws);
    let mut names = vec![];
    for (name, node) in &laws {
        // The value of a law that is constant.
        let value = if matches!(node.value, Value::Table(_)) { "" } else { ".steps.0.value" };
        names.extend(["", value].map(|value| (format!("laws.{name}{value}"), node.clone())));
    }
    for (name, node) in &values {
        let name = format!("parameters.{name}");
        // A value per squared radius is a table, which also has the radius.
        if let Value::Table(entries) = &node.value {
            let inner = entries.iter().map(|entry| (format!("{name}.{}", entry.key), entry.node.clone()));
            names.extend(inner);
        }
        names.push((name, node.clone()));
    }
    let laws = laws.into_iter().map(|(name, node)| (name, law(node))).collect();
    for (table, given) in [("parameters", values), ("laws", laws)] {
        if !given.is_empty() {
            add(table, given, &draft.fixed, entries, end, report);
        }
    }
    called::call(names, std::mem::take(&mut draft.homes), &places, entries, report);
    let laws = entries.iter_mut().find(|entry| entry.key == "laws");
    if let Some(KeyEntry { node: Node { value: Value::Table(stated), .. }, .. }) = laws {
        for (key, node) in std::mem::take(&mut draft.usual_laws) {
            if keys::get(stated, &key).is_none() {
                stated.push(KeyEntry { key, place: node.place.clone(), node });
            }
        }
    }
    (report.len() == before).then_some(draft)
}

/// A law that is written as one value is constant.
fn law(node: Node) -> Node {
    if matches!(node.value, Value::Table(_)) {
        return node;
    }
    let place = node.place.clone();
    let table = |key: &str, node: Node| {
        let entry = KeyEntry { key: key.into(), place: place.clone(), node };
        Node { value: Value::Table(vec![entry]), place: place.clone() }
    };
    let step = table("value", node);
    table("steps", Node { value: Value::Array(vec![step]), place: place.clone() })
}

fn add(
    table: &str,
    given: Vec<(String, Node)>,
    fixed: &[(String, String)],
    entries: &mut Vec<KeyEntry>,
    end: &Place,
    report: &mut Report,
) {
    let at = entries.iter().position(|entry| entry.key == table).unwrap_or_else(|| {
        let node = Node { value: Value::Table(vec![]), place: end.clone() };
        entries.push(KeyEntry { key: table.into(), place: end.clone(), node });
        entries.len() - 1
    });
    // Another type of value is reported where the table is read.
    let Value::Table(known) = &mut entries[at].node.value else { return };
    for (key, node) in given {
        match known.iter_mut().find(|entry| entry.key == key) {
            None => known.push(KeyEntry { key, place: node.place.clone(), node }),
            // An override of a table replaces what the text says.
            Some(entry) if entry.place.source < node.place.source => entry.node = node,
            // An override of the value replaces what the tables say, unless other values follow from it.
            Some(entry) if entry.place.source > node.place.source => {
                if let Some((_, path)) = fixed.iter().find(|fixed| table == "parameters" && fixed.0 == key) {
                    let message = format!("`{table}.{key}` follows from `{path}`, and so do other values");
                    report.add(&entry.place, message, "does not reach them", format!("set `{path}` instead"));
                }
            }
            Some(entry) => {
                let message = format!("`{table}.{key}` is stated twice");
                let also = line(&node.place, report);
                let help = format!("{also} gives it too; leave out one of them, or give the parts different names");
                report.add(&entry.place, message, "stated again", help);
            }
        }
    }
}

fn line(place: &Place, report: &Report) -> String {
    format!("`{}`", report.text(place).lines().next().unwrap_or_default())
}

/// The values of the geometric parameters, for the choice of coordinates; 1 for one that cannot be read, which is reported later.
pub(super) fn numbers(draft: &Draft, entries: &[KeyEntry]) -> HashMap<String, f64> {
    let usable = |x: &f64| x.is_finite() && *x > 0.0;
    draft.geometry.iter().map(|g| (g.name.clone(), number(entries, &g.name).filter(usable).unwrap_or(1.0))).collect()
}

/// The number that `[parameters]` states [SI].
pub(super) fn number(entries: &[KeyEntry], name: &str) -> Option<f64> {
    let table = entries.iter().find(|entry| entry.key == "parameters").map(|entry| &entry.node.value);
    let given: &[KeyEntry] = if let Some(Value::Table(given)) = table { given } else { &[] };
    match &given.iter().find(|entry| entry.key == name)?.node.value {
        Value::Number(x) => Some(*x),
        Value::Text(text) => Quantity::parse(text).ok().map(|quantity| quantity.value),
        _ => None,
    }
}
