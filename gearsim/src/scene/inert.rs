//! Warnings of values and parts that a scene states without the effect that they need.

use indexmap::{IndexMap, IndexSet};

use super::document::{KeyEntry, Value};
use super::mistake::Report;
use super::parameters::Given;
use super::{Effects, keys};
use crate::model::Model;
use crate::profile::Profile;

/// Tables of a train whose parts do nothing without an effect.
const OF_EFFECTS: [&str; 5] = ["drives.", "loads.", "bearings.", "clutches.", "end_stops."];

/// Warns of parameters, laws and parts of a train that a scene describes without their effect. A value that is 0 at all times needs no
/// warning.
pub(super) fn warn(
    entries: &[KeyEntry],
    model: &Model,
    effects: &Effects,
    (parameters, laws): (&Given, &[Profile]),
    report: &mut Report,
) {
    let lacks = |with: Option<&'static str>| with.filter(|effect| !effects.has(effect, model));
    let mut without: IndexMap<&str, IndexSet<String>> = IndexMap::new();
    let mut inert = |effect: &'static str, what: String| {
        let of = model.effects.iter().find(|known| known.name == effect).and_then(|known| known.of);
        without.entry(of.unwrap_or(effect)).or_default().insert(what);
    };
    let is_zero = |i: usize| parameters.values[i] == 0.0 && !parameters.varying.iter().any(|(at, _)| *at == i);
    // Data of gears belong to their meshes, whatever uses them.
    let stated = model.parameters.iter().enumerate().filter(|(i, p)| !is_zero(*i) && p.gear_data.is_none());
    for (_, parameter) in stated {
        let Some(effect) = lacks(parameter.with) else { continue };
        let name = format!("parameters.{}", parameter.name);
        if is_given(entries, "parameters", parameter.name) {
            inert(effect, format!("`{}`", report.stated.key(&name).unwrap_or(&name)));
        } else if let Some(home) = report.stated.home(&name).filter(|_| parameter.default.is_none()) {
            // A part that does not state a value that its effect requires.
            if OF_EFFECTS.iter().any(|table| home.title.trim_start_matches('[').starts_with(table)) {
                inert(effect, home.title.clone());
            }
        }
    }
    for (law, _) in model.laws.iter().zip(laws).filter(|(_, law)| law.extremes() != (0.0, 0.0)) {
        if let Some(effect) = lacks(law.with).filter(|_| is_given(entries, "laws", law.name)) {
            let name = format!("laws.{}", law.name);
            inert(effect, format!("`{}`", report.stated.key(&name).unwrap_or(&name)));
        }
    }
    for (effect, names) in without {
        let (does, them) = if names.len() == 1 { ("does", "it") } else { ("do", "them") };
        let names = names.into_iter().collect::<Vec<_>>().join(" and ");
        let what = format!("add it to `effects`, or leave {them} out");
        report.warn(format!("{names} {does} nothing without the effect `{effect}`: {what}"));
    }
}

/// Whether the scene states the value `name` of a table.
fn is_given(entries: &[KeyEntry], table: &str, name: &str) -> bool {
    let Some(Value::Table(given)) = keys::get(entries, table).map(|node| &node.value) else { return false };
    keys::get(given, name).is_some()
}
