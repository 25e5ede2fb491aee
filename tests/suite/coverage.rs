//! Models x effects x commands, from runs: the table tests/coverage.md. Every cell says "yes", or why not.
//!
//! With GEARSIM_COVERAGE=FILE the run writes the table to FILE: `cargo xtask coverage`. Without, it compares it with the committed one.

#[path = "coverage/commands.rs"]
mod commands;
#[path = "common/effects.rs"]
mod scenes;

use std::fmt::Write;

use commands::COMMANDS;

/// The table, in Markdown.
fn table() -> String {
    let mut reasons: Vec<String> = vec![];
    let mut text = String::from(
        "# What works with what\n\nMade by `cargo xtask coverage`: for each effect of each model a scene with this effect, and each command on it. A letter is a reason, \
         listed at the end. Models that differ in a number of parts are shown once.\n",
    );
    let names = COMMANDS.iter().map(|command| command.0).collect::<Vec<_>>().join(" | ");
    for (model, about) in scenes::models() {
        let _ =
            write!(text, "\n## {model}\n\n{about}\n\n| effect | {names} |\n|{}\n", " --- |".repeat(COMMANDS.len() + 1));
        for (effect, scene) in scenes::of(&model) {
            let cells: Vec<String> = match &scene {
                Ok(scene) => COMMANDS.iter().map(|command| cell((command.1)(scene), &mut reasons)).collect(),
                Err(reason) => vec![cell(Err(reason.clone()), &mut reasons); COMMANDS.len()],
            };
            let _ = writeln!(text, "| {effect} | {} |", cells.join(" | "));
        }
    }
    text += "\n## Reasons\n\n";
    for (i, reason) in reasons.iter().enumerate() {
        let _ = writeln!(text, "- **{}**: {reason}", letter(i));
    }
    text
}

/// `yes`, or the letter of a reason, which is added if it is new.
fn cell(done: Result<(), String>, reasons: &mut Vec<String>) -> String {
    let Err(reason) = done else { return "yes".into() };
    let at = reasons.iter().position(|known| *known == reason).unwrap_or_else(|| {
        reasons.push(reason);
        reasons.len() - 1
    });
    letter(at)
}

/// a, b, ..., z, aa, ab, ...
fn letter(i: usize) -> String {
    let last = char::from(b'a' + (i % 26) as u8).to_string();
    if i < 26 { last } else { letter(i / 26 - 1) + &last }
}

#[test]
fn the_committed_table_is_what_runs_give() {
    let table = table();
    if let Some(file) = std::env::var_os("GEARSIM_COVERAGE") {
        std::fs::write(file, &table).unwrap();
        return;
    }
    let committed = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/coverage.md")).unwrap_or_default();
    for (new, old) in table.lines().zip(committed.lines()) {
        assert_eq!(new, old, "tests/coverage.md is not current: run `cargo xtask coverage`");
    }
    assert_eq!(table.lines().count(), committed.lines().count(), "tests/coverage.md: run `cargo xtask coverage`");
}
