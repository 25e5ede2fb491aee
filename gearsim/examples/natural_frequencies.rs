//! Prints the natural frequencies and damping factors of a drivetrain for each combination of its mesh stiffness levels.
//!
//! `cargo run --release --example natural_frequencies`, from the root of the repository.

use std::path::Path;

use anyhow::{Context, anyhow};
use gearsim::analysis::modes::{self, CellModes};
use gearsim::analysis::steady;
use gearsim::generated::MODELS;
use gearsim::scene::Scene;

fn main() -> anyhow::Result<()> {
    for cell in cells("models/scenes/gear_pair_shafts.toml")? {
        println!("mesh stiffness {:.4e} N/m", cell.levels[0]);
        for mode in cell.modes {
            match mode.zeta {
                None => println!("  rigid motion"),
                Some(zeta) => println!("  {:9.3} Hz, damping factor {zeta:.4}", mode.natural),
            }
        }
    }
    Ok(())
}

/// The modes of each cell of the scene in the file `path`.
pub fn cells(path: &str) -> anyhow::Result<Vec<CellModes>> {
    let models: Vec<_> = MODELS.iter().map(|entry| entry.model).collect();
    let scene = Scene::load(Path::new(path), &[], &models).map_err(|errors| anyhow!(errors.render(100, false)))?;
    let entry = MODELS.iter().find(|entry| entry.model.name == scene.model.name).context("no such model")?;
    let system = entry.system(&scene)?;
    let levels = modes::combinations(&steady::courses(&scene, &system)?);
    Ok(levels.iter().map(|levels| modes::of(&system, levels, &[])).collect::<Result<_, _>>()?)
}
