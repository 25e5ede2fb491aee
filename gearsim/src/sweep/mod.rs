//! Sweeps: a scene is run at many points, each with its own values in place of those of the scene, on all cores and on many machines.
//!
//! Programs begin with [`Scene::vary`](crate::Scene::vary). The result depends on the scene and on the definition of the points alone: the
//! bytes are the same for any number of threads, interruptions and machines.

// `axis`, `design` and `plan` define the points and their order. `record` defines which results of a point are kept. `run` runs the
// points, `row` converts results to tables, and `manifest` describes the sweep. `folder` stores finished points, so that an interrupted
// sweep can be resumed. `merge` joins the results of several machines.

pub(crate) mod answers;
pub(crate) mod axis;
pub(crate) mod design;
mod distribution;
pub(crate) mod folder;
pub(crate) mod manifest;
pub(crate) mod merge;
mod parse;
pub(crate) mod plan;
mod random;
pub(crate) mod record;
pub mod response;
pub(crate) mod row;
pub(crate) mod run;
pub(crate) mod shard;
pub(crate) mod spectra;
#[cfg(test)]
mod tests;

use std::collections::BTreeSet;
use std::path::Path;

pub use design::Design;
pub(crate) use manifest::Manifest;
pub(crate) use plan::Plan;
pub(crate) use row::Status;
pub(crate) use shard::Shard;

use crate::model::Model;
use crate::output::OutputError;
use crate::run::Entry;
use crate::scene::{Scene, SceneMistakes, Template};
use crate::tolerance::scene::SWEEP_POINTS;
use axis::Axis;
use record::{Column, Group};

/// The definition of a sweep, as the user wrote it.
#[derive(Debug, Clone, Default, PartialEq)]
#[doc(hidden)]
pub struct Request {
    /// The axes as text, e.g. `parameters.T0=1:100:50`.
    pub vary: Vec<String>,
    /// Values that replace those of the scene at all points, e.g. `run.t_end=1 s`.
    pub overrides: Vec<String>,
    /// Number of samples per grid point; needed if an axis is random.
    pub samples: Option<usize>,
    /// How the samples are chosen.
    pub design: Design,
    /// Seed of random axes.
    pub seed: u64,
    /// Start of the time span over which extremes and spectra are computed [s]; `None`: `output.from` of the scene.
    pub from: Option<f64>,
    /// Names of the groups of quantities to record.
    pub record: Vec<String>,
    /// Whether the spectra are stored.
    pub spectra: bool,
}

/// A sweep, checked and ready to run.
#[doc(hidden)]
pub struct Sweep {
    /// The scene without the values of a point.
    template: Template,
    /// Its model.
    pub entry: Entry,
    /// Its points.
    pub plan: Plan,
    /// The groups of quantities to record.
    pub groups: Vec<&'static Group>,
    /// The outputs that at least one point records, as indices into `model.outputs`.
    pub outputs: Vec<usize>,
    /// Start of the time span over which extremes and spectra are computed [s].
    pub from: f64,
    /// Whether the spectra are stored.
    pub spectra: bool,
    /// Number of points.
    pub points: usize,
}

