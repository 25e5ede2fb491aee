//! The scene: its text as read, the values set on the command line, and the parameters in SI units.

use crate::page::html::{Html, TableCell};
use crate::scene::Scene;

/// Writes the section.
pub fn fill(scene: &Scene, html: &mut Html) {
    html.code(&format!("{}.toml, as read", scene.name), &scene.text, true);
    if !scene.overrides.is_empty() {
        html.code("Values set on the command line", &scene.overrides.join("\n"), true);
    }
    let parameters = scene.model.parameters.iter().zip(&scene.parameters);
    let rows = parameters.filter(|(_, value)| value.is_finite()).map(|(parameter, value)| {
        vec![
            TableCell::text(parameter.name),
            TableCell::Number(*value),
            TableCell::text(parameter.unit),
            TableCell::text(parameter.doc),
        ]
    });
    html.table("Parameters", &["name", "value", "SI unit", "what it is"], &rows.collect::<Vec<_>>());
}
