//! `gearsim check`: reads scenes and prepares their runs, without running them.

use std::path::{Path, PathBuf};

use clap::Parser;
use serde::Serialize;

use super::failure::Failure;
use super::printing::Printing;
use super::{Verb, report, terminal};
use crate::known;
use crate::output::document;
use crate::output::summary::Named;
use crate::output::unit::coordinate_in_words;
use crate::scene::Scene;

/// Check scenes without running them: mistakes, start, method
#[derive(Parser)]
#[command(
    name = "check",
    after_help = "\
Reads each scene, finds its static start, computes its first cell, and chooses its method. The exit
code is 0 if all can be run, and 2 if one cannot. With --json each scene that can be run has one
line, a document of its own (JSON Lines); why another cannot be run is on the standard error.

Examples:
  gearsim check models/scenes/two_stage.toml
  gearsim check models/scenes/*.toml --set run.precision=compensated"
)]
pub(super) struct Check {
    /// The scenes: TOML files
    #[arg(required = true, value_name = "SCENE")]
    scenes: Vec<PathBuf>,
    /// Sets a value of every scene, e.g. --set run.t_end="1 s"; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    #[command(flatten)]
    printing: Printing,
}

/// Version of the format of --json.
const VERSION: u32 = 1;

/// What --json prints of a scene.
#[derive(Serialize)]
struct Report<'a> {
    scene: &'a str,
    model: &'a str,
    effects: Vec<&'static str>,
    method: &'a str,
    /// Why this method was chosen.
    why: &'a str,
    /// Coordinates at the start [SI].
    start: Named,
    /// Speeds of the coordinates at the start [SI].
    start_speeds: Named,
    warnings: &'a [String],
}

impl Verb for Check {
    fn run(self) -> Result<(), Failure> {
        if self.scenes.iter().filter(|path| *path == Path::new("-")).count() > 1 {
            let help = "name it once".into();
            return Err(Failure::Impossible { what: "the standard input can be read only once".into(), help });
        }
        let mut failure: Option<Failure> = None;
        for path in &self.scenes {
            // All scenes are checked. The program reports the last failure; all have the same exit code.
            if let Err(next) = self.check(path)
                && let Some(before) = failure.replace(next)
            {
                before.report();
            }
        }
        failure.map_or(Ok(()), Err)
    }
}

impl Check {
    fn check(&self, path: &Path) -> Result<(), Failure> {
        let models = known::descriptions();
        let scene = Scene::load_with(path, &self.overrides, &models).map_err(|e| Failure::Scene(Box::new(e)))?;
        scene.warnings.iter().for_each(|warning| terminal::warn(warning));
        let prospect = scene.check()?;
        let names: Vec<&str> = scene.model.coordinates.iter().map(|c| c.name).collect();
        let named = |values: &[f64]| names.iter().copied().zip(values.iter().copied()).collect();
        let report = Report {
            scene: &scene.name,
            model: scene.model.name,
            effects: scene.effects.names(scene.model),
            method: prospect.method,
            why: &prospect.why,
            start: named(&prospect.q),
            start_speeds: named(&prospect.q_dot),
            warnings: &scene.warnings,
        };
        let text = || {
            let width = terminal::width();
            let start = scene.model.coordinates.iter().zip(&prospect.q);
            let start: Vec<_> =
                start.map(|(c, q)| format!("{} = {}", c.name, coordinate_in_words(*q, c.unit))).collect();
            report::scene(&scene, width)
                + &report::line("method", &format!("{}: {}", prospect.method, prospect.why), width)
                + &report::line("starts at", &start.join(", "), width)
                + "\n"
        };
        self.printing.print(|| document::line("check", VERSION, &report), text)
    }
}
