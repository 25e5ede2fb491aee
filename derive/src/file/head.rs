//! The comments of a generated file: at its head what it is, at its end what is proved.

use super::operations;
use super::wrap::prose;
use crate::derivation::Derivation;

/// The comment at the head of the file: what it is and where it comes from.
pub(super) fn head(d: &Derivation) -> String {
    let (name, title) = (&d.model.name, one_line(&d.model.title));
    let says = [
        format!("Equations of motion of `{name}`: {title}."),
        String::new(),
        format!(
            "Derived from the energies in `models/src/{}.rs` by `cargo xtask derive {name}`. Do not edit: change the energies and \
             derive again. For reading: `text/{name}.txt`, `latex/{name}.tex`. What is proved: at the end.",
            described_in(name)
        ),
    ];
    says.map(|text| prose(&text, "//!", "//!").trim_end().to_string()).join("\n")
}

/// The comment at the end of the file: what is proved, and how many operations the equations take.
pub(super) fn end(d: &Derivation) -> String {
    let mut lines = vec!["// Proved of these equations, symbolically:".to_string(), "//".into()];
    lines.extend(d.proofs.iter().map(|proof| prose(proof, "// -", "//   ")));
    lines.extend(["//".into(), "// Operations, all effects present:".into(), "//".into()]);
    lines.extend(operations::table(d).iter().map(|row| format!("// {row}")));
    lines.join("\n")
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
