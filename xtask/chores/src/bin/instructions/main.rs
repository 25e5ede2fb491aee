//! Counts the instructions that the main code paths execute; `cargo xtask instructions` starts it. Unlike times, the counts of
//! one program are the same in every run.
//!
//! It writes tests/instructions.md. With `--check` it writes nothing, and fails if a count differs from the table by more than
//! 3 %. Each path runs in a process of its own under callgrind, which counts the instructions executed in `measured` alone.

mod bare;
mod by_hand;
mod paths;
mod sides;
mod table;

use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, bail};
use clap::Parser;

use paths::{PATHS, Path};
use table::Table;

/// Count the instructions of the main code paths under callgrind.
#[derive(Parser)]
#[command(name = "cargo xtask instructions")]
struct Arguments {
    /// Write nothing; fail if a count differs from the one in the table by more than 3 %
    #[arg(long)]
    check: bool,
    /// The file with the table
    #[arg(long, default_value = "tests/instructions.md")]
    table: PathBuf,
    /// Run one path without counting, and print its number of items
    #[arg(long, hide = true)]
    path: Option<String>,
}

fn main() -> anyhow::Result<()> {
    let arguments = Arguments::parse();
    if let Some(name) = arguments.path {
        let path = PATHS.iter().find(|path| path.name == name).context("there is no such path")?;
        println!("{}", measured(&mut *(path.prepare)()));
        return Ok(());
    }
    let counts = PATHS.iter().map(count).collect::<anyhow::Result<Vec<_>>>()?;
    let table = Table { counts };
    if arguments.check {
        let kept = std::fs::read_to_string(&arguments.table);
        let kept = kept.with_context(|| format!("cannot read {}", arguments.table.display()))?;
        return table.compare(&kept);
    }
    std::fs::write(&arguments.table, table.markdown())?;
    println!("{}written: {}", table.markdown(), arguments.table.display());
    Ok(())
}

/// Runs the job whose instructions are counted. Not inlined, because callgrind finds this function by its name.
#[inline(never)]
fn measured(job: &mut dyn FnMut() -> u64) -> u64 {
    job()
}

/// Instructions per item of a path.
fn count(path: &Path) -> anyhow::Result<f64> {
    let itself = std::env::current_exe()?;
    let mut command = Command::new("valgrind");
    command.args(["--tool=callgrind", "--callgrind-out-file=/dev/null", "--toggle-collect=*instructions::measured*"]);
    let output = command.arg(itself).args(["--path", path.name]).output();
    let output = output.context("cannot start valgrind: install it (Debian: apt-get install valgrind)")?;
    let (out, log) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    if !output.status.success() {
        bail!("the path `{}` failed under callgrind:\n{log}", path.name);
    }
    let collected =
        log.lines().find_map(|line| line.split("Collected :").nth(1)).context("callgrind counted nothing")?;
    let (collected, items): (f64, f64) = (collected.trim().parse()?, out.trim().parse()?);
    if collected < items {
        bail!("callgrind counted {collected} instructions for {items} items of `{}`", path.name);
    }
    Ok(collected / items)
}
