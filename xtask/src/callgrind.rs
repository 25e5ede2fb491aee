//! Counts of instructions under callgrind. Unlike times, the counts of a program are the same in every run.

use std::path::Path;
use std::process::Command;

use anyhow::{Context, bail};

/// Counts the instructions that a program executes in the functions whose names match `within`, a pattern of callgrind. Returns the count and what
/// the program prints.
///
/// # Errors
/// If valgrind cannot be started, the program fails, or nothing is counted.
pub fn instructions(within: &str, program: &Path, arguments: &[&str]) -> anyhow::Result<(f64, String)> {
    let mut command = Command::new("valgrind");
    command.args(["--tool=callgrind", "--callgrind-out-file=/dev/null", &format!("--toggle-collect={within}")]);
    let output = command.arg(program).args(arguments).output();
    let output = output.context("cannot start valgrind: install it (Debian: apt-get install valgrind)")?;
    let log = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        bail!("`{} {}` failed under callgrind:\n{log}", program.display(), arguments.join(" "));
    }
    let collected = log.lines().find_map(|line| line.split("Collected :").nth(1));
    let count: f64 = collected.context("callgrind counted nothing")?.trim().parse()?;
    Ok((count, String::from_utf8(output.stdout)?))
}
