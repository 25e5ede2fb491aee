//! Runs a gear pair at several damping factors on all cores, and prints a table of its vibration.
//!
//! `cargo run --release --example vary_a_parameter`, from the root of the repository.

use gearsim::output::Table;
use gearsim::{Error, Scene};

fn main() -> Result<(), Error> {
    let table = vary("models/scenes/oh2005/spectrum_4500rpm_exact.toml", "parameters.zeta=0.02,0.05,0.1,0.2")?;
    let column = |name| table.numbers(name).unwrap_or_default();
    println!("zeta  rms of phi [rad]");
    for (zeta, rms) in column("parameters.zeta").iter().zip(column("phi_rms")) {
        println!("{zeta:<4}  {rms:.4e}");
    }
    Ok(())
}

/// A table with a row per value of `axis`: the number of events, and extremes, means and rms values in the last 0.1 s of a run of 0.2 s.
pub fn vary(path: &str, axis: &str) -> Result<Table, Error> {
    let scene = Scene::load(path)?.with("run.t_end", "0.2 s")?;
    scene.vary(axis).record(&["events", "extremes"]).from(0.1).run()
}
