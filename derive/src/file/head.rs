//! The comments of a generated file: at its head what it is, at its end what is proved.

use super::operations;
use super::wrap::prose;
use crate::Home;
use crate::derivation::Derivation;

/// The comment at the head of the file: what it is and where it comes from.
pub(super) fn head(d: &Derivation, home: Home<'_>) -> String {
    let (name, title) = (&d.model.name, one_line(&d.model.title));
    let (energies, command) = (home.described_in(name), home.command);
    let says = [
        format!("Equations of motion of `{name}`: {title}."),
        String::new(),
        format!("Derived from the energies in `{energies}` by `{command} {name}`."),
        "Do not edit: change the energies and derive again.".into(),
        format!("For reading: `text/{name}.txt`, `latex/{name}.tex`. What is proved: at the end."),
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

/// The text without line breaks and other control characters, which would end the comment.
fn one_line(text: &str) -> String {
    text.replace(char::is_control, " ")
}
