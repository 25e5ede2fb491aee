//! The scene: its text as read, the values set on the command line, and the parameters in SI units.

use super::Report;
use crate::page::html::{Cell, Html};

/// Writes the section.
pub(super) fn fill(report: &Report<'_>, html: &mut Html) {
    let run = report.run;
    html.code(&format!("{}.toml, as read", run.scene.name), &run.scene.text, true);
    if !run.scene.overrides.is_empty() {
        html.code("Values set on the command line", &run.scene.overrides.join("\n"), true);
    }
    let parameters = run.scene.model.parameters.iter().zip(&run.scene.parameters);
    let rows = parameters.filter(|(_, value)| value.is_finite()).map(|(parameter, value)| {
        vec![Cell::text(parameter.name), Cell::Number(*value), Cell::text(parameter.unit), Cell::text(parameter.doc)]
    });
    html.table("Parameters", &["name", "value", "SI unit", "what it is"], &rows.collect::<Vec<_>>());
}
