//! Reads the effects of a scene, and checks that they agree.

use super::Effects;
use super::document::Node;
use super::mistake::{Report, list};
use super::{field, unknown_effect};
use crate::model::Model;

/// The names that a scene may use: those of all effects, and for effects of single parts also the name for all parts.
pub fn allowed(model: &Model) -> Vec<&'static str> {
    let mut names = vec![];
    for effect in model.effects {
        names.extend(effect.of.filter(|of| !names.contains(of)));
        names.push(effect.name);
    }
    names
}

/// Reads `effects`.
pub(super) fn read(node: &Node, model: &Model, report: &mut Report) -> Option<Effects> {
    let allowed = allowed(model);
    let names =
        field::names_or("effects", node, "effect", (&allowed, &|name| unknown_effect::help(name, model)), report)?;
    // Each effect with the name that the scene uses for it: the name for all parts, or its own.
    let mut chosen: Vec<(usize, &str)> = vec![];
    for name in names {
        let numbers = Effects::numbers(allowed[name], model);
        let new = numbers.into_iter().filter(|i| !chosen.iter().any(|(known, _)| known == i));
        chosen.extend(new.map(|i| (i, allowed[name])).collect::<Vec<_>>());
    }
    let set = Effects::numbered(model, chosen.iter().map(|(i, _)| *i));
    // An effect for all parts lacks the same at each part. Named for all parts, these messages are equal, and the report keeps one.
    let of_all = |named: &str, other: &'static str| {
        let of = model.effects.iter().find(|effect| effect.name == other).and_then(|effect| effect.of);
        of.filter(|_| model.effects.iter().any(|effect| effect.of == Some(named))).unwrap_or(other)
    };
    for (n, &(i, name)) in chosen.iter().enumerate() {
        let effect = &model.effects[i];
        let lacking = effect.requires.iter().filter(|other| !set.has(other, model));
        let lacking: Vec<_> = lacking.map(|other| of_all(name, other)).collect();
        if !lacking.is_empty() {
            let message = format!("effect `{name}` needs {}", list(&lacking));
            let help = format!("add {}, or leave out `{name}`", list(&lacking));
            report.add(&node.place, message, "an effect is missing", help);
        }
        for (other, its) in chosen[..n].iter().map(|(j, its)| (&model.effects[*j], its)) {
            if effect.excludes.contains(&other.name) || other.excludes.contains(&effect.name) {
                let message = format!("effects `{its}` and `{name}` contradict each other");
                let help = format!("leave out `{its}` or `{name}`");
                report.add(&node.place, message, "not both", help);
            }
        }
    }
    Some(set)
}
