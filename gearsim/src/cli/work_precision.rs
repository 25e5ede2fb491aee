//! `gearsim work-precision`: error against processor time on a scene, for every method that a user might choose.

mod json;

use std::path::{Path, PathBuf};

use clap::Parser;

use super::failure::Failure;
use super::printing::Printing;
use super::simulate::simulate;
use super::{Verb, known, page, report, terminal};
use crate::analysis::work_precision::{self, Scenes, table};
use crate::engine::Refusal;
use crate::library::equation_sets;
use crate::output::{OutputError, OutputFolder};
use crate::plot::work_precision::draw;
use crate::scene::Scene;

/// Draw error against processor time for many methods on a scene
#[derive(Parser)]
#[command(
    name = "work-precision",
    after_help = "\
Runs exact cells, if the scene has linear ones; adaptive methods (explicit of order 5 and 8,
implicit) at tolerances from 1e-3 to 1e-13; rk4 with fixed steps, with events located and with
events ignored; ramps in place of steps; and the approximate equations. Each is compared with one
reference: exact cells in twice the digits, or the most accurate method that the scene allows.
Settings that fail are shown as failed.

Writes work_precision.svg, .png, .md and .csv, one folder per scene. The scene should be short: it
runs some hundred times, and some methods take a thousand times as long as others.

Examples:
  gearsim work-precision models/scenes/oh2005/spectrum_4500rpm_exact.toml --set run.t_end=\"0.05 s\"
  gearsim work-precision models/scenes/oh2005/*_exact.toml --set run.t_end=\"0.05 s\" --repetitions 20"
)]
pub(super) struct WorkPrecision {
    /// The scenes: TOML files
    #[arg(required = true)]
    scenes: Vec<PathBuf>,
    /// Folder for the results; with several scenes, each has its own folder in it
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Sets a value of every scene, e.g. --set run.t_end="0.05 s"; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    /// Number of runs per point; the fastest and the median are kept
    #[arg(long, default_value_t = 7, value_parser = clap::value_parser!(u16).range(1..))]
    repetitions: u16,
    #[command(flatten)]
    html: page::Html,
    #[command(flatten)]
    printing: Printing,
}

impl Verb for WorkPrecision {
    fn run(self) -> Result<(), Failure> {
        self.html.asked()?;
        let models = known::descriptions();
        let load = |path: &PathBuf| {
            Scene::load_with(path, &self.overrides, &models).map_err(|errors| Failure::Scene(Box::new(errors)))
        };
        let scenes = self.scenes.iter().map(load).collect::<Result<Vec<_>, _>>()?;
        let folders: Vec<_> = scenes.iter().map(|scene| self.folder(scene)).collect();
        folders.iter().try_for_each(|folder| OutputFolder::probe(folder))?;
        scenes.iter().zip(folders).try_for_each(|(scene, folder)| self.one(scene, folder))
    }
}

impl WorkPrecision {
    fn folder(&self, scene: &Scene) -> PathBuf {
        let default = || Path::new("out").join(format!("{}_work_precision", scene.name));
        match &self.out {
            Some(out) if self.scenes.len() > 1 => out.join(&scene.name),
            Some(out) => out.clone(),
            None => default(),
        }
    }

    /// Measures one scene.
    fn one(&self, scene: &Scene, folder: PathBuf) -> Result<(), Failure> {
        // The approximate equations need a stiffness that steps, and some effects exclude them.
        let cheaper = equation_sets::all(scene).unwrap_or_default().into_iter().skip(1);
        let cheaper = cheaper.filter(|(_, scene)| scene.effects.contradictions(scene.model).is_empty());
        let cheaper = cheaper.map(|(set, scene)| (set.equations, scene)).collect();
        let run = |scene: &Scene| match simulate(scene, true) {
            Ok(results) => Ok(results.outcome),
            Err(Failure::Refused { refusal, .. }) => Err(refusal),
            Err(_) => Err(Refusal::Effects { which: scene.effects.contradictions(scene.model) }),
        };
        let scenes = Scenes { exact: scene.clone(), cheaper };
        let mut say = |what: &str| {
            if !self.printing.quiet() {
                terminal::print_err(&format!("{}: {what}", scene.name));
            }
        };
        let impossible = |why: String| Failure::Impossible {
            what: format!("no reference for scene {}: {why}", scene.name),
            help: "choose a scene that runs to its end, e.g. a shorter one: --set run.t_end=\"0.1 s\"".into(),
        };
        let measured = work_precision::measure(&scenes, &run, self.repetitions.into(), &mut say).map_err(impossible)?;
        let drawn = draw(&measured);
        let failed = |error: crate::plot::PlotError| OutputError::format("plot", error);
        let mut folder = OutputFolder::create(folder)?;
        folder.write_bytes("work_precision.svg", drawn.svg().map_err(failed)?.as_bytes())?;
        folder.write_bytes("work_precision.png", &drawn.png().map_err(failed)?)?;
        folder.write_bytes("work_precision.md", table::markdown(&measured).as_bytes())?;
        folder.write_bytes("work_precision.csv", table::csv(&measured).as_bytes())?;
        if let Some(page) = self.html.asked()? {
            page.work_precision(&mut folder, scene, &measured)?;
        }
        folder.commit("work_precision.csv")?;
        let width = terminal::width();
        let text = || {
            let files = report::files(folder.path(), folder.files(), width);
            let words = terminal::wrap(&table::words(&measured), width);
            format!("{words}\n\n{}\n{files}", table::prices(&measured))
        };
        self.printing.print(|| json::json(&measured), text)
    }
}
