//! The comment at the head of a generated file: what it is, where it comes from, its equations for people, what is proved.

use super::operations;
use crate::derivation::Derivation;
use crate::model::Role;
use crate::text::Texts;

/// The lines of the comment, each with its `//!`.
pub(super) fn write(d: &Derivation, texts: &Texts) -> String {
    let m = d.model;
    let mut lines = vec![
        format!("Equations of motion of `{}`: {}.", m.name, one_line(&m.title)),
        String::new(),
        format!(
            "Derived from the energies in `models/src/{}.rs` by `cargo xtask derive {}`. Do not edit: change the",
            described_in(&m.name),
            m.name
        ),
        "energies and derive again.".into(),
        format!("Source: {}", one_line(&m.source)),
    ];
    let mut section = |title: &str, fence: &str, content: &[String]| {
        lines.extend([String::new(), format!("# {title}"), String::new(), format!("```{fence}")]);
        lines.extend(content.iter().cloned());
        lines.push("```".into());
    };
    section("Energies", "text", &texts.energies);
    for (title, content) in
        [("Constants", &texts.constants), ("Deflections", &texts.deflections), ("Forces", &texts.forces)]
    {
        if !content.is_empty() {
            section(title, "text", content);
        }
    }
    section("Equations of motion", "text", &texts.motion);
    if !texts.jump.is_empty() {
        let errors = m.laws.iter().any(|law| law.role == Role::Error);
        let title =
            if errors { "At a step of a stiffness or a transmission error" } else { "At a step of a stiffness" };
        section(title, "text", &texts.jump);
    }
    section("Between two steps", "text", &texts.cell);
    section("LaTeX", "latex", &texts.latex);
    lines.extend([String::new(), "# Proved".into(), String::new()]);
    lines.extend(d.proofs.iter().map(|p| format!("- {p}")));
    lines.extend([String::new(), "# Operations, all effects present".into(), String::new()]);
    lines.extend(operations::table(d));
    lines.iter().map(|l| format!("//! {l}").trim_end().to_string()).collect::<Vec<_>>().join("\n")
}

/// The file stem in `models/src` of a model: `planetary_3` is the function of `planetary.rs` with 3 planets.
fn described_in(name: &str) -> &str {
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
    if stem.len() < name.len() { stem.strip_suffix('_').unwrap_or(name) } else { name }
}

/// The text without line breaks and other control characters, which would end the comment.
fn one_line(text: &str) -> String {
    text.replace(char::is_control, " ")
}
