//! Warnings of values and parts that a scene states without the effect that they need.

use std::collections::HashSet;

use super::document::KeyEntry;
use super::mistake::Report;
use super::{Effects, keys};
use crate::model::Model;
use indexmap::{IndexMap, IndexSet};

/// Tables of a train whose parts do nothing without an effect.
const OF_EFFECTS: [&str; 5] = ["drives.", "loads.", "bearings.", "clutches.", "end_stops."];

/// Warns of torques, and of parts of a train, that a scene describes without their effect. Other parameters of effects, such as a backlash,
/// may stay in a scene whose effects change. `is_zero` says whether parameter `i` is 0 at all times; it then needs no warning.
pub(super) fn warn(
    given: &[KeyEntry],
    model: &Model,
    effects: Option<&Effects>,
    is_zero: &dyn Fn(usize) -> bool,
    report: &mut Report,
) {
    let Some(effects) = effects else { return };
    let is_part = |key: &str| OF_EFFECTS.iter().any(|table| key.starts_with(table));
    let part = |key: &str| key.split('.').take(2).collect::<Vec<_>>().join(".");
    // Parts with an active effect get no warning: a bearing with one kind of friction may state the other kind too.
    let active = model.parameters.iter().filter(|p| p.with.is_some_and(|effect| effects.has(effect, model)));
    let active: HashSet<_> =
        active.filter_map(|p| report.stated.key(&format!("parameters.{}", p.name))).map(part).collect();
    let mut without: IndexMap<&str, IndexSet<String>> = IndexMap::new();
    for (i, parameter) in model.parameters.iter().enumerate() {
        let Some(effect) = parameter.with.filter(|effect| !effects.has(effect, model)) else { continue };
        let name = format!("parameters.{}", parameter.name);
        let inert = match (report.stated.key(&name), report.stated.home(&name)) {
            _ if is_zero(i) => continue,
            (Some(key), _) if active.contains(&part(key)) => continue,
            (Some(key), _) if is_part(key) => format!("`{key}`"),
            // A part that does not state a value that its effect requires.
            (None, Some(home)) if parameter.default.is_none() && is_part(home.title.trim_start_matches('[')) => {
                home.title.clone()
            }
            _ if keys::get(given, parameter.name).is_none() => continue,
            _ if model.torques.iter().any(|torque| torque.with.contains(&effect)) => format!("`{name}`"),
            _ => continue,
        };
        let of = model.effects.iter().find(|known| known.name == effect).and_then(|known| known.of);
        without.entry(of.unwrap_or(effect)).or_default().insert(inert);
    }
    for (effect, names) in without {
        let (does, them) = if names.len() == 1 { ("does", "it") } else { ("do", "them") };
        let names = names.into_iter().collect::<Vec<_>>().join(" and ");
        let what = format!("add it to `effects`, or leave {them} out");
        report.warn(format!("{names} {does} nothing without the effect `{effect}`: {what}"));
    }
}
