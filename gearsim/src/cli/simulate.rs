//! A scene, read and run as commands have it.

use std::path::{Path, PathBuf};

use clap::Args;

use super::failure::Failure;
use super::progress::Progress;
use crate::analysis::digits;
use crate::generated::MODELS;
use crate::output::OutputFolder;
use crate::run::{Entry, Outcome};
use crate::scene::Scene;

/// What to simulate, and where to put it.
#[derive(Args)]
pub(super) struct Source {
    /// The scene: a TOML file
    scene: PathBuf,
    /// Folder for the results; created where missing, older results in it are replaced
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Writes a value over one of the scene, e.g. --set parameters.T0="20 N*m"; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(super) overrides: Vec<String>,
}

impl Source {
    /// The scene, checked.
    pub(super) fn load(&self) -> Result<Scene, Failure> {
        self.load_with(&[])
    }

    /// The same with further values written over it.
    pub(super) fn load_with(&self, further: &[String]) -> Result<Scene, Failure> {
        let models: Vec<_> = MODELS.iter().map(|entry| entry.model).collect();
        let overrides: Vec<String> = self.overrides.iter().chain(further).cloned().collect();
        Scene::load(&self.scene, &overrides, &models).map_err(|errors| Failure::Scene(Box::new(errors)))
    }

    /// The folder for the results, `out/<scene><suffix>` if none is given. Nothing is created, but what would fail
    /// does so now rather than after a long run.
    pub(super) fn folder(&self, scene: &Scene, suffix: &str) -> Result<PathBuf, Failure> {
        let default = || Path::new("out").join(format!("{}{suffix}", scene.name));
        let folder = self.out.clone().unwrap_or_else(default);
        OutputFolder::probe(&folder)?;
        Ok(folder)
    }
}

/// The model of a scene, as the program knows it.
pub(super) fn entry(scene: &Scene) -> Result<&'static Entry, Failure> {
    let unknown = || Failure::Impossible {
        what: format!("model `{}` is not part of this program", scene.model.name),
        help: "`gearsim models` lists those that are".into(),
    };
    MODELS.iter().find(|entry| entry.model.name == scene.model.name).ok_or_else(unknown)
}

/// Runs a scene, and its companion, which tells how many digits are left; with a progress bar if it takes long and is not `quiet`.
pub(super) fn simulate(scene: &Scene, quiet: bool) -> Result<Outcome, Failure> {
    let entry = entry(scene)?;
    let mut progress = Progress::new(scene.t_end, quiet);
    let refused = |refusal| Failure::Refused { scene: scene.name.clone(), refusal };
    let outcome = entry.run(scene, &mut |t| progress.at(t)).map_err(refused)?;
    Ok(digits::noted(scene, outcome, &|companion| entry.run(companion, &mut |_| {})))
}
