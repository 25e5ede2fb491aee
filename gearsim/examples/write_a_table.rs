//! Runs a scene, and writes its table, its plots and its summary to a folder.
//!
//! `cargo run --release --example write_a_table`, from the root of the repository.

use std::path::{Path, PathBuf};

use gearsim::{Error, Scene};

fn main() -> Result<(), Error> {
    for file in write("models/scenes/backlash.toml", Path::new("out/write_a_table"))? {
        println!("{}", file.display());
    }
    Ok(())
}

/// Runs the scene in the file `path` and writes its results to `folder`.
pub fn write(path: &str, folder: &Path) -> Result<Vec<PathBuf>, Error> {
    let scene = Scene::load(path)?.with("output.csv", true)?.with("output.plots", r#"["motion"]"#)?;
    let results = scene.run()?;
    results.check()?;
    results.write(folder)
}
