//! The model: its source, the effects of the scene, and its equations.

use crate::page::html::{Html, TableCell};
use crate::scene::Scene;

/// Writes the section.
pub fn fill(scene: &Scene, html: &mut Html) {
    let model = scene.model;
    html.pairs([("model", model.name), ("title", model.title), ("source", model.source)]);
    let (active, others): (Vec<_>, Vec<_>) =
        model.effects.iter().enumerate().partition(|(i, _)| scene.effects.contains(*i));
    let effects = active.into_iter().chain(others).map(|(i, effect)| {
        let active = if scene.effects.contains(i) { "yes" } else { "no" };
        vec![TableCell::text(effect.name), TableCell::text(active), TableCell::text(effect.doc)]
    });
    html.table("Effects", &["effect", "in this scene", "what it is"], &effects.collect::<Vec<_>>());
    html.code("Equations, with all effects", model.equations, false);
}
