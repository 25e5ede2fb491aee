//! Sweeps: a scene run at many points, each with other values written over it, on all cores and on many machines.
//!
//! [`axis`] and [`plan`] say which points there are and in which order, [`record`] what is kept of each, [`run`] runs
//! them, [`row`] makes tables of them, [`manifest`] names the sweep, [`folder`] keeps what is done, so that a sweep
//! goes on where it was interrupted, and [`merge`] joins what many machines did. The result is a function of the
//! manifest alone: the same bytes whatever the number of threads, interruptions and shards.

pub mod axis;
pub mod folder;
pub mod manifest;
pub mod merge;
mod parse;
pub mod plan;
mod random;
pub mod record;
pub mod row;
pub mod run;
pub mod shard;
pub mod spectra;
#[cfg(test)]
mod tests;

use std::path::Path;

pub use manifest::Manifest;
pub use plan::Plan;
pub use shard::Shard;

use crate::output::OutputError;
use crate::run::Entry;
use crate::scene::{Scene, SceneMistakes, Template};
use record::{Column, Group};

/// What is asked of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// Axes, as they are written: `parameters.T0=1:100:50`.
    pub vary: Vec<String>,
    /// Values written over the scene at all points.
    pub overrides: Vec<String>,
    /// Points at every place of the grid, if there are random axes.
    pub samples: Option<usize>,
    /// Seed of random axes.
    pub seed: u64,
    /// Time from which extremes and spectra are taken [s].
    pub from: f64,
    /// Names of the groups of quantities to record.
    pub record: Vec<String>,
    /// Whether the spectra are kept.
    pub spectra: bool,
}

/// A sweep, checked and ready to run.
pub struct Sweep {
    /// The scene, as far as it is the same at all points.
    template: Template,
    /// Its model.
    pub entry: Entry,
    /// Its points.
    pub plan: Plan,
    /// What is recorded.
    pub groups: Vec<&'static Group>,
    /// Time from which extremes and spectra are taken [s].
    pub from: f64,
    /// Whether the spectra are kept.
    pub spectra: bool,
    /// Number of points.
    pub points: usize,
}

/// Why there is no sweep.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The scene or an axis makes no sense.
    #[error(transparent)]
    Scene(Box<SceneMistakes>),
    /// A file could not be written or read.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// What is asked for does not go together.
    #[error("{what}\n  help: {help}")]
    Impossible {
        /// What is wrong.
        what: String,
        /// What to do.
        help: String,
    },
}

impl From<SceneMistakes> for Error {
    fn from(errors: SceneMistakes) -> Error {
        Error::Scene(Box::new(errors))
    }
}

/// An [`Error::Impossible`].
fn impossible<T>(what: impl Into<String>, help: impl Into<String>) -> Result<T, Error> {
    Err(Error::Impossible { what: what.into(), help: help.into() })
}

impl Sweep {
    /// Reads the scene in `path`, one of the models in `entries`, and checks it at the values of every axis.
    ///
    /// # Errors
    /// Whatever is wrong; nothing has run then.
    pub fn load(path: &Path, entries: &[Entry], request: &Request) -> Result<Sweep, Error> {
        let template = Template::load(path, &request.overrides)?;
        let models: Vec<_> = entries.iter().map(|entry| entry.model).collect();
        let model = template.model(&models);
        let Some(&entry) = entries.iter().find(|entry| model.is_some_and(|model| model.name == entry.model.name))
        else {
            // Whatever else is wrong with it, it has no model.
            return match template.scene(&[], &models) {
                Err(errors) => Err(errors.into()),
                Ok(scene) => impossible(format!("scene {} has no model", scene.name), "give it one"),
            };
        };
        let plan = plan(&template, entry, request)?;
        let Some(points) = plan.points().filter(|&points| points > 0) else {
            return impossible(
                format!("the axes make more than {} points, or none", plan::MOST_POINTS),
                "take fewer values, or several sweeps",
            );
        };
        let groups = groups(&request.record)?;
        let sweep = Sweep { template, entry, plan, groups, from: request.from, spectra: request.spectra, points };
        sweep.check()?;
        Ok(sweep)
    }

    /// Name of the scene.
    pub fn scene(&self) -> &str {
        self.template.name()
    }

    /// SHA-256 of the scene with its overrides, those of the axes left out.
    pub fn hash(&self) -> String {
        self.template.hash()
    }

    /// The recorded columns.
    pub fn columns(&self) -> Vec<Column> {
        record::columns(&self.groups, self.entry.model)
    }

    fn check(&self) -> Result<(), Error> {
        for trial in self.plan.trials() {
            let scene: Scene = self.template.scene(&trial, &[self.entry.model])?;
            if self.from >= scene.t_end {
                let what = format!(
                    "the results are to be taken from {} s on, but the run ends at {} s",
                    self.from, scene.t_end
                );
                return impossible(what, "choose an earlier --from, or a later run.t_end");
            }
        }
        Ok(())
    }
}

/// The points that are asked for.
fn plan(template: &Template, entry: Entry, request: &Request) -> Result<Plan, Error> {
    let mut report = template.report();
    let axes = parse::axes(&request.vary, entry.model, &mut report);
    if !report.is_empty() {
        return Err(report.into_mistakes(template.name()).into());
    }
    if axes.is_empty() {
        return impossible("nothing is varied", "say what: --vary parameters.T0=\"1 N*m:100 N*m:50\"");
    }
    let set = |key: &str| request.overrides.iter().any(|text| text.split('=').next().is_some_and(|k| k.trim() == key));
    if let Some(axis) = axes.iter().find(|axis| set(&axis.key)) {
        return impossible(format!("`{}` is set and varied", axis.key), "leave out its --set, or its --vary");
    }
    let plan = Plan { axes, samples: request.samples.unwrap_or(1), seed: request.seed };
    match (plan.is_random(), request.samples) {
        (true, None) => impossible("random axes without a number of samples", "say how many: --samples 1000"),
        (_, Some(0)) => impossible("no samples are asked for", "take at least one: --samples 1000"),
        (false, Some(_)) => impossible(
            "samples are asked for, but no axis is random",
            "leave out --samples, or draw values: --vary parameters.T0=\"uniform:1 N*m:100 N*m\"",
        ),
        _ => Ok(plan),
    }
}

/// The groups called `names`, in the order of their columns.
fn groups(names: &[String]) -> Result<Vec<&'static Group>, Error> {
    if let Some(unknown) = names.iter().find(|name| !record::GROUPS.iter().any(|group| group.name == **name)) {
        let known: Vec<_> = record::GROUPS.iter().map(|group| group.name).collect();
        return impossible(
            format!("nothing to record is called `{unknown}`"),
            format!("there are {}", known.join(", ")),
        );
    }
    Ok(record::GROUPS.iter().filter(|group| names.iter().any(|name| name == group.name)).collect())
}
