//! `gearsim run`: runs one scene and writes its results and plots.

use clap::Parser;

use super::failure::Failure;
use super::simulate::{Source, simulate};
use super::{Verb, evaluate, files, page, report, terminal};
use crate::library;
use crate::output::OutputFolder;
use crate::plot;
use crate::run::Outcome;
use crate::scene::Scene;

/// Run a scene: write its trajectory, its summary and its plots
#[derive(Parser)]
#[command(
    name = "run",
    after_help = "\
Writes summary.json, trajectory.parquet (with --csv also trajectory.csv), lines.csv with the amplitudes
at mesh orders and their sidebands, and plots as SVG and PNG. Rows with moment = \"sample\" are evenly
spaced; at each event there are two more rows of the same time.

Examples:
  gearsim run models/scenes/oh2005/energy_300rpm.toml
  gearsim run models/scenes/oh2005/energy_300rpm.toml --set start.speed=\"600 rpm\" --out out/600rpm
  gearsim run models/scenes/oh2005/energy_300rpm.toml --set run.t_end=\"1 s\" --csv
  gearsim run models/scenes/two_stage.toml --sound mesh_force_12 --stretch 4
  gearsim run models/scenes/two_stage.toml --set output.rainflow='[\"mesh_force_12\"]'
  gearsim run models/scenes/oh2005/energy_300rpm.toml --set 'effects=[\"stiffness_step\"]' --quiet"
)]
pub(super) struct Run {
    #[command(flatten)]
    source: Source,
    /// Also write the trajectory as CSV
    #[arg(long)]
    csv: bool,
    /// Also write a recorded signal as sound, sound_NAME.wav; may be repeated
    #[arg(long, value_name = "NAME")]
    sound: Vec<String>,
    /// Play sounds so many times as slowly; frequencies are divided by it
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, requires = "sound")]
    stretch: f64,
    /// Also write page.html, an interactive page that needs no other file and no network
    #[arg(long)]
    html: bool,
    /// Print nothing but warnings and errors
    #[arg(long, short)]
    quiet: bool,
}

impl Verb for Run {
    fn run(mut self) -> Result<(), Failure> {
        self.source.overrides.extend(self.sounds());
        let page = page::asked(self.html)?;
        let scene = self.source.load()?;
        let path = self.source.folder(&scene, "")?;
        let outcome = simulate(&scene, self.quiet)?;
        let mut folder = OutputFolder::create(path)?;
        let text = self.write(&mut folder, &scene, &outcome, page)?;
        if !self.quiet {
            terminal::print_out(&text);
        }
        Failure::of(&format!("scene {}", scene.name), &outcome, folder.path())
    }
}

impl Run {
    /// What --sound and --stretch set in the scene.
    fn sounds(&self) -> Option<String> {
        let names: Vec<_> = self.sound.iter().map(|name| format!("{name:?}")).collect();
        let given = !names.is_empty();
        given.then(|| format!("output.sound={{ of = [{}], stretch = {:?} }}", names.join(", "), self.stretch))
    }

    /// Writes the files, and returns the text for the terminal.
    fn write(
        &self,
        folder: &mut OutputFolder,
        scene: &Scene,
        outcome: &Outcome,
        page: Option<page::Asked>,
    ) -> Result<String, Failure> {
        let (overrides, csv) = (&self.source.overrides, self.csv || scene.output.csv);
        files::trajectory(folder, "trajectory", csv, (scene, overrides), outcome)?;
        let (trajectory, reference_frequency) = (&outcome.trajectory, outcome.reference_frequency);
        let none_from = outcome.digits.and_then(|digits| digits.none_from);
        let (name, asked) = (&scene.name, &scene.output);
        let run = plot::Run { label: name, trajectory, reference_frequency, scene: name, asked, none_from };
        for warning in files::plots(folder, scene, &[run])? {
            terminal::warn(&warning);
        }
        let evaluated = library::evaluate::write(folder, scene, outcome)?;
        evaluated.warnings.iter().for_each(|warning| terminal::warn(warning));
        let mut summary = files::summary(scene, overrides, outcome, folder.files().to_vec());
        summary.sounds = evaluated.sounds.iter().cloned().collect();
        if let Some(page) = page {
            page.run(folder, (scene, overrides), outcome, &summary)?;
            summary.files = folder.files().to_vec();
        }
        folder.write_bytes("summary.json", summary.json()?.as_bytes())?;
        folder.commit("summary.json")?;
        let width = terminal::width();
        Ok(report::scene(scene, width)
            + "\n"
            + &report::run(scene, &summary, trajectory.len(), width)
            + &evaluate::text(&evaluated, scene, &summary, width)
            + "\n"
            + &report::files(folder.path(), folder.files(), width))
    }
}
