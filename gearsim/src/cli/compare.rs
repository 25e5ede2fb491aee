//! `gearsim compare`: one scene under the exact equations and under two common approximations.

mod table;

use clap::Parser;
use serde::Serialize;

use super::failure::Failure;
use super::printing::Printing;
use super::simulate::{Source, simulate};
use super::{Verb, files, page, report, terminal};
use crate::library::Results;
use crate::library::equation_sets::{self, EquationSet};
use crate::output::remarks;
use crate::output::{OutputFolder, Summary, document};
use crate::plot;
use crate::scene::Scene;

/// Run one scene under exact, rigid-kinematic and classical equations, and compare them
#[derive(Parser)]
#[command(
    name = "compare",
    after_help = "\
The three sets of equations:
  exact            stiffness steps with the jump terms that conserve energy
  rigid kinematic  without the jump terms: effect rigid_kinematics
  classical        steps at the times of a steady rotation: effect frozen_phase
It does not matter which of them the scene names. Its other effects hold for all three.

Writes compare.json, trajectory_exact.parquet and so on, and plots with all runs: first the outputs
(mesh forces, transmission errors, speeds), then the plots that the scene asks for.

Examples:
  gearsim compare models/scenes/oh2005/energy_300rpm.toml
  gearsim compare models/scenes/oh2005/energy_300rpm.toml --set start.speed=\"4500 rpm\" \\
      --out out/fast"
)]
pub(super) struct Compare {
    #[command(flatten)]
    source: Source,
    #[command(flatten)]
    html: page::Html,
    #[command(flatten)]
    printing: Printing,
}

/// The run of a scene under one set of equations.
pub(super) struct ComparedRun {
    pub(super) set: &'static EquationSet,
    pub(super) results: Results,
}

/// Version of the format of `compare.json`.
const VERSION: u32 = 1;

/// The content of `compare.json`.
#[derive(Serialize)]
struct Comparison {
    /// Name of the scene.
    scene: String,
    /// One entry per set of equations, the exact ones first.
    runs: Vec<RunSummary>,
    /// Names of the plots in the same folder; each shows all runs.
    plots: Vec<String>,
}

#[derive(Serialize)]
struct RunSummary {
    /// Name of the set of equations.
    equations: &'static str,
    /// The content of `summary.json` for this run.
    summary: Summary,
}

impl Verb for Compare {
    fn run(self) -> Result<(), Failure> {
        let page = self.html.asked()?;
        let scene = self.source.load()?;
        let scenes = equation_sets::all(&scene)?;
        let path = self.source.folder(&scene, "_compare")?;
        let mut members = vec![];
        for (set, scene) in scenes {
            members.push(ComparedRun { set, results: simulate(&scene, self.printing.quiet())? });
        }
        let mut folder = OutputFolder::create(path)?;
        let (summaries, json) = write(&mut folder, &scene, &members, page)?;
        let width = terminal::width();
        let text = || {
            let written = report::files(folder.path(), folder.files(), width);
            let notes: String = notes(&summaries).iter().map(|note| report::line("note", note, width)).collect();
            let table = table::render(&members, &summaries);
            format!("{}\n{table}{notes}\n{written}", report::scene(&scene, width))
        };
        self.printing.warn(notes(&summaries).iter());
        self.printing.print(|| Ok::<_, Failure>(json), text)?;
        let verdict =
            |m: &ComparedRun| Failure::of(&format!("the {} run", m.set.label), &m.results.outcome, folder.path());
        members.iter().try_for_each(verdict)
    }
}

/// The remarks of the runs: for each finding, that of the first run that has it.
fn notes(summaries: &[Summary]) -> Vec<String> {
    remarks::counted("runs", summaries.iter().map(|summary| &summary.remarks[..]))
}

/// Writes the files, and returns the summaries of the runs and the content of `compare.json`.
fn write(
    folder: &mut OutputFolder,
    scene: &Scene,
    members: &[ComparedRun],
    page: Option<page::Asked>,
) -> Result<(Vec<Summary>, String), Failure> {
    let mut summaries = vec![];
    for ComparedRun { set, results: Results { scene, outcome } } in members {
        let before = folder.files().len();
        let name = format!("trajectory_{}", set.suffix);
        files::trajectory(folder, &name, scene.output.csv, scene, outcome)?;
        summaries.push(files::summary(scene, outcome, folder.files()[before..].to_vec()));
    }
    let before = folder.files().len();
    let runs: Vec<_> = members.iter().map(ComparedRun::to_draw).collect();
    for remark in files::plots(folder, &plot::compared(&runs), &runs)? {
        summaries.iter_mut().for_each(|summary: &mut Summary| summary.remarks.push(remark.clone()));
    }
    let entries = members.iter().zip(&summaries);
    let comparison = Comparison {
        scene: scene.name.clone(),
        runs: entries.map(|(m, s)| RunSummary { equations: m.set.label, summary: s.clone() }).collect(),
        plots: folder.files()[before..].to_vec(),
    };
    if let Some(page) = page {
        page.compare(folder, scene, &runs, &summaries)?;
    }
    let json = document::json("compare", VERSION, &comparison)?;
    folder.write_bytes("compare.json", json.as_bytes())?;
    folder.commit("compare.json")?;
    Ok((summaries, json))
}

impl ComparedRun {
    fn to_draw(&self) -> plot::Run<'_> {
        plot::Run { label: self.set.label, ..self.results.drawn() }
    }
}
