//! What made the result.

use crate::output::summary::Provenance;
use crate::page::html::Html;

/// Writes the section.
pub fn fill(provenance: &Provenance, files: &[String], html: &mut Html) {
    html.pairs([
        ("program", format!("{} {}", provenance.program, provenance.version)),
        ("commit", provenance.commit.clone().unwrap_or_else(|| "not known".into())),
        ("scene, SHA-256", provenance.scene_sha256.clone()),
        ("solver", provenance.solver.clone()),
        ("values set", if provenance.overrides.is_empty() { "none".into() } else { provenance.overrides.join("; ") }),
        ("other files", files.join(", ")),
    ]);
}
