//! `gearsim run`: runs one scene and writes its results and plots.

use clap::Parser;

use super::failure::Failure;
use super::printing::Printing;
use super::simulate::{Source, simulate};
use super::{Verb, evaluate, page, report, terminal};
use crate::library::{self, Results};
use crate::output::OutputFolder;

/// Run a scene: write its trajectory, its summary and its plots
#[derive(Parser)]
#[command(
    name = "run",
    after_help = "\
Writes summary.json, trajectory.parquet (with --csv also trajectory.csv), lines.csv with the
amplitudes at mesh orders and their sidebands, and plots as SVG and PNG. Rows with moment =
\"sample\" are evenly spaced, except a last one at the end of the run; at each event there are two
more rows of the same time.

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
    /// Write a recorded signal as sound, sound_NAME.wav; may be repeated. These replace
    /// output.sound of the scene
    #[arg(long, value_name = "NAME")]
    sound: Vec<String>,
    /// Play sounds so many times as slowly; frequencies are divided by it
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, requires = "sound")]
    stretch: f64,
    #[command(flatten)]
    html: page::Html,
    #[command(flatten)]
    printing: Printing,
}

impl Verb for Run {
    fn run(mut self) -> Result<(), Failure> {
        self.source.overrides.extend(self.sounds());
        let page = self.html.asked()?;
        let scene = self.source.load()?;
        let path = self.source.folder(&scene, "")?;
        let results = simulate(&scene, self.printing.quiet())?;
        let mut folder = OutputFolder::create(path)?;
        self.write(&mut folder, &results, page)?;
        Failure::of(&format!("scene {}", scene.name), &results.outcome, folder.path())
    }
}

impl Run {
    /// What --sound and --stretch set in the scene.
    fn sounds(&self) -> Option<String> {
        let names: Vec<_> = self.sound.iter().map(|name| format!("{name:?}")).collect();
        let given = !names.is_empty();
        given.then(|| format!("output.sound={{ of = [{}], stretch = {:?} }}", names.join(", "), self.stretch))
    }

    /// Writes the files, and prints the results.
    fn write(&self, folder: &mut OutputFolder, results: &Results, page: Option<page::Asked>) -> Result<(), Failure> {
        let scene = &results.scene;
        let evaluated = results.write_to(folder, self.csv || scene.output.csv)?;
        let mut summary = results.summed(folder, &evaluated);
        if let Some(page) = page {
            page.run(folder, results, &mut summary)?;
        }
        library::finish(folder, &summary)?;
        let width = terminal::width();
        let text = || {
            report::scene(scene, width)
                + "\n"
                + &report::run(scene, &summary, results.trajectory().len(), width)
                + &evaluate::text(&evaluated, scene, &summary, width)
                + "\n"
                + &report::files(folder.path(), folder.files(), width)
        };
        // Those about the scene were written before the run.
        let before = |remark: &&String| scene.warnings.contains(remark) || scene.conversions.contains(remark);
        self.printing.warn(summary.remarks.iter().filter(|remark| !before(remark)));
        self.printing.print(|| summary.json(), text)
    }
}
