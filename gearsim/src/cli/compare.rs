//! `gearsim compare`: one scene under the exact equations and the usual approximations to them.

pub(super) mod equations;
mod table;

use clap::Parser;
use serde::Serialize;

use super::failure::Failure;
use super::simulate::{Source, simulate};
use super::{Verb, files, report, terminal};
use crate::output::{OutputError, OutputFolder, Summary};
use crate::plot;
use crate::run::Outcome;
use crate::scene::Scene;
use equations::Set;

/// Run one scene under exact, rigid-kinematic and classical equations, and compare them
#[derive(Parser)]
#[command(
    name = "compare",
    after_help = "\
The three sets of equations:
  exact            stiffness steps with the jump terms that conserve energy
  rigid kinematic  without the jump terms: effect rigid_kinematics
  classical        steps at the times of a steady rotation: effect frozen_phase
Which of them the scene itself names does not matter; its other effects hold for all three.

Writes compare.json, trajectory_exact.parquet and so on, and the scene's plots, overlaid.

Examples:
  gearsim compare models/scenes/oh2005/energy_300rpm.toml
  gearsim compare models/scenes/oh2005/energy_300rpm.toml --set start.speed=\"4500 rpm\" --out out/fast"
)]
pub(super) struct Compare {
    #[command(flatten)]
    source: Source,
}

/// A scene under one set of equations.
pub(super) struct Member {
    pub(super) set: &'static Set,
    pub(super) scene: Scene,
    pub(super) outcome: Outcome,
}

/// The content of `compare.json`.
#[derive(Serialize)]
struct Comparison {
    /// Name of the scene.
    scene: String,
    /// The sets of equations, exact ones first.
    runs: Vec<Entry>,
    /// The plots written beside this file, all runs in each.
    plots: Vec<String>,
}

#[derive(Serialize)]
struct Entry {
    /// The set of equations.
    equations: &'static str,
    /// What `summary.json` says of such a run.
    summary: Summary,
}

impl Verb for Compare {
    fn run(self) -> Result<(), Failure> {
        let scene = self.source.load()?;
        let scenes = equations::all(&scene)?;
        let path = self.source.folder(&scene, "_compare")?;
        let mut members = vec![];
        for (set, scene) in scenes {
            let outcome = simulate(&scene, false)?;
            members.push(Member { set, scene, outcome });
        }
        let mut folder = OutputFolder::create(path)?;
        let summaries = self.write(&mut folder, &scene, &members)?;
        let width = terminal::width();
        let written = report::files(folder.path(), folder.files(), width);
        terminal::say(&format!("{}\n{}\n{written}", report::scene(&scene, width), table::render(&members, &summaries)));
        let verdict = |m: &Member| Failure::of(&format!("the {} run", m.set.label), &m.outcome, folder.path());
        members.iter().try_for_each(verdict)
    }
}

impl Compare {
    /// Writes the files; the summaries of the runs.
    fn write(&self, folder: &mut OutputFolder, scene: &Scene, members: &[Member]) -> Result<Vec<Summary>, Failure> {
        let overrides = &self.source.overrides;
        let mut summaries = vec![];
        for Member { set, scene, outcome } in members {
            let before = folder.files().len();
            let name = format!("trajectory_{}", set.suffix);
            files::trajectory(folder, &name, scene.output.csv, (scene, overrides), outcome)?;
            summaries.push(files::summary(scene, overrides, outcome, folder.files()[before..].to_vec()));
        }
        let before = folder.files().len();
        let runs: Vec<_> = members.iter().map(Member::to_draw).collect();
        for warning in files::plots(folder, scene, &runs)? {
            terminal::complain(&terminal::wrap(&format!("warning: {warning}"), terminal::width()));
        }
        let entries = members.iter().zip(&summaries);
        let comparison = Comparison {
            scene: scene.name.clone(),
            runs: entries.map(|(m, s)| Entry { equations: m.set.label, summary: s.clone() }).collect(),
            plots: folder.files()[before..].to_vec(),
        };
        let json = serde_json::to_string_pretty(&comparison).map_err(|e| OutputError::format("JSON", e))?;
        folder.write_bytes("compare.json", (json + "\n").as_bytes())?;
        Ok(summaries)
    }
}

impl Member {
    fn to_draw(&self) -> plot::Run<'_> {
        plot::Run {
            label: self.set.label,
            trajectory: &self.outcome.trajectory,
            reference_frequency: self.outcome.reference_frequency,
            scene: &self.scene.name,
            none_from: self.outcome.digits.and_then(|digits| digits.none_from),
        }
    }
}
