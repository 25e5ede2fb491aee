//! Runs a gear pair at several damping factors, and prints a table of its vibration.
//!
//! `cargo run --release --example vary_a_parameter`, from the root of the repository.

use std::path::Path;

use anyhow::Context;
use gearsim::generated::MODELS;
use gearsim::output::Table;
use gearsim::sweep::{Request, Sweep, row};

fn main() -> anyhow::Result<()> {
    let table = vary("models/scenes/oh2005/spectrum_4500rpm_exact.toml", "parameters.zeta=0.02,0.05,0.1,0.2")?;
    let column = |name| table.numbers(name).context("no such column");
    println!("zeta  rms of phi [rad]");
    for (zeta, rms) in column("parameters.zeta")?.iter().zip(column("phi_rms")?) {
        println!("{zeta:<4}  {rms:.4e}");
    }
    Ok(())
}

/// A row per value of the axis `vary`: the number of events, and extremes, means and rms values over the last 0.1 s of 0.2 s.
pub fn vary(path: &str, vary: &str) -> anyhow::Result<Table> {
    let request = Request {
        vary: vec![vary.into()],
        overrides: vec!["run.t_end=0.2 s".into()],
        samples: None,
        seed: 0,
        from: 0.1,
        record: vec!["events".into(), "extremes".into()],
        spectra: false,
    };
    let sweep = Sweep::load(Path::new(path), MODELS, &request)?;
    // One after another; for many points there is `Sweep::run`, which uses several threads.
    let rows: Vec<_> = (0..sweep.points).map(|point| sweep.point(point)).collect();
    let units = row::units(&sweep.plan, sweep.entry.model);
    Ok(row::table(&sweep.plan, &sweep.columns(), &units, &rows.iter().collect::<Vec<_>>())?)
}
