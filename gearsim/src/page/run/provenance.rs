//! What made the result.

use super::Report;
use crate::page::html::Html;

/// Writes the section.
pub(super) fn fill(report: &Report<'_>, html: &mut Html) {
    let summary = report.run.summary;
    let provenance = &summary.provenance;
    html.pairs([
        ("program", format!("{} {}", provenance.program, provenance.version)),
        ("commit", provenance.commit.clone().unwrap_or_else(|| "not known".into())),
        ("scene, SHA-256", provenance.scene_sha256.clone()),
        ("solver", provenance.solver.clone()),
        ("values set", if provenance.overrides.is_empty() { "none".into() } else { provenance.overrides.join("; ") }),
        ("other files", summary.files.join(", ")),
    ]);
}
