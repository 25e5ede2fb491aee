//! Measures how run time, memory and compile time grow with the number of coordinates; `cargo xtask costs` starts it.
//!
//! It writes one of the two parts of tests/costs.md and keeps the other. Without options it measures time and memory of a cell change and
//! the gain by a second core; with `--compile`, the compile times of the models, of gearsim and of its dependencies.

mod build;
mod compile_table;
mod format;
mod many_effects;
mod models;
mod planetary;
mod processor_time;
mod row;
mod run_table;
mod threads;
mod train;

use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, bail};
use clap::Parser;

use row::{ROWS, Row};

/// Measure run time and memory against the number of coordinates, or compile times.
#[derive(Parser)]
#[command(name = "cargo xtask costs")]
struct Arguments {
    /// The file with the tables
    #[arg(long, default_value = "tests/costs.md")]
    table: PathBuf,
    /// Measure compile times instead
    #[arg(long)]
    compile: bool,
    /// Measure one row and print it
    #[arg(long, hide = true)]
    row: Option<usize>,
}

fn main() -> anyhow::Result<()> {
    if let Some(status) = build::as_rustc()? {
        std::process::exit(status);
    }
    let arguments = Arguments::parse();
    if let Some(i) = arguments.row {
        println!("{}", (ROWS[i].measure)()?.line());
        return Ok(());
    }
    let old = std::fs::read_to_string(&arguments.table).unwrap_or_default();
    let (run, compile) = old.split_once(compile_table::TITLE).unwrap_or((&old, ""));
    let (run, compile) = if arguments.compile {
        (run.to_owned(), compile_table::write(&models::all()?, &models::of_effects()?, &build::gearsim()?))
    } else {
        let rows = (0..ROWS.len()).map(row).collect::<anyhow::Result<Vec<_>>>()?;
        (run_table::write(&rows, &threads::all()?), compile.to_owned())
    };
    let text = format!("{run}{}{compile}", compile_table::TITLE);
    std::fs::write(&arguments.table, &text).with_context(|| format!("cannot write {}", arguments.table.display()))?;
    println!("{text}\nwritten: {}", arguments.table.display());
    Ok(())
}

/// Row `i`, measured in a process of its own, so that its peak of memory is not that of another row.
fn row(i: usize) -> anyhow::Result<Row> {
    let name = ROWS[i].name;
    let output = Command::new(std::env::current_exe()?).args(["--row", &i.to_string()]).output()?;
    if !output.status.success() {
        bail!("the row `{name}` failed:\n{}", String::from_utf8_lossy(&output.stderr));
    }
    let line = String::from_utf8(output.stdout)?;
    eprintln!("{name}: {}", line.trim());
    Row::parse(&line).with_context(|| format!("the row `{name}` cannot be read: {line}"))
}
