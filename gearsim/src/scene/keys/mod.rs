//! The keys of tables: what they are, looking them up, reporting unknown and missing ones.

mod key;
mod reference;
mod schema;

pub(in crate::scene) use key::{Key, Kind, Named, REQUIRED, each, key};
pub(crate) use reference::reference;
pub(crate) use schema::schema;

use super::document::{KeyEntry, Node, Place};
use super::mistake::{Home, Report, did_you_mean, list};
use indexmap::IndexMap;

/// The value of a key; `None` if the table does not have it.
pub(super) fn get<'a>(entries: &'a [KeyEntry], key: &str) -> Option<&'a Node> {
    entries.iter().find(|entry| entry.key == key).map(|entry| &entry.node)
}

/// The entries whose keys are not allowed.
pub(super) fn unknown<'a>(entries: &'a [KeyEntry], allowed: &[&str]) -> impl Iterator<Item = &'a KeyEntry> {
    entries.iter().filter(|entry| !allowed.contains(&entry.key.as_str()))
}

/// Reports the keys of a table that are not in these lists.
pub(super) fn known(entries: &[KeyEntry], title: &str, allowed: &[&[Key]], report: &mut Report) {
    names_known(entries, title, &names(allowed), report);
}

/// The names of keys.
pub(super) fn names(keys: &[&[Key]]) -> Vec<&'static str> {
    keys.iter().flat_map(|keys| keys.iter()).map(|key| key.name).collect()
}

/// Reports the keys of a table that have none of these names.
pub(super) fn names_known(entries: &[KeyEntry], title: &str, allowed: &[&str], report: &mut Report) {
    for entry in unknown(entries, allowed) {
        let message = format!("{title} has no `{}`", entry.key);
        report.add(&entry.place, message, "unknown key", choices(&entry.key, allowed));
    }
}

/// Reports missing keys of a table, each given with an example line.
pub(super) fn missing(keys: &[(&str, String)], title: &str, place: &Place, report: &mut Report) {
    let names: Vec<_> = keys.iter().map(|(name, _)| *name).collect();
    let lines: Vec<_> = keys.iter().map(|(_, line)| line.as_str()).collect();
    if keys.is_empty() {
        return;
    }
    let tables = names.iter().any(|name| name.starts_with('['));
    let lines = lines.join(if tables { "\n\n" } else { "\n" });
    let message = format!("{title} lacks {}", list(&names));
    report.add(place, message, "add here", format!("add\n{lines}"));
}

/// Reports keys that tables of parts lack. Each key of a table is reported once, even if several values follow from it.
pub(super) fn missing_in_parts(lacking: Vec<(Home, String)>, report: &mut Report) {
    let mut tables: IndexMap<String, (Place, IndexMap<&str, String>)> = IndexMap::new();
    for (Home { title, key, place }, line) in lacking {
        tables.entry(title).or_insert_with(|| (place, IndexMap::new())).1.entry(key).or_insert(line);
    }
    for (title, (place, lines)) in tables {
        missing(&lines.into_iter().collect::<Vec<_>>(), &title, &place, report);
    }
}

/// The largest number of names that a message lists.
const MANY: usize = 60;
/// The number of names that a message shows if there are more than [`MANY`].
const SHOWN: usize = 12;

/// Help for an unknown name: the nearest allowed name, and all allowed names.
pub(super) fn choices(word: &str, allowed: &[&str]) -> String {
    let all = match allowed {
        [] => "nothing is allowed here".to_string(),
        [only] => format!("allowed: `{only}`"),
        // For example the rotors of a large train: nobody reads so many names.
        _ if allowed.len() > MANY => {
            let some: Vec<_> = allowed[..SHOWN].iter().map(|name| format!("`{name}`")).collect();
            format!(
                "allowed: {} and {} more, of which `{}` is the last",
                some.join(", "),
                allowed.len() - SHOWN,
                allowed[allowed.len() - 1]
            )
        }
        _ => format!("allowed: {}", list(allowed)),
    };
    match did_you_mean(word, allowed.iter().copied()) {
        Some(near) => format!("did you mean `{near}`?\n{all}"),
        None => all,
    }
}
