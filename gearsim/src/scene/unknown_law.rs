//! Help for an unknown law in `[laws]`.

use super::document::KeyEntry;
use super::keys;
use super::mistake::Report;
use crate::model::{Model, Parameter};

/// Reports the entries of `[laws]` that the model does not have. A parameter among them is constant, the stiffness of a shaft for example.
pub(super) fn refuse(entries: &[KeyEntry], model: &Model, report: &mut Report) {
    let names: Vec<_> = model.laws.iter().map(|law| law.name).collect();
    for KeyEntry { key, place, .. } in keys::unknown(entries, &names) {
        let constant = model.parameters.iter().find(|parameter| parameter.name == key);
        let (label, help) = if let Some(Parameter { doc, .. }) = constant {
            let stated = report.stated.place_of(&format!("parameters.{key}"));
            let help = format!("`{key}` ({doc}) is constant: state `{stated}` alone, and leave out [laws.{key}]");
            ("a constant", help)
        } else if names.is_empty() {
            ("unknown key", "no part of this scene has a law: leave out [laws]".into())
        } else {
            ("unknown key", keys::choices(key, &names))
        };
        report.add(place, format!("[laws] has no `{key}`"), label, help);
    }
}
