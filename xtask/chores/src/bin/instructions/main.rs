//! The program of `cargo xtask instructions`: it counts the instructions that the main code paths execute.
//!
//! It writes tests/instructions.md. With `--check` it writes nothing, and fails if a count differs from the table by more than
//! 3 %. Each path runs in a process of its own under callgrind, which counts the instructions executed in `measured` alone.

mod bare;
mod by_hand;
mod paths;
mod sides;
mod table;

use std::path::PathBuf;

use anyhow::{Context, bail};
use clap::Parser;
use xtask::callgrind::instructions;

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
    let (count, printed) = instructions("*instructions::measured*", &itself, &["--path", path.name])?;
    let items: f64 = printed.trim().parse()?;
    if count < items {
        bail!("callgrind counted {count} instructions for {items} items of `{}`", path.name);
    }
    Ok(count / items)
}
