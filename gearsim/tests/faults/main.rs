//! Faults on purpose: every command is run with every fault of [`KINDS`]. Afterwards its folder holds all files of the earlier result, or
//! all of the new one, or the marker of an incomplete folder. Every file can be read. The same command run again makes the new result.
//!
//! A table of the number of cases is printed at the end: `cargo test -p gearsim --test faults`. To add a command, add one entry in
//! `commands.rs`. To add a fault, add one file in `kinds/` and one line in [`KINDS`].

#![cfg(unix)]

mod case;
mod commands;
mod fault;
mod kinds;
mod prepared;
mod readable;
mod state;
mod strace;

use std::fmt::Write as _;
use std::io::Write as _;

use rayon::prelude::*;

use commands::{COMMANDS, Command};
use kinds::KINDS;
use prepared::Prepared;

/// The results of the cases of one command.
struct Row {
    name: &'static str,
    /// The number of cases of each kind.
    counts: Vec<usize>,
    /// The number of cases in which the folder said that it is incomplete.
    incomplete: usize,
    failures: Vec<String>,
}

fn row(command: &'static Command) -> Row {
    let root = tempfile::tempdir().unwrap();
    let prepared = Prepared::new(command, root.path());
    let mut row = Row { name: command.name, counts: vec![], incomplete: 0, failures: vec![] };
    for (kind, faults) in KINDS {
        let faults = faults(&prepared);
        row.counts.push(faults.len());
        for fault in faults {
            match case::run(&prepared, &fault) {
                Ok(state) => row.incomplete += usize::from(state == state::State::Incomplete),
                Err(why) => row.failures.push(format!("{}, {kind}, {}: {why}", command.name, fault.what)),
            }
        }
    }
    row
}

/// The number of cases of each command and kind, for the terminal.
fn table(rows: &[Row]) -> String {
    let mut text = format!("{:16}", "");
    for (kind, _) in KINDS {
        write!(text, "{kind:>14}").unwrap();
    }
    writeln!(text, "{:>14}", "incomplete").unwrap();
    for row in rows {
        write!(text, "{:16}", row.name).unwrap();
        for count in row.counts.iter().chain([&row.incomplete]) {
            write!(text, "{count:14}").unwrap();
        }
        text.push('\n');
    }
    text
}

/// Writes to stderr directly, because the test harness captures the output of `eprint!`.
fn say(text: &str) {
    std::io::stderr().write_all(text.as_bytes()).unwrap();
}

#[test]
fn every_command_leaves_a_whole_result_or_says_incomplete_at_every_fault() {
    let rows: Vec<Row> = COMMANDS.par_iter().map(row).collect();
    say(&table(&rows));
    let failures: Vec<_> = rows.into_iter().flat_map(|row| row.failures).collect();
    assert!(failures.is_empty(), "{} cases failed:\n{}", failures.len(), failures.join("\n"));
}
