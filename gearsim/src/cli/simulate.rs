//! Reads and runs a scene, as several commands do.

use std::path::{Path, PathBuf};

use clap::Args;

use super::failure::Failure;
use super::progress::Progress;
use super::{known, terminal};
use crate::library::Results;
use crate::output::OutputFolder;
use crate::scene::Scene;

/// The scene to simulate, and the folder for the results.
#[derive(Args)]
pub(super) struct Source {
    /// The scene: a TOML file, or - for the standard input
    scene: PathBuf,
    /// Folder for the results; created if missing, older results in it are replaced
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Sets a value of the scene, e.g. --set parameters.T0="20 N*m"; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(super) overrides: Vec<String>,
}

impl Source {
    /// Loads and checks the scene.
    pub(super) fn load(&self) -> Result<Scene, Failure> {
        let scene = Scene::load_with(&self.scene, &self.overrides, &known::descriptions());
        let scene = scene.map_err(|mistakes| Failure::Scene(Box::new(mistakes)))?;
        scene.warnings.iter().for_each(|warning| terminal::warn(warning));
        Ok(scene)
    }

    /// Whether the command line names a folder.
    pub(super) fn names_folder(&self) -> bool {
        self.out.is_some()
    }

    /// The folder for the results, `out/<scene><suffix>` if none is given. It is not created yet. A folder that cannot be
    /// written to is an error here, before a long run.
    pub(super) fn folder(&self, scene: &Scene, suffix: &str) -> Result<PathBuf, Failure> {
        let default = || Path::new("out").join(format!("{}{suffix}", scene.name));
        let folder = self.out.clone().unwrap_or_else(default);
        OutputFolder::probe(&folder)?;
        Ok(folder)
    }
}

/// Runs a scene and its companion run, which gives the number of digits left. Shows a progress bar if the run takes long, unless `quiet`.
pub(super) fn simulate(scene: &Scene, quiet: bool) -> Result<Results, Failure> {
    let mut progress = Progress::new(scene.t_end, quiet);
    Ok(scene.run_watched(&mut |t| progress.at(t))?)
}
