//! Scene keys of friction laws that stiffnesses do not have: `teeth_of` computes the law from the teeth of another law.

use super::document::{KeyEntry, Node, Value};
use super::keys::{Key, Kind, key};
use super::mistake::{Home, Report, list};
use super::teeth::TeethReader;
use super::{field, keys, mesh_phase};
use crate::model::{Law, Model};
use crate::profile::Profile;
use indexmap::{IndexMap, IndexSet};

/// Key that names the law whose teeth are used.
pub(super) const OF: &str = "teeth_of";

/// Keys of friction laws that other laws do not have.
pub(super) const KEYS: &[Key] =
    &[key(OF, Kind::Name("a law with teeth"), "none", "the law whose gears are used; then no other key")];

/// Example line for a missing friction law. It names the stiffness with the same suffix: `k2` for `side2`.
pub(super) fn example(law: &Law, model: &Model) -> String {
    let part = |law: &Law| law.name.trim_start_matches(|c: char| c.is_alphabetic());
    let of_mesh = model.laws.iter().find(|other| other.with.is_none() && part(other) == part(law));
    let of_mesh = of_mesh.map_or("...", |law| law.name);
    format!("{OF} = \"{of_mesh}\"  # or its own teeth, or steps")
}

/// Reports friction laws of a train that cannot be computed, because the stiffnesses of their meshes have no teeth. `lacking` has these
/// laws, each with the place of its stiffness.
pub(super) fn without_teeth(lacking: Vec<(Home, &Law)>, report: &mut Report) {
    let mut tables: IndexMap<String, (Home, IndexSet<&str>, Vec<&str>)> = IndexMap::new();
    for (home, law) in lacking {
        let table = tables.entry(home.title.clone()).or_insert_with(|| (home.clone(), IndexSet::new(), vec![]));
        table.1.insert(home.key);
        table.2.push(law.name);
    }
    for (title, (home, keys, laws)) in tables {
        let keys: Vec<_> = keys.into_iter().collect();
        let message = format!("{title} has friction, but no teeth in {}", list(&keys));
        let law = format!("{} = {{ teeth = [..., ...], module = \"... mm\", face_width = \"... mm\" }}", keys[0]);
        let stated = list(&laws[..laws.len().min(2)]);
        let more = if laws.len() > 2 { ", and those of its other meshes" } else { "" };
        let help = format!(
            "friction follows from the teeth of a stiffness, for example\n{law}\nor state the laws {stated} in [laws]{more}"
        );
        report.add(&home.place, message, "teeth are needed", help);
    }
}

/// Reads a law with `teeth_of`. `None` if it does not have this key, `Some(None)` if a mistake was found.
pub(super) fn from_teeth_of(
    law: &Law,
    phase_unit: &str,
    node: &Node,
    laws: &[KeyEntry],
    report: &mut Report,
) -> Option<Option<Profile>> {
    let Value::Table(entries) = &node.value else { return None };
    let name = keys::get(entries, OF).filter(|_| law.role.is_friction())?;
    keys::known(entries, &format!("[laws.{}] with {OF}", law.name), &[KEYS], report);
    let path = format!("laws.{}.{OF}", law.name);
    let Some(text) = field::text(&path, name, report) else { return Some(None) };
    let of_teeth = |entry: &&KeyEntry| matches!(&entry.node.value, Value::Table(t) if keys::get(t, "teeth").is_some());
    let lenders: Vec<_> = laws.iter().filter(of_teeth).filter(|entry| entry.key != law.name).collect();
    let Some((lender, Value::Table(entries))) =
        lenders.iter().find(|entry| entry.key == text).map(|entry| (&entry.node, &entry.node.value))
    else {
        let with: Vec<_> = lenders.iter().map(|entry| entry.key.as_str()).collect();
        let help = match &with[..] {
            [] => "give this law its own teeth = [24, 96], module = \"... mm\", face_width = \"... mm\"; or steps"
                .to_string(),
            _ => keys::choices(text, &with),
        };
        report.add(&name.place, format!("`laws.{text}` is not given by its teeth"), "no teeth there", help);
        return Some(None);
    };
    // Mistakes in the keys of the other law are reported when that law is read, so they are dropped here.
    let mut ignored = Report::new();
    let shift =
        keys::get(entries, "phase").map_or(Some(0.0), |node| mesh_phase::read(law, phase_unit, 1, node, &mut ignored));
    let teeth = TeethReader { law, entries, place: &lender.place };
    let read = match teeth.friction_law(&mut ignored) {
        Some(Err(error)) if ignored.is_empty() => {
            teeth.refused(&name.place, error, report);
            None
        }
        read => read.and_then(Result::ok),
    };
    Some(read.and_then(|law| {
        let begins = law.origin - shift?;
        Some(law.with_origin(begins))
    }))
}
