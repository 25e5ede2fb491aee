//! Runs a scene and writes its trajectory as CSV and as Parquet, and a plot of its motion as SVG.
//!
//! `cargo run --release --example write_a_table`, from the root of the repository.

use std::path::Path;

use anyhow::{Context, anyhow};
use gearsim::generated::MODELS;
use gearsim::output::{OutputFolder, Table, csv, parquet};
use gearsim::plot;
use gearsim::scene::Scene;

fn main() -> anyhow::Result<()> {
    let folder = write("models/scenes/backlash.toml", Path::new("out/write_a_table"))?;
    println!("written to {}: {}", folder.path().display(), folder.files().join(", "));
    Ok(())
}

/// Runs the scene in the file `path`, and writes its results to the folder `out`.
pub fn write(path: &str, out: &Path) -> anyhow::Result<OutputFolder> {
    let models: Vec<_> = MODELS.iter().map(|entry| entry.model).collect();
    let scene = Scene::load(Path::new(path), &[], &models).map_err(|errors| anyhow!(errors.render(100, false)))?;
    let entry = MODELS.iter().find(|entry| entry.model.name == scene.model.name).context("no such model")?;
    let outcome = entry.run(&scene, &mut |_| {})?;
    let (trajectory, reference_frequency) = (&outcome.trajectory, outcome.reference_frequency);
    let (label, none_from) = (scene.name.as_str(), None);
    let asked = &scene.output;
    let run = plot::Run { label, trajectory, reference_frequency, scene: label, asked, none_from };
    let table = Table::of_trajectory(trajectory)?;

    let mut folder = OutputFolder::create(out)?;
    folder.write("trajectory.csv", |sink| csv::write(&table, sink))?;
    folder.write("trajectory.parquet", |sink| parquet::write(&table, [("scene", label)], sink))?;
    folder.write_bytes("motion.svg", (plot::find("motion")?.draw)(&[run])?.svg()?.as_bytes())?;
    folder.commit("trajectory.csv")?;
    Ok(folder)
}
