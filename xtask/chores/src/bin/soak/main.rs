//! A long run without damping: how the energy error of an aperiodic motion grows with the number of events.
//!
//! `cargo xtask soak --events 1e8` writes `out/soak`: a table, the same as JSON, and a plot of the energy error. It fails if
//! the error reaches the limit, or if it grows faster than independent rounding errors do.

mod growth;
mod report;
mod walk;

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, bail};
use clap::Parser;

use growth::Growth;
use walk::Walk;

/// Run an undamped gear pair for very many events, and measure its energy error.
#[derive(Parser)]
#[command(name = "cargo xtask soak")]
struct Arguments {
    /// Number of events: cell changes and reflections
    #[arg(long, default_value = "1e8", value_parser = number)]
    events: u64,
    /// Arithmetic that carries the state: "compensated" or "plain"
    #[arg(long, default_value = "compensated", value_parser = ["compensated", "plain"])]
    precision: String,
    /// Folder to write to
    #[arg(long, default_value = "out/soak")]
    out: PathBuf,
}

/// A whole number; `1e8` is one too.
fn number(text: &str) -> Result<u64, String> {
    match text.parse::<f64>() {
        Ok(n) if (1e3..=1e15).contains(&n) && n.fract() == 0.0 => Ok(n as u64),
        _ => Err("must be a whole number from 1e3 to 1e15".into()),
    }
}

fn main() -> anyhow::Result<()> {
    let arguments = Arguments::parse();
    let walk = Walk::run(arguments.events, &arguments.precision)?;
    let growth = Growth::of(&walk);
    let command =
        format!("cargo xtask soak --events {:e} --precision {}", arguments.events as f64, arguments.precision);
    let (text, out) = (report::markdown(&walk, &growth, &command), &arguments.out);
    let figure = report::figure(&walk, &growth);
    fs::create_dir_all(out).with_context(|| format!("cannot make the folder {}", out.display()))?;
    fs::write(out.join("soak.md"), &text)?;
    fs::write(out.join("soak.json"), format!("{:#}\n", report::json(&walk, &growth, &command)))?;
    fs::write(out.join("energy.svg"), figure.svg()?)?;
    fs::write(out.join("energy.png"), figure.png()?)?;
    println!("{text}\nwritten: {}", out.display());
    let faults = growth.faults();
    if !faults.is_empty() {
        bail!("{}", faults.join("; "));
    }
    Ok(())
}
