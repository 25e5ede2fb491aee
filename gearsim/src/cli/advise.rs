//! `gearsim advise`: which effects a scene needs, and which it can leave out.

mod page;
mod table;

use clap::Parser;

use super::failure::Failure;
use super::printing::Printing;
use super::simulate::Source;
use super::{Verb, report, terminal};
use crate::analysis::advise;
use crate::library::advise::Advice;
use crate::output::OutputFolder;
use crate::scene::Scene;

/// Which effects matter to a scene, and which may be left out; checked by runs with and without each
#[derive(Parser)]
#[command(
    name = "advise",
    after_help = "\
Prints the scene's dimensionless groups. Then estimates, for each of its effects, how far the
recorded quantities would change without it: from the settled motion in steady rotation, which needs
no run, or from a short run if that motion cannot be computed. Then runs the scene with and without
each effect, and prints the true deviation and the change of the time, below the estimate.

Writes advise.json if --out or --html is given.

Examples:
  gearsim advise models/scenes/oh2005/spectrum_600rpm_exact.toml
  gearsim advise models/scenes/oh2005/spectrum_4500rpm_exact.toml --set parameters.T0=\"50 N*m\""
)]
pub(super) struct Advise {
    #[command(flatten)]
    source: Source,
    #[command(flatten)]
    html: super::page::Html,
    #[command(flatten)]
    printing: Printing,
}

impl Verb for Advise {
    fn run(self) -> Result<(), Failure> {
        let page = self.html.asked()?;
        let scene = self.source.load()?;
        let writes = page.is_some() || self.source.names_folder();
        let path = writes.then(|| self.source.folder(&scene, "_advise")).transpose()?;
        let advice = scene.advise()?;
        let folder = path.map(|path| write(OutputFolder::create(path)?, &scene, &advice, page)).transpose()?;
        let width = terminal::width();
        let dropped = scene.effects != advise::base(&scene).effects;
        let text = || {
            let files = |folder: &OutputFolder| format!("\n{}", report::files(folder.path(), folder.files(), width));
            let files = folder.as_ref().map_or(String::new(), files);
            format!("{}\n{}{files}", report::scene(&scene, width), table::render(&advice, dropped, width))
        };
        self.printing.print(|| advice.json(&scene), text)?;
        match (advice.stopped, advice.refuted) {
            (Some(stop), _) => Err(Failure::StoppedAdvice { scene: scene.name, stop }),
            // The energy account of the scene does not close, so that the deviations refer to a wrong result.
            (None, Some(account)) => Err(Failure::RefutedAdvice { scene: scene.name, account }),
            (None, None) => Ok(()),
        }
    }
}

/// Writes advise.json, and the page if it is asked for.
fn write(
    mut folder: OutputFolder,
    scene: &Scene,
    advice: &Advice,
    page: Option<super::page::Asked>,
) -> Result<OutputFolder, Failure> {
    folder.write_bytes("advise.json", advice.json(scene)?.as_bytes())?;
    if let Some(asked) = page {
        let (conclusions, drawn) = (page::conclusions(advice), page::figure(&scene.name, advice));
        asked.advise(&mut folder, scene, &conclusions, drawn.as_ref(), &page::deviations(advice)?)?;
    }
    folder.commit("advise.json")?;
    Ok(folder)
}
