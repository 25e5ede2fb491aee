//! What is allowed instead of an effect that the model of a scene does not have.

use super::mistake::did_you_mean;
use super::{effects, keys, train};
use crate::model::Model;
use indexmap::IndexMap;

/// If an effect has at least this many parts, a message names only some of them.
const MANY: usize = 4;

/// Help for an unknown effect: the nearest name, and the allowed names. If many parts have an effect, only the first two and the last are
/// named.
pub(super) fn help(word: &str, model: &Model) -> String {
    let keys = if model.elements.is_empty() { vec![] } else { train::keys_of(word) };
    if !keys.is_empty() {
        let keys: Vec<_> = keys.iter().map(String::as_str).collect();
        return format!("no part of this train has it: state {}, or leave the effect out", either(&keys));
    }
    let mut parts: IndexMap<&str, Vec<&str>> = IndexMap::new();
    for effect in model.effects {
        parts.entry(effect.of.unwrap_or(effect.name)).or_default().push(effect.name);
    }
    if parts.values().all(|names| names.len() < MANY) {
        return keys::choices(word, &effects::allowed(model));
    }
    let quoted = |names: &[&str]| names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    let few = parts.iter().filter(|(_, names)| names.len() < MANY);
    let few =
        few.flat_map(|(kind, names)| if names[..] == [*kind] { vec![*kind] } else { [&[*kind], &names[..]].concat() });
    let few: Vec<_> = few.collect();
    let near = did_you_mean(word, effects::allowed(model)).map(|near| format!("did you mean `{near}`?"));
    let of_parts = parts.iter().filter(|(_, names)| names.len() >= MANY).map(|(kind, names)| {
        let last = names[names.len() - 1];
        format!("`{kind}` at all of {} parts, or at one: {}, ... `{last}`", names.len(), quoted(&names[..2]))
    });
    let few = (!few.is_empty()).then(|| format!("allowed: {}", quoted(&few)));
    near.into_iter().chain(few).chain(of_parts).collect::<Vec<_>>().join("\n")
}

/// Names of which one is needed.
fn either(names: &[&str]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(" or ")
}
