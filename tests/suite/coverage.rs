//! Models x effects x commands, from runs: the table tests/coverage.md. Every cell says "yes", or why not.
//!
//! With GEARSIM_COVERAGE=FILE the test writes the table to FILE: `cargo xtask coverage`. Without this variable it compares the table with
//! the committed one.

#[path = "coverage/commands.rs"]
mod commands;
#[path = "coverage/parts.rs"]
mod parts;
#[path = "common/effects.rs"]
mod scenes;

use std::fmt::Write;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use commands::COMMANDS;
use gearsim::Scene;

/// The table, in Markdown.
fn table() -> String {
    let sections = sections();
    let results = results(&sections);
    let mut reasons: Vec<String> = vec![];
    let mut text = String::from(
        "# What works with what\n\nMade by `cargo xtask coverage`: for each effect of each model a scene with this effect, and each command on it. An effect of several parts \
         is shown at all of them, and at the first alone. Of trains each kind of part is shown. A letter is a reason, listed at the end. Models that \
         differ in a number of parts are shown once.\n",
    );
    let names = COMMANDS.iter().map(|command| command.0).collect::<Vec<_>>().join(" | ");
    let mut results = results.into_iter();
    for Section { title, about, what, rows } in &sections {
        let _ =
            write!(text, "\n## {title}\n\n{about}\n\n| {what} | {names} |\n|{}\n", " --- |".repeat(COMMANDS.len() + 1));
        for (row, done) in rows.iter().zip(results.by_ref()) {
            let cells: Vec<String> = done.into_iter().map(|done| cell(done, &mut reasons)).collect();
            let _ = writeln!(text, "| {} | {} |", row.0, cells.join(" | "));
        }
    }
    text += "\n## Reasons\n\n";
    for (i, reason) in reasons.iter().enumerate() {
        let _ = writeln!(text, "- **{}**: {reason}", letter(i));
    }
    text
}

/// A table of the document.
struct Section {
    title: String,
    about: &'static str,
    /// The heading of its first column.
    what: &'static str,
    /// Its rows, each with its scene, or why there is none.
    rows: Vec<(&'static str, Result<Scene, String>)>,
}

/// The models with their effects, then the parts of trains.
fn sections() -> Vec<Section> {
    let of =
        |(title, about): (String, &'static str)| Section { rows: scenes::of(&title), title, about, what: "effect" };
    let rows = parts::scenes(scenes::T_END).into_iter().map(|(name, scene)| (name, Ok(scene))).collect();
    let about = "each kind of part that its tables list, alone beside a pair of gears or in a planetary stage: its table and key, or an effect that all have";
    let parts = Section { title: "train, part by part".into(), about, what: "part", rows };
    scenes::models().into_iter().map(of).chain([parts]).collect()
}

/// The results of the commands for each row, in the order of `COMMANDS`. The rows are shared among two threads.
fn results(sections: &[Section]) -> Vec<Vec<Result<(), String>>> {
    let scenes: Vec<&Result<Scene, String>> =
        sections.iter().flat_map(|section| &section.rows).map(|row| &row.1).collect();
    let done: Vec<OnceLock<_>> = scenes.iter().map(|_| OnceLock::new()).collect();
    let next = AtomicUsize::new(0);
    let work = || {
        loop {
            let i = next.fetch_add(1, Ordering::Relaxed);
            let Some(scene) = scenes.get(i) else { return };
            let all = COMMANDS.iter().map(|command| scene.as_ref().map_err(Clone::clone).and_then(command.1)).collect();
            let _ = done[i].set(all);
        }
    };
    std::thread::scope(|threads| {
        threads.spawn(work);
        threads.spawn(work);
    });
    done.into_iter().map(|row| row.into_inner().expect("each row is worked on")).collect()
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
