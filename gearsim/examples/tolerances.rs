//! Draws 200 gear pairs whose backlash and damping scatter, and prints percentiles of the largest mesh force.
//!
//! `cargo run --release --example tolerances`, from the root of the repository.

use gearsim::{Error, Scene};

fn main() -> Result<(), Error> {
    let forces = largest_forces("models/scenes/response.toml", 200)?;
    for percent in [50, 90, 99] {
        println!("{percent} % of the pairs stay below {:.1} N", forces[(forces.len() - 1) * percent / 100]);
    }
    Ok(())
}

/// The largest mesh force of each of `samples` random pairs [N], in rising order.
pub fn largest_forces(path: &str, samples: usize) -> Result<Vec<f64>, Error> {
    let table = Scene::load(path)?
        .vary("parameters.b12=uniform:60 um:140 um")
        .vary("parameters.beta_K=uniform:2 us:4 us")
        .samples(samples, 1)
        .record(&["outputs"])
        .run()?;
    let mut forces = table.numbers("mesh_force_12_max").unwrap_or_default().to_vec();
    forces.sort_by(f64::total_cmp);
    Ok(forces)
}
