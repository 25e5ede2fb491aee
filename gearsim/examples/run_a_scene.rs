//! Runs a scene from its TOML file; prints its events, its energy balance, and the range of each coordinate and speed.
//!
//! `cargo run --release --example run_a_scene`, from the root of the repository.

use std::path::Path;

use anyhow::{Context, anyhow};
use gearsim::generated::MODELS;
use gearsim::run::Outcome;
use gearsim::scene::Scene;

fn main() -> anyhow::Result<()> {
    let outcome = run("models/scenes/two_stage.toml")?;
    let run = &outcome.trajectory;
    println!("{} cell changes, {} reflections", outcome.counts.cell_changes, outcome.counts.reflections);
    println!("energy unaccounted for: {:.1e} J of {:.1} J", run.residual[run.len() - 1], run.largest_energy());
    for (i, coordinate) in run.model.coordinates.iter().enumerate() {
        let ([low, high], [slow, fast]) = (range(&run.q[i]), range(&run.q_dot[i]));
        let (name, unit) = (coordinate.name, coordinate.unit);
        println!("{name}: {low:.4e} to {high:.4e} {unit}, speed {slow:.4e} to {fast:.4e} {unit}/s");
    }
    Ok(())
}

/// What a run of the scene in the file `path` gives.
pub fn run(path: &str) -> anyhow::Result<Outcome> {
    let models: Vec<_> = MODELS.iter().map(|entry| entry.model).collect();
    let scene = Scene::load(Path::new(path), &[], &models).map_err(|errors| anyhow!(errors.render(100, false)))?;
    let entry = MODELS.iter().find(|entry| entry.model.name == scene.model.name).context("no such model")?;
    Ok(entry.run(&scene, &mut |_| {})?)
}

/// The smallest and the largest value.
pub fn range(x: &[f64]) -> [f64; 2] {
    [x.iter().copied().fold(f64::INFINITY, f64::min), x.iter().copied().fold(f64::NEG_INFINITY, f64::max)]
}
