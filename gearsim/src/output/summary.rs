//! `summary.json`: the scene and method of a run, its end state, its energy account and its processor time.
//!
//! All numbers are in SI units, in the shortest form that reads back bit for bit. JSON has no infinite numbers and no NaN: such a
//! number is `null`, and `missing` gives the reason, see [`Number`]. The format is described by the JSON Schema
//! `schemas/summary.schema.json`. A change that a reader of the file could notice raises [`VERSION`].

use std::collections::BTreeMap;

use indexmap::IndexMap;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::OutputError;
use super::unit::coordinate_in_words;
use crate::model::Model;
use crate::trajectory::Trajectory;

mod evaluated;
mod observed;

pub use evaluated::{LawFromTeeth, Level, LoadSpectrum, Mesh, Rows, Sound};
pub use observed::Observed;

/// Name of the format of `summary.json`.
pub const FORMAT: &str = "gearsim.summary";
/// Version of the format. Files of version 0 have neither `format` nor `version`.
pub const VERSION: u32 = 6;

/// The content of `summary.json`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Summary {
    /// [`FORMAT`].
    pub format: String,
    /// [`VERSION`].
    pub version: u32,
    /// Name of the scene.
    pub scene: String,
    /// Name of the model.
    pub model: String,
    /// Names of the scene's effects.
    pub effects: Vec<String>,
    /// Time reached \[s\]; less than the scene's `t_end` if the run stopped early.
    pub t_end: Number,
    /// Coordinates and speeds at the end, unwrapped \[SI\]: `theta`, `theta_dot`, ... in the order of the model.
    pub state: Named,
    /// Number of cell changes.
    pub cell_changes: u64,
    /// Number of reflections.
    pub reflections: u64,
    /// Energies at the end \[J\].
    pub energy: Energy,
    /// Statistics of the recorded outputs, by name.
    pub outputs: IndexMap<String, Observed>,
    /// Rows of the trajectory by their kind.
    pub rows: Rows,
    /// Loads of the meshes whose forces are recorded, by their stiffness laws.
    pub meshes: IndexMap<String, Mesh>,
    /// The stiffnesses that the scene gives by teeth, by their names.
    pub laws_from_teeth: IndexMap<String, LawFromTeeth>,
    /// Load spectra of the signals that the scene names, by name.
    pub load_spectra: IndexMap<String, LoadSpectrum>,
    /// Signals written as sound, by name.
    pub sounds: IndexMap<String, Sound>,
    /// Share of the run's time in each mode of each switch: `over12`, `free` \[1\].
    pub modes: BTreeMap<String, Named>,
    /// Number of impacts of each kind. The model names the kinds, for example `flanks met` and `stop met`.
    pub impacts: IndexMap<String, u64>,
    /// The method that solved it.
    pub method: Method,
    /// Counts of the solver.
    pub counts: Counts,
    /// Number of digits left of the state; `null` if it was not estimated.
    pub digits: Option<Digits>,
    /// Notes that a reader of the numbers needs, one sentence each.
    pub remarks: Vec<String>,
    /// Processor time of the simulation, including the recording \[s\].
    pub cpu_seconds: Number,
    /// Whether the run reached the scene's `t_end`.
    pub completed: bool,
    /// Why it stopped early; `null` if it did not.
    pub stopped_by: Option<String>,
    /// Why the result is wrong, by its energy account; `null` if the account closes.
    pub refuted: Option<String>,
    /// Parameter values \[SI\], in the order of the model.
    pub parameters: Named,
    /// Why a number is `null`, by the path of the number: `parameters.b`.
    pub missing: BTreeMap<String, String>,
    /// Names of the other files of the run in the same folder.
    pub files: Vec<String>,
    /// Program, scene and solver that made the result.
    pub provenance: Provenance,
}

/// The energy account at the end of a run \[J\].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Energy {
    /// Kinetic energy.
    pub kinetic: Number,
    /// Strain energy.
    pub strain: Number,
    /// Net work of the external torques.
    pub work: Number,
    /// Energy lost to damping.
    pub dissipated: Number,
    /// T + V - W + dissipated - `at_start`.
    pub residual: Number,
    /// T + V - W at the start.
    pub at_start: Number,
    /// The largest part of the account in any row. The residual is judged relative to it.
    pub largest: Number,
}

/// The number of digits left of the state.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Digits {
    /// Digits left at the end, of the worst coordinate or speed: 0 to 16.
    pub at_end: Number,
    /// Time from which on no digits are left \[s\]; `null` if some are left to the end. After this time the state is one of many.
    pub none_from: Option<Number>,
}

/// The method that solved a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Method {
    /// Its name, as in scenes.
    pub name: String,
    /// Why this method was chosen.
    pub why: String,
    /// Number of time steps; 0 for the exact method, which has none.
    pub steps: u64,
    /// Number of rejected time steps.
    pub rejected: u64,
}

/// Counts of the solver.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Counts {
    /// Number of evaluations of the solution, or of the right-hand side.
    pub function_evaluations: u64,
    /// Number of iterations of the root finder.
    pub root_steps: u64,
    /// Number of grazes: a phase touched a step without passing it.
    pub grazes: u64,
    /// Number of times that a phase was held at a step because its energy was too small to pass.
    pub holds: u64,
    /// Number of impacts of all kinds. An impact is a contact of flanks or stops that had been apart.
    pub impacts: u64,
    /// Number of times that dry friction brought a motion to rest, or a clutch locked.
    pub sticks: u64,
    /// Energy of the bounces that were ignored when phases were held \[J\]; the residual counts it as lost.
    pub ignored: Number,
    /// Number of times that two phases met steps at the same instant and the order changed the result, which is then one of several.
    pub ambiguous: u64,
}

