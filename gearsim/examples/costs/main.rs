//! What grows with the number of coordinates, and how: time and memory of a cell change, compile time and size of derived
//! equations; and what a second core gains.
//!
//! `cargo xtask costs` writes tests/costs.md. Each row is measured in a process of its own; times are the least of several,
//! of processor time where one thread works.

mod compile;
mod planetary;
mod row;
mod table;
mod threads;
mod train;

use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, bail};
use clap::Parser;

use row::{ROWS, Row};

/// Measure what grows with the number of coordinates, and how.
#[derive(Parser)]
#[command(name = "cargo xtask costs")]
struct Arguments {
    /// The table
    #[arg(long, default_value = "tests/costs.md")]
    table: PathBuf,
    /// Measure one row, and print it
    #[arg(long, hide = true)]
    row: Option<usize>,
}

fn main() -> anyhow::Result<()> {
    let arguments = Arguments::parse();
    if let Some(i) = arguments.row {
        println!("{}", (ROWS[i].measure)()?.line());
        return Ok(());
    }
    let rows = (0..ROWS.len()).map(apart).collect::<anyhow::Result<Vec<_>>>()?;
    let text = table::write(&rows, &compile::all()?, &threads::all()?);
    std::fs::write(&arguments.table, &text).with_context(|| format!("cannot write {}", arguments.table.display()))?;
    println!("{text}\nwritten: {}", arguments.table.display());
    Ok(())
}

/// A row, measured in a process of its own: its peak of memory is of nothing else.
fn apart(i: usize) -> anyhow::Result<Row> {
    let name = ROWS[i].name;
    let output = Command::new(std::env::current_exe()?).args(["--row", &i.to_string()]).output()?;
    if !output.status.success() {
        bail!("the row `{name}` failed:\n{}", String::from_utf8_lossy(&output.stderr));
    }
    let line = String::from_utf8(output.stdout)?;
    eprintln!("{name}: {}", line.trim());
    Row::parse(&line).with_context(|| format!("the row `{name}` is no row: {line}"))
}
