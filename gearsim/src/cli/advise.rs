//! `gearsim advise`: which effects a scene needs, and which it can leave out.

mod table;

use std::path::PathBuf;

use clap::Parser;

use super::failure::Failure;
use super::printing::Printing;
use super::{Verb, known, report, terminal};
use crate::analysis::advise;
use crate::scene::Scene;

/// Which effects matter to a scene, and which may be left out; checked by runs with and without each
#[derive(Parser)]
#[command(
    name = "advise",
    after_help = "\
Prints the scene's dimensionless groups. Then estimates, for each of its effects, how far the
recorded quantities would change without it: from the settled motion in steady rotation, which needs
no run, or from a short run if that motion cannot be computed. Then runs the scene with and without
each effect, and prints the true deviation, and the time saved, below the estimate.

Examples:
  gearsim advise models/scenes/oh2005/spectrum_600rpm_exact.toml
  gearsim advise models/scenes/oh2005/spectrum_4500rpm_exact.toml --set parameters.T0=\"50 N*m\""
)]
pub(super) struct Advise {
    /// The scene: a TOML file, or - for the standard input
    scene: PathBuf,
    /// Sets a value of the scene, e.g. --set parameters.T0="20 N*m"; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    #[command(flatten)]
    printing: Printing,
}

impl Verb for Advise {
    fn run(self) -> Result<(), Failure> {
        let models = known::descriptions();
        let scene = Scene::load_with(&self.scene, &self.overrides, &models).map_err(|e| Failure::Scene(Box::new(e)))?;
        scene.warnings.iter().for_each(|warning| terminal::warn(warning));
        let advice = scene.advise()?;
        let width = terminal::width();
        let dropped = scene.effects != advise::base(&scene).effects;
        let text = || format!("{}\n{}", report::scene(&scene, width), table::render(&advice, dropped, width));
        self.printing.print(|| advice.json(&scene), text)?;
        match (advice.stopped, advice.refuted) {
            (Some(stop), _) => Err(Failure::StoppedAdvice { scene: scene.name, stop }),
            // The deviations are those from a wrong result.
            (None, Some(account)) => Err(Failure::RefutedAdvice { scene: scene.name, account }),
            (None, None) => Ok(()),
        }
    }
}