/// The program, the scene and the solver that made a result.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Provenance {
    /// Program, e.g. `gearsim`.
    pub program: String,
    /// Its version.
    pub version: String,
    /// The commit it was built from, if known.
    pub commit: Option<String>,
    /// SHA-256 of the scene's text and overrides.
    pub scene_sha256: String,
    /// The solver, in words.
    pub solver: String,
    /// Values set on the command line, e.g. `parameters.T0=20 N*m`.
    pub overrides: Vec<String>,
}

impl Summary {
    /// The coordinates and speeds at the end with their units, in words.
    pub fn state_in_words(&self, model: &Model) -> String {
        let units = model.coordinates.iter().flat_map(|c| [c.unit.to_owned(), format!("{}/s", c.unit)]);
        let entries = self.state.0.iter().zip(units);
        let entries = entries.map(|((name, x), unit)| format!("{name} = {}", coordinate_in_words(x.0, &unit)));
        entries.collect::<Vec<_>>().join(", ")
    }

    /// Fills `missing`: the reason for every number that is not finite.
    pub fn note_missing(&mut self) {
        let Energy { kinetic, strain, work, dissipated, residual, at_start, largest } = self.energy;
        let energy = [
            ("kinetic", kinetic),
            ("strain", strain),
            ("work", work),
            ("dissipated", dissipated),
            ("residual", residual),
            ("at_start", at_start),
            ("largest", largest),
        ];
        let others =
            [("t_end", self.t_end), ("counts.ignored", self.counts.ignored), ("cpu_seconds", self.cpu_seconds)];
        let computed = (others.into_iter().map(|(name, x)| (name.to_owned(), x)))
            .chain(energy.into_iter().map(|(name, x)| (format!("energy.{name}"), x)))
            .chain(self.outputs.iter().flat_map(|(output, observed)| {
                observed.numbers().map(|(what, x)| (format!("outputs.{output}.{what}"), x))
            }))
            .chain(
                self.meshes
                    .iter()
                    .flat_map(|(mesh, load)| load.numbers().map(|(what, x)| (format!("meshes.{mesh}.{what}"), x))),
            )
            .chain(self.state.0.iter().map(|(name, x)| (format!("state.{name}"), *x)));
        let reason = |x: Number| match x.0 {
            x if x.is_nan() => "not a number: the run has no row, or the motion left the range of numbers",
            _ => "infinite: the motion left the range of numbers",
        };
        let computed = computed.map(|(path, x)| (path, x, reason(x)));
        let parameters = self.parameters.0.iter();
        let given = parameters
            .map(|(name, x)| (format!("parameters.{name}"), *x, "not given: no effect of the scene needs it"));
        let missing = computed.chain(given).filter(|(_, x, _)| !x.0.is_finite());
        self.missing = missing.map(|(path, _, why)| (path, why.to_owned())).collect();
    }

    /// The text of `summary.json`. Errors: [`OutputError::Format`].
    pub fn json(&self) -> Result<String, OutputError> {
        let text = serde_json::to_string_pretty(self).map_err(|e| OutputError::format("JSON", e))?;
        Ok(text + "\n")
    }
}

impl Energy {
    /// The account in the last row of `run`; `None` if it has no rows.
    pub fn at_end(run: &Trajectory) -> Option<Self> {
        let start = run.kinetic.first()? + run.strain.first()? - run.work.first()?;
        Some(Energy {
            kinetic: Number(*run.kinetic.last()?),
            strain: Number(*run.strain.last()?),
            work: Number(*run.work.last()?),
            dissipated: Number(*run.dissipated.last()?),
            residual: Number(*run.residual.last()?),
            at_start: Number(start),
            largest: Number(run.largest_energy()),
        })
    }
}

/// A number that may be infinite or NaN. JSON has no such numbers: they are `null`, and read back as NaN.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Number(pub f64);

impl From<f64> for Number {
    fn from(x: f64) -> Self {
        Number(x)
    }
}

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        self.0.is_finite().then_some(self.0).serialize(s)
    }
}

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        Ok(Number(Option::deserialize(d)?.unwrap_or(f64::NAN)))
    }
}

/// Named numbers in a fixed order: an object in JSON.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Named(pub IndexMap<String, Number>);

impl Named {
    /// The state in the last row of `run`; empty if it has no rows.
    pub fn state(run: &Trajectory) -> Self {
        let pairs = run.model.coordinates.iter().zip(run.q.iter().zip(&run.q_dot));
        let last = pairs.filter_map(|(c, (q, q_dot))| Some((c.name, *q.last()?, *q_dot.last()?)));
        last.flat_map(|(name, q, q_dot)| [(name.to_owned(), q), (format!("{name}_dot"), q_dot)]).collect()
    }

    /// The number called `name`.
    pub fn get(&self, name: &str) -> Option<f64> {
        self.0.get(name).map(|x| x.0)
    }
}

impl<N: Into<String>> FromIterator<(N, f64)> for Named {
    fn from_iter<I: IntoIterator<Item = (N, f64)>>(pairs: I) -> Self {
        Named(pairs.into_iter().map(|(name, x)| (name.into(), Number(x))).collect())
    }
}

#[cfg(test)]
mod tests;
