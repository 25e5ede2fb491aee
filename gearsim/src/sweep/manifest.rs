//! The definition of a sweep, stored as `sweep.json` in its folder. Results with equal manifests belong to the same sweep.
//!
//! What the file contains is in `output/schemas/sweep_manifest.schema.json`. A change that a reader of the file could notice raises [`VERSION`].

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::record::{self, Column, GROUPS, Group};
use super::{Design, Error, Plan, Request, Sweep, impossible};
use crate::model::Model;
use crate::output::OutputError;
use crate::output::summary::Number;
use crate::run::Entry;
use crate::scene::{Template, did_you_mean};
use crate::tolerance::scene::SWEEP_POINTS;

/// File name of the manifest.
pub const FILE: &str = "sweep.json";
/// Name of the format.
const FORMAT: &str = "gearsim.sweep_manifest";
/// Version of the format.
const VERSION: u32 = 3;

/// The definition of a sweep, and the program that ran it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Manifest {
    /// Name of the format of the file.
    pub format: String,
    /// Version of this format.
    pub version: u32,
    /// Program, e.g. `gearsim`.
    pub program: String,
    /// Its version.
    pub program_version: String,
    /// The commit it was built from, if known.
    pub commit: Option<String>,
    /// Name of the scene.
    pub scene: String,
    /// SHA-256 of the scene's text and overrides.
    pub scene_sha256: String,
    /// Name of the model.
    pub model: String,
    /// Values set at all points.
    pub overrides: Vec<String>,
    /// The axes as text.
    pub vary: Vec<String>,
    /// Number of samples per grid point, if an axis is random.
    pub samples: Option<usize>,
    /// How the samples are chosen.
    #[serde(default)]
    pub design: Design,
    /// Seed of random axes.
    pub seed: u64,
    /// Number of points.
    pub points: usize,
    /// Start of the time span over which extremes and spectra are computed \[s\].
    pub from: Number,
    /// Names of the groups of quantities that are recorded.
    pub record: Vec<String>,
    /// Names of the outputs that at least one point records, in the order of the model.
    pub outputs: Vec<String>,
    /// Whether the spectra are stored.
    pub spectra: bool,
    /// The text of the scene, if it lists the parts of its model: the columns follow from it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scene_text: Option<String>,
}

impl Manifest {
    /// The manifest of `sweep`, defined by `request`, run by the program built from `commit`.
    pub fn new(sweep: &Sweep, request: &Request, commit: Option<&str>) -> Manifest {
        Manifest {
            format: FORMAT.into(),
            version: VERSION,
            program: "gearsim".into(),
            program_version: env!("CARGO_PKG_VERSION").into(),
            commit: commit.map(Into::into),
            scene: sweep.scene().into(),
            scene_sha256: sweep.hash(),
            model: sweep.entry.model.name.into(),
            overrides: request.overrides.clone(),
            vary: request.vary.clone(),
            samples: request.samples,
            design: request.design,
            seed: request.seed,
            points: sweep.points,
            from: Number(sweep.from),
            record: sweep.groups.iter().map(|group| group.name.into()).collect(),
            outputs: sweep.outputs.iter().map(|&i| sweep.entry.model.outputs[i].name.into()).collect(),
            spectra: sweep.spectra,
            scene_text: (!sweep.entry.model.elements.is_empty()).then(|| sweep.text().into()),
        }
    }

    /// Reads the manifest in a folder; `None` if there is none. Errors: [`OutputError::Read`].
    pub fn read(folder: &Path) -> Result<Option<Manifest>, OutputError> {
        let path = folder.join(FILE);
        let failed = |why: String| OutputError::Read { path: path.clone(), why };
        match std::fs::read(&path) {
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(None),
            Err(error) => Err(failed(error.to_string())),
            Ok(bytes) => Manifest::parse(&bytes).map(Some).map_err(failed),
        }
    }

    /// Errors: why `bytes` are no manifest that this program reads.
    fn parse(bytes: &[u8]) -> Result<Manifest, String> {
        /// The keys that are read first, because a file of another version may have other keys.
        #[derive(Deserialize)]
        struct Head {
            format: String,
            version: u32,
        }
        let failed = |error: serde_json::Error| error.to_string();
        let Head { format, version } = serde_json::from_slice(bytes).map_err(failed)?;
        if (format.as_str(), version) != (FORMAT, VERSION) {
            return Err(format!(
                "it is of format {format}, version {version}; this program reads {FORMAT}, version {VERSION}"
            ));
        }
        serde_json::from_slice(bytes).map_err(failed)
    }

    /// The text of `sweep.json`. Errors: [`OutputError::Format`].
    pub fn json(&self) -> Result<String, OutputError> {
        Ok(serde_json::to_string_pretty(self).map_err(|e| OutputError::format("JSON", e))? + "\n")
    }

