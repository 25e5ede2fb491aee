//! What of a law of friction is not as of a stiffness: it may be had from the teeth by which another law is stated.

use super::document::{Entry, Node, Value};
use super::error::Report;
use super::teeth::{self, Teeth};
use super::{field, keys, offset};
use crate::model::{Law, Model};
use crate::profile::Profile;

/// Key that names the law with the teeth.
pub(super) const OF: &str = "teeth_of";

/// What a law of friction has of the keys of teeth: the gears, and how pairs share the force.
pub(super) fn keys_of_teeth() -> impl Iterator<Item = &'static str> {
    teeth::KEYS.into_iter().filter(|key| !["course", "line_load"].contains(key))
}

/// What to write for a law that is missing.
pub(super) fn example(law: &Law, model: &Model) -> String {
    let part = |law: &Law| law.name.trim_start_matches(|c: char| c.is_alphabetic());
    let of_mesh = model.laws.iter().find(|other| other.with.is_none() && part(other) == part(law));
    let of_mesh = of_mesh.map_or("...", |law| law.name);
    format!("{OF} = \"{of_mesh}\"  # or teeth of its own, or steps")
}

/// The law by the teeth of another, if it is stated so; `Some(None)` if that is wrong.
pub(super) fn borrowed(
    law: &Law,
    phase: &str,
    node: &Node,
    laws: &[Entry],
    report: &mut Report,
) -> Option<Option<Profile>> {
    let Value::Table(entries) = &node.value else { return None };
    let name = keys::get(entries, OF).filter(|_| law.role.rubs())?;
    keys::known(entries, &format!("[laws.{}] with {OF}", law.name), &[OF], report);
    let path = format!("laws.{}.{OF}", law.name);
    let Some(text) = field::text(&path, name, report) else { return Some(None) };
    let of_teeth = |entry: &&Entry| matches!(&entry.node.value, Value::Table(t) if keys::get(t, "teeth").is_some());
    let lenders: Vec<_> = laws.iter().filter(of_teeth).filter(|entry| entry.key != law.name).collect();
    let Some((lender, Value::Table(entries))) =
        lenders.iter().find(|entry| entry.key == text).map(|entry| (&entry.node, &entry.node.value))
    else {
        let with: Vec<_> = lenders.iter().map(|entry| entry.key.as_str()).collect();
        let help = match &with[..] {
            [] => "give this law its own: teeth = [24, 96], module = \"... mm\"; or steps".to_string(),
            _ => keys::choices(text, &with),
        };
        report.add(&name.place, format!("`laws.{text}` is not given by its teeth"), "no teeth there", help);
        return Some(None);
    };
    // What is wrong with the keys of the other law is told of it.
    let mut told = Report::new();
    let ahead = keys::get(entries, "phase").map_or(Some(0.0), |node| offset::read(law, phase, 1, node, &mut told));
    let teeth = Teeth { law, entries, place: &lender.place };
    let read = match teeth.rubbing(&mut told) {
        Some(Err(error)) if told.is_empty() => {
            teeth.refused(&name.place, error, report);
            None
        }
        read => read.and_then(Result::ok),
    };
    Some(read.and_then(|law| {
        let begins = law.origin - ahead?;
        Some(law.beginning(begins))
    }))
}
