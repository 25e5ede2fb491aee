//! Runs a scene from its TOML file; prints its events, its energy balance, and the range of each recorded output.
//!
//! `cargo run --release --example run_a_scene`, from the root of the repository.

use gearsim::{Error, Results, Scene};

fn main() -> Result<(), Error> {
    let results = run("models/scenes/two_stage.toml")?;
    let run = results.trajectory();
    println!("{} events are recorded", results.events().count());
    println!("energy unaccounted for: {:.1e} J of {:.1} J", run.residual[run.len() - 1], run.largest_energy());
    for (name, output) in &results.summary().outputs {
        println!("{name}: {:.4e} to {:.4e} {}", output.min.0, output.max.0, output.unit);
    }
    Ok(())
}

/// Runs the scene in the file `path`.
pub fn run(path: &str) -> Result<Results, Error> {
    Scene::load(path)?.run()
}
