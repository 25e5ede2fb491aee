//! Reads and runs a scene, as several commands do.

use std::path::{Path, PathBuf};

use clap::Args;

use super::failure::Failure;
use super::progress::Progress;
use super::{known, terminal};
use crate::analysis::digits;
use crate::output::OutputFolder;
use crate::run::{Entry, Outcome};
use crate::scene::Scene;

/// The scene to simulate, and the folder for the results.
#[derive(Args)]
pub(super) struct Source {
    /// The scene: a TOML file
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
        let scene = self.load_with(&[])?;
        scene.warnings.iter().for_each(|warning| terminal::warn(warning));
        Ok(scene)
    }

    /// Loads and checks the scene with `further` values set.
    pub(super) fn load_with(&self, further: &[String]) -> Result<Scene, Failure> {
        let models: Vec<_> = known::models().iter().map(|entry| entry.model).collect();
        let overrides: Vec<String> = self.overrides.iter().chain(further).cloned().collect();
        Scene::load_with(&self.scene, &overrides, &models).map_err(|errors| Failure::Scene(Box::new(errors)))
    }

    /// The folder for the results, `out/<scene><suffix>` if none is given. It is not created yet, but a folder that cannot be written
    /// to is an error now, not after a long run.
    pub(super) fn folder(&self, scene: &Scene, suffix: &str) -> Result<PathBuf, Failure> {
        let default = || Path::new("out").join(format!("{}{suffix}", scene.name));
        let folder = self.out.clone().unwrap_or_else(default);
        OutputFolder::probe(&folder)?;
        Ok(folder)
    }
}

/// The entry of the scene's model in [`known::models`].
pub(super) fn entry(scene: &Scene) -> Result<&'static Entry, Failure> {
    let unknown = || Failure::Impossible {
        what: format!("this program does not have the model `{}`", scene.model.name),
        help: "`gearsim models` lists the models that it has".into(),
    };
    known::models().iter().find(|entry| entry.model.name == scene.model.name).ok_or_else(unknown)
}

/// Runs a scene and its companion run, which gives the number of digits left. Shows a progress bar if the run takes long, unless `quiet`.
pub(super) fn simulate(scene: &Scene, quiet: bool) -> Result<Outcome, Failure> {
    let entry = entry(scene)?;
    let mut progress = Progress::new(scene.t_end, quiet);
    let refused = |refusal| Failure::Refused { scene: scene.name.clone(), refusal };
    let outcome = entry.run(scene, &mut |t| progress.at(t)).map_err(refused)?;
    Ok(digits::noted(scene, outcome, &|companion| entry.run(companion, &mut |_| {})))
}
