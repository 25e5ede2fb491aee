//! Prints the natural frequencies and damping factors of a drivetrain at the mid stiffness of its mesh, and at half of it.
//!
//! `cargo run --release --example natural_frequencies`, from the root of the repository.

use gearsim::analysis::modes::CellModes;
use gearsim::{Error, Scene};

fn main() -> Result<(), Error> {
    for cell in cells("models/scenes/gear_pair_shafts.toml", &[1.0, 0.5])? {
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

/// The modes of the scene in the file `path`, with all stiffnesses at multiples of their mid values.
pub fn cells(path: &str, factors: &[f64]) -> Result<Vec<CellModes>, Error> {
    let scene = Scene::load(path)?;
    let mids = scene.modes()?.levels;
    let scaled = |factor: &f64| scene.modes_at(&mids.iter().map(|k| k * factor).collect::<Vec<_>>());
    factors.iter().map(scaled).collect()
}