/// Why a sweep cannot be run or read.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The scene or an axis is not valid.
    #[error(transparent)]
    Scene(Box<SceneMistakes>),
    /// A file could not be written or read.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The request contradicts itself, or does not fit the files that are there.
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
    /// Reads the scene at `path`, whose model is one of `entries`, and checks it with the values of every axis.
    ///
    /// # Errors
    /// All mistakes in the scene, the axes and the request. No point has run then. A key must not be both set and varied.
    pub fn load(path: &Path, entries: &[Entry], request: &Request) -> Result<Sweep, Error> {
        let sweep = Sweep::of(Template::load(path, &request.overrides)?, entries, request)?;
        match request.overrides.iter().find(|set| is_varied(&request.vary, set)) {
            Some(set) => impossible(format!("`{}` is both set and varied", key(set)), "remove its --set or its --vary"),
            None => Ok(sweep),
        }
    }

    /// The sweep of a scene that is read, with the overrides of the request. If a key is both set and varied, the values of the axis
    /// are used, because a program may have built the scene from set values.
    ///
    /// # Errors
    /// Those of [`Sweep::load`], except the one for a key that is both set and varied.
    pub fn of(template: Template, entries: &[Entry], request: &Request) -> Result<Sweep, Error> {
        let models: Vec<_> = entries.iter().map(|entry| entry.model).collect();
        let model = template.model(&models);
        let found = entries.iter().find(|entry| model.is_some_and(|model| model.name == entry.model.name));
        let Some((model, entry)) = model.zip(found) else {
            // Without a model the scene has at least one error, which names it.
            return match template.scene(&[], &models) {
                Err(errors) => Err(errors.into()),
                Ok(scene) => impossible(format!("scene {} has no model", scene.name), "give it one"),
            };
        };
        let entry = entry.described(model);
        let plan = plan(&template, entry, request)?;
        let Some(points) = plan.points().filter(|&points| points > 0) else {
            return impossible(
                format!("the axes make more than {SWEEP_POINTS} points, or none"),
                "take fewer values, or several sweeps",
            );
        };
        let groups = groups(&request.record)?;
        let mut sweep =
            Sweep { template, entry, plan, groups, outputs: vec![], from: 0.0, spectra: request.spectra, points };
        sweep.from = match request.from {
            Some(from) => from,
            None => sweep.first()?.output.from,
        };
        sweep.outputs = sweep.check()?;
        Ok(sweep)
    }

    /// Name of the scene.
    pub fn scene(&self) -> &str {
        self.template.name()
    }

    /// The text of the scene, without overrides.
    pub fn text(&self) -> &str {
        self.template.text()
    }

    /// The scene at the first point. Errors: those of the scene.
    pub fn first(&self) -> Result<Scene, Error> {
        Ok(self.template.scene(&self.plan.overrides(0), &[self.entry.model])?)
    }

    /// SHA-256 of the scene with its overrides, without the values of a point.
    pub fn hash(&self) -> String {
        self.template.hash()
    }

    /// The recorded columns.
    pub fn columns(&self) -> Vec<Column> {
        record::columns(&self.groups, self.entry.model, &self.outputs)
    }

    /// Checks the scene at every value of every axis once ([`Plan::trials`]). Returns the outputs that at least one of these scenes records.
    fn check(&self) -> Result<Vec<usize>, Error> {
        let mut outputs = BTreeSet::new();
        for trial in self.plan.trials() {
            let scene: Scene = self.template.scene(&trial, &[self.entry.model])?;
            if self.from >= scene.t_end {
                let what = format!("the statistics begin at {} s, but the run ends at {} s", self.from, scene.t_end);
                return impossible(what, "choose an earlier start of the statistics, or a later run.t_end");
            }
            outputs.extend(scene.output.record);
        }
        Ok(outputs.into_iter().collect())
    }
}

/// The axes `vary` of a scene of `model`, e.g. `parameters.T0=1 N*m:100 N*m:50`.
///
/// # Errors
/// All mistakes in their texts.
pub(crate) fn axes(template: &Template, model: &Model, vary: &[String]) -> Result<Vec<Axis>, SceneMistakes> {
    let mut report = template.report();
    let axes = parse::axes(vary, template.axes(), model, &mut report);
    if report.is_empty() { Ok(axes) } else { Err(report.into_mistakes(template.name())) }
}

/// Whether an axis has the key of the override `set`.
pub(crate) fn is_varied(vary: &[String], set: &str) -> bool {
    vary.iter().any(|axis| key(axis) == key(set))
}

/// The key of an override or of an axis.
fn key(text: &str) -> &str {
    text.split('=').next().unwrap_or_default().trim()
}

/// The points that `request` defines.
fn plan(template: &Template, entry: Entry, request: &Request) -> Result<Plan, Error> {
    let axes = axes(template, entry.model, &request.vary)?;
    if axes.is_empty() {
        return impossible("nothing is varied", "give an axis: parameters.T0=\"1 N*m:100 N*m:50\"");
    }
    let plan = Plan::new(axes, request.design, request.samples.unwrap_or(1), request.seed);
    let random = plan.sampler.axes;
    if random > request.design.axes() {
        let what = format!("the design {} has at most {} random axes", request.design.name(), request.design.axes());
        return impossible(what, "fix some of them, or choose another design");
    }
    match (random > 0, request.samples) {
        (true, None) => impossible("random axes without a number of samples", "give `samples`, for example 1000"),
        (_, Some(0)) => impossible("the number of samples is 0", "take at least one, for example 1000"),
        (false, Some(_)) => impossible(
            "a number of samples is given, but no axis is random",
            "leave out `samples`, or vary at random: parameters.T0=\"uniform:1 N*m:100 N*m\"",
        ),
        (false, None) if request.design != Design::Random => impossible(
            format!("the design {} is given, but no axis is random", request.design.name()),
            "leave out `design`, or vary at random: parameters.T0=\"uniform:1 N*m:100 N*m\"",
        ),
        _ => Ok(plan),
    }
}

/// The groups called `names`, in the order of their columns.
fn groups(names: &[String]) -> Result<Vec<&'static Group>, Error> {
    if let Some(unknown) = names.iter().find(|name| !record::GROUPS.iter().any(|group| group.name == **name)) {
        let known: Vec<_> = record::GROUPS.iter().map(|group| group.name).collect();
        return impossible(
            format!("no group of quantities is called `{unknown}`"),
            format!("the groups are {}", known.join(", ")),
        );
    }
    Ok(record::GROUPS.iter().filter(|group| names.iter().any(|name| name == group.name)).collect())
}