    /// The points of the sweep, and the columns of their rows.
    ///
    /// # Errors
    /// If this program does not have the model, cannot parse the axes, or finds another number of points.
    pub fn layout(&self, entries: &[Entry]) -> Result<Layout, Error> {
        let Some(entry) = entries.iter().find(|entry| entry.model.name == self.model) else {
            let help = "use the version of gearsim that ran the sweep";
            return impossible(format!("this gearsim does not have the model `{}` of the sweep", self.model), help);
        };
        let text = self.scene_text.as_deref().unwrap_or_default();
        let template = Template::parse(&self.scene, super::manifest::FILE, text, &self.overrides)?;
        let listed = template.model(&[entry.model]).filter(|_| self.scene_text.is_some());
        let entry = entry.described(listed.unwrap_or(entry.model));
        let request = Request {
            vary: self.vary.clone(),
            overrides: vec![],
            samples: self.samples,
            design: self.design,
            seed: self.seed,
            from: Some(self.from.0),
            record: self.record.clone(),
            spectra: self.spectra,
        };
        let plan = super::plan(&template, entry, &request)?;
        if plan.points() != Some(self.points) || self.points > SWEEP_POINTS {
            return impossible(
                format!("the number of points in {FILE}, {}, does not agree with its axes", self.points),
                "run the sweep again",
            );
        }
        let groups: Vec<_> = GROUPS.iter().filter(|group| self.record.iter().any(|name| name == group.name)).collect();
        let recorded = |i: &usize| self.outputs.iter().any(|name| name == entry.model.outputs[*i].name);
        let outputs: Vec<usize> = (0..entry.model.outputs.len()).filter(recorded).collect();
        let columns = record::columns(&groups, entry.model, &outputs);
        let units = super::row::units(&plan, entry.model);
        Ok(Layout { model: entry.model, plan, outputs, columns, units })
    }

    /// The differences to `other`, one text each; empty if the two are equal.
    pub fn differences(&self, other: &Manifest) -> Vec<String> {
        let mut found = vec![];
        let mut compare = |what: &str, here: String, there: String| {
            if here != there {
                found.push(format!("{what}: {here} here, {there} there"));
            }
        };
        let list = |texts: &[String]| if texts.is_empty() { "none".into() } else { texts.join(", ") };
        let build =
            |m: &Manifest| format!("{} {} ({})", m.program, m.program_version, m.commit.as_deref().unwrap_or("-"));
        compare("program", build(self), build(other));
        compare("scene", self.scene.clone(), other.scene.clone());
        compare("model", self.model.clone(), other.model.clone());
        compare("values set", list(&self.overrides), list(&other.overrides));
        if self.overrides == other.overrides {
            compare("text of the scene (SHA-256)", self.scene_sha256.clone(), other.scene_sha256.clone());
        }
        compare("axes", list(&self.vary), list(&other.vary));
        let samples = |m: &Manifest| m.samples.map_or("none".into(), |samples| samples.to_string());
        compare("samples", samples(self), samples(other));
        compare("design", self.design.name().into(), other.design.name().into());
        compare("seed", self.seed.to_string(), other.seed.to_string());
        compare("points", self.points.to_string(), other.points.to_string());
        compare("from [s]", self.from.0.to_string(), other.from.0.to_string());
        compare("recorded", list(&self.record), list(&other.record));
        compare("spectra", self.spectra.to_string(), other.spectra.to_string());
        found
    }
}

impl Layout {
    /// The index of a recorded quantity.
    ///
    /// # Errors
    /// [`Error::Impossible`] if no quantity of this name is recorded.
    pub fn column(&self, name: &str) -> Result<usize, Error> {
        self.columns.iter().position(|(column, _)| column == name).ok_or_else(|| {
            let names: Vec<&str> = self.columns.iter().map(|(name, _)| name.as_str()).collect();
            let meant = did_you_mean(name, names.iter().copied());
            let meant = meant.map_or(String::new(), |near| format!("did you mean `{near}`? "));
            let of = |outputs: &[usize]| {
                let has =
                    |group: &&Group| (group.columns)(self.model, outputs).iter().any(|(column, _)| column == name);
                GROUPS.iter().find(has)
            };
            let all: Vec<usize> = (0..self.model.outputs.len()).collect();
            let help = match (of(&self.outputs), of(&all)) {
                (Some(group), _) => format!("name its group of quantities too: --record {},...", group.name),
                (None, Some(_)) => {
                    "no point of the sweep records this output: name it in output.record, and its effect in effects"
                        .into()
                }
                (None, None) => format!("{meant}the recorded quantities are {}", names.join(", ")),
            };
            Error::Impossible { what: format!("no quantity `{name}` is recorded"), help }
        })
    }
}

/// The points of a sweep and the columns of its results.
#[derive(Debug, Clone)]
pub struct Layout {
    /// The model.
    pub model: &'static Model,
    /// Its points.
    pub plan: Plan,
    /// The outputs that at least one point records, as indices into `model.outputs`.
    pub outputs: Vec<usize>,
    /// Its recorded columns.
    pub columns: Vec<Column>,
    /// SI units of the columns of the varied keys.
    pub units: Vec<String>,
}
