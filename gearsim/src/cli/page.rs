//! `--html`: the interactive page of a result. A program built without the feature `html` says how to add it.
//!
//! The page of a command is one module of `page`, and one entry in `pages!`.

use clap::Args;

use super::failure::Failure;
use crate::analysis::floquet::{Chart, Floquet};
use crate::analysis::modes::{CellModes, Parts};
use crate::analysis::work_precision::WorkPrecision;
use crate::library::Results;
use crate::model::Model;
use crate::output::{OutputFolder, Summary, Table, WholeFiles};
#[cfg(feature = "html")]
use crate::page;
use crate::plot::{Drawn, Figure, Run};
use crate::scene::Scene;
use crate::sweep::Manifest;

/// Name of the page in the folder of a result.
pub(super) use crate::output::PAGE as FILE;

/// The option of a command that has a page.
#[derive(Args)]
pub(super) struct Html {
    /// Also write page.html, an interactive page that needs no other file and no network
    #[arg(long)]
    html: bool,
}

/// The page asked for on the command line.
#[cfg(feature = "html")]
pub(super) struct Asked;

/// There is no value of this type: this program writes no pages.
#[cfg(not(feature = "html"))]
pub(super) enum Asked {}

impl Html {
    /// The page, if it is asked for. Errors: those of [`asked`].
    pub(super) fn asked(&self) -> Result<Option<Asked>, Failure> {
        asked(self.html)
    }
}

/// The page, if `html` asks for it. Errors: [`Failure::Impossible`] if this program cannot write pages.
#[cfg(not(feature = "html"))]
pub(super) fn asked(html: bool) -> Result<Option<Asked>, Failure> {
    if !html {
        return Ok(None);
    }
    Err(Failure::Impossible {
        what: "this program was built without interactive pages".into(),
        help: format!("build it with them: cargo build --release --features {}", feature()),
    })
}

/// The name of the feature `html` for cargo: in a crate with models of its own gearsim is a dependency.
#[cfg(not(feature = "html"))]
fn feature() -> &'static str {
    use crate::known;
    use crate::known::MODELS;
    if known::models().len() > MODELS.len() { "gearsim/html" } else { "html" }
}

/// The page, if `html` asks for it. Errors: none with the feature `html`.
#[cfg(feature = "html")]
pub(super) fn asked(html: bool) -> Result<Option<Asked>, Failure> {
    Ok(html.then_some(Asked))
}

/// The scene, provenance and files that a page shows. `solver` says how the result was computed; `files` are its other files.
#[cfg(feature = "html")]
fn made<'a>(scene: &'a Scene, solver: &str, files: &'a [String]) -> page::shared::Made<'a> {
    page::shared::Made { scene, provenance: super::provenance::of(scene, solver.into()), files }
}

/// Makes a method of [`Asked`] for each command. It writes the page into the folder of the result. The page names the index file of
/// that result.
macro_rules! pages {
    ($($command:ident of $index:literal in $folder:ident($($name:ident: $type:ty),* $(,)?) => |$files:ident| $page:expr;)*) => {
        #[cfg(feature = "html")]
        impl Asked {
            $(pub(super) fn $command(self, folder: &mut $folder, $($name: $type),*) -> Result<(), Failure> {
                let $files = folder.files();
                let page = $page?.of($index);
                folder.write(FILE, |sink| Ok(page.write(sink)?))?;
                Ok(())
            })*
        }

        // Not reached, because there is no value to call these on.
        #[cfg(not(feature = "html"))]
        impl Asked {
            $(pub(super) fn $command(self, _: &mut $folder, $(_: $type),*) -> Result<(), Failure> {
                match self {}
            })*
        }
    };
}

/// The page of a run. Programs that use the library can write it too ([`Results::page`]).
impl Asked {
    #[cfg(feature = "html")]
    pub(super) fn run(
        self,
        folder: &mut OutputFolder,
        results: &Results,
        summary: &mut Summary,
    ) -> Result<(), Failure> {
        Ok(results.write_page(folder, summary)?)
    }

    #[cfg(not(feature = "html"))]
    pub(super) fn run(self, _: &mut OutputFolder, _: &Results, _: &mut Summary) -> Result<(), Failure> {
        match self {}
    }
}

pages! {
    work_precision of "work_precision.csv" in OutputFolder(scene: &Scene, measured: &WorkPrecision) => |files|
        page::work_precision::page(&made(scene, "each method in turn", files), measured);
    response of "response.csv" in OutputFolder(scene: &Scene, facts: &[(String, String)], drawn: Option<&Figure>, points: &Table) => |files|
        page::response::page(&made(scene, "run by run, each from the end of the one before it", files), facts, drawn, points);
    modes of "modes.json" in OutputFolder(scene: &Scene, moves: bool, parts: &Parts, cells: (&CellModes, &[CellModes]), figures: &[Figure]) => |files|
        page::modes::page(&made(scene, "modes of linear cells", files), &page::modes::Modes { moves, parts, chosen: cells.0, cells: cells.1, figures });
    floquet of "floquet.json" in OutputFolder(scene: &Scene, words: &str, floquet: &Floquet, chart: Option<(&Chart, &Table)>) => |files|
        page::floquet::page(&made(scene, floquet.method(), files), words, floquet, chart);
    compare of "compare.json" in OutputFolder(scene: &Scene, runs: &[Run<'_>], summaries: &[Summary]) => |files|
        page::compare::page(&made(scene, "the solver of each run", files), runs, summaries);
    advise of "advise.json" in OutputFolder(scene: &Scene, conclusions: &[(String, String)], drawn: Option<&Figure>, deviations: &Table) => |files|
        page::advise::page(
            &made(scene, "estimates, and runs with and without each effect", files),
            &page::advise::Advice { conclusions, drawn, deviations },
        );
    sweep of "sweep.json" in WholeFiles(
        of: (&Manifest, &'static Model, Option<&str>),
        drawn: &[Drawn],
        answers: (&str, &[(&'static str, Table)], &[String]),
        points: &Table,
        files: &[String],
    ) => |_files| {
        let ((manifest, model, text), (words, answers, remarks)) = (of, answers);
        page::sweep::page(&page::sweep::Sweep { manifest, model, text, drawn, words, answers, remarks, points, files })
    };
}
