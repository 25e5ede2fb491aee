//! `summary.json`: what a run was, where it ended, and what it cost.
//!
//! All numbers are SI, in the shortest form that reads back bit for bit. JSON has no number for what is not
//! finite, so those are the strings `"inf"`, `"-inf"` and `"nan"`, never `null`: see [`Number`].

use std::fmt;

use serde::de::{self, MapAccess, Visitor};
use serde::ser::SerializeMap;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::OutputError;
use crate::trajectory::Trajectory;

/// The content of `summary.json`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Summary {
    /// Name of the scene.
    pub scene: String,
    /// Name of the model.
    pub model: String,
    /// Names of the effects the scene has.
    pub effects: Vec<String>,
    /// End of the run [s]: where it stopped, if it did not get as far as the scene asks.
    pub t_end: Number,
    /// Coordinates and speeds at the end, unwrapped [SI]: `theta`, `theta_dot`, ... in the order of the model.
    pub state: Named,
    /// Cell changes.
    pub cell_changes: u64,
    /// Reflections.
    pub reflections: u64,
    /// Energies at the end [J].
    pub energy: Energy,
    /// How it was solved.
    pub method: Method,
    /// What the solver did.
    pub counts: Counts,
    /// How many digits of the state are left; `null` where that was not estimated.
    pub digits: Option<Digits>,
    /// What a reader has to know beside the numbers, a sentence each.
    pub remarks: Vec<String>,
    /// Processor time that the simulation took, with its recording [s].
    pub cpu_seconds: Number,
    /// Whether the run got as far as the scene asks.
    pub completed: bool,
    /// Why not, if not.
    pub stopped_by: Option<String>,
    /// Parameter values [SI], in the order of the model.
    pub parameters: Named,
    /// Files written beside this one.
    pub files: Vec<String>,
    /// Where the result comes from.
    pub provenance: Provenance,
}

/// The energy account at the end of a run [J].
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
    /// T + V - W + dissipated, less `at_start`.
    pub residual: Number,
    /// T + V - W at the start.
    pub at_start: Number,
    /// The largest part of the account at any row, by which the residual is to be measured.
    pub largest: Number,
}

/// How many digits of the state are left.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Digits {
    /// At the end, of its worst coordinate or speed: 0 to 16.
    pub at_end: Number,
    /// Time from which on none are left [s]; `null` where some are. From there on the state is one of many.
    pub none_from: Option<Number>,
}

/// How a run was solved.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Method {
    /// The method, by its name in scenes.
    pub name: String,
    /// Why it was this one.
    pub why: String,
    /// Steps of a numerical method; 0 for the exact one, which has none.
    pub steps: u64,
    /// Steps that it tried in vain.
    pub rejected: u64,
}

/// What the solver did.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Counts {
    /// Evaluations of the solution or of the right-hand side.
    pub function_evaluations: u64,
    /// Steps of the root finder.
    pub root_steps: u64,
    /// Grazing contacts with a switching angle.
    pub grazes: u64,
    /// Times that a phase was held at a step it could not climb.
    pub holds: u64,
    /// Times that flanks met across their play.
    pub impacts: u64,
    /// Energy of its bounces that were not followed to their end [J]; the residual counts it as lost.
    pub ignored: Number,
    /// Steps of two phases met together whose order matters: the result is one of several.
    pub ambiguous: u64,
}

/// Where a result comes from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Provenance {
    /// Program, e.g. `gearsim`.
    pub program: String,
    /// Its version.
    pub version: String,
    /// The commit it was built from, where known.
    pub commit: Option<String>,
    /// SHA-256 of the scene's text and overrides.
    pub scene_sha256: String,
    /// The solver that ran.
    pub solver: String,
    /// Overrides given on the command line, e.g. `T0=20 N*m`.
    pub overrides: Vec<String>,
}

impl Summary {
    /// The text of `summary.json`. Errors: [`OutputError::Format`].
    pub fn json(&self) -> Result<String, OutputError> {
        let text = serde_json::to_string_pretty(self).map_err(|e| OutputError::format("JSON", e))?;
        Ok(text + "\n")
    }
}

impl Energy {
    /// The account in the last row of `run`; `None` if it has none.
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

/// A number of any kind: finite ones as JSON numbers, others as `"inf"`, `"-inf"`, `"nan"`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Number(pub f64);

impl From<f64> for Number {
    fn from(x: f64) -> Self {
        Number(x)
    }
}

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            x if x.is_finite() => s.serialize_f64(x),
            x if x.is_nan() => s.serialize_str("nan"),
            x if x > 0.0 => s.serialize_str("inf"),
            _ => s.serialize_str("-inf"),
        }
    }
}

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged)]
        enum Form {
            Finite(f64),
            Word(String),
        }
        match Form::deserialize(d)? {
            Form::Finite(x) => Ok(Number(x)),
            Form::Word(word) => match word.as_str() {
                "inf" => Ok(Number(f64::INFINITY)),
                "-inf" => Ok(Number(f64::NEG_INFINITY)),
                "nan" => Ok(Number(f64::NAN)),
                _ => Err(de::Error::custom(format!("`{word}` is not a number"))),
            },
        }
    }
}

/// Numbers by name, in an order that is kept: an object in JSON.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Named(pub Vec<(String, Number)>);

impl Named {
    /// The state in the last row of `run`; empty if it has none.
    pub fn state(run: &Trajectory) -> Self {
        let mut state = vec![];
        for ((coordinate, q), q_dot) in run.model.coordinates.iter().zip(&run.q).zip(&run.q_dot) {
            if let (Some(&q), Some(&q_dot)) = (q.last(), q_dot.last()) {
                state.push((coordinate.name.to_owned(), Number(q)));
                state.push((format!("{}_dot", coordinate.name), Number(q_dot)));
            }
        }
        Named(state)
    }

    /// The number called `name`.
    pub fn get(&self, name: &str) -> Option<f64> {
        self.0.iter().find(|(n, _)| n == name).map(|(_, x)| x.0)
    }
}

impl<N: Into<String>> FromIterator<(N, f64)> for Named {
    fn from_iter<I: IntoIterator<Item = (N, f64)>>(pairs: I) -> Self {
        Named(pairs.into_iter().map(|(name, x)| (name.into(), Number(x))).collect())
    }
}

impl Serialize for Named {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        let mut map = s.serialize_map(Some(self.0.len()))?;
        for (name, x) in &self.0 {
            map.serialize_entry(name, x)?;
        }
        map.end()
    }
}

impl<'de> Deserialize<'de> for Named {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        struct InOrder;
        impl<'de> Visitor<'de> for InOrder {
            type Value = Named;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object of numbers")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Named, A::Error> {
                let mut pairs = vec![];
                while let Some(pair) = map.next_entry()? {
                    pairs.push(pair);
                }
                Ok(Named(pairs))
            }
        }
        d.deserialize_map(InOrder)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::fixture::oscillator;

    fn summary() -> Summary {
        let run = oscillator(1000);
        Summary {
            scene: "energy_300rpm".into(),
            model: run.model.name.into(),
            effects: vec!["damping".into()],
            t_end: Number(0.1),
            state: Named::state(&run),
            cell_changes: 12,
            reflections: 0,
            energy: Energy::at_end(&run).unwrap(),
            method: Method { name: "exact".into(), why: "linear cells".into(), steps: 0, rejected: 0 },
            counts: Counts {
                function_evaluations: 1,
                root_steps: 2,
                grazes: 3,
                holds: 4,
                impacts: 5,
                ignored: Number(5e-12),
                ambiguous: 6,
            },
            digits: Some(Digits { at_end: Number(11.5), none_from: None }),
            remarks: vec!["one of two equilibria".into()],
            cpu_seconds: Number(0.01),
            completed: false,
            stopped_by: Some("stalled".into()),
            parameters: [("T0", 10.0), ("I1", 1.0 / 3.0)].into_iter().collect(),
            files: vec!["trajectory.parquet".into()],
            provenance: Provenance {
                program: "gearsim".into(),
                version: "0.1.0".into(),
                commit: None,
                scene_sha256: "00".into(),
                solver: "closed form".into(),
                overrides: vec![],
            },
        }
    }

    #[test]
    fn it_reads_back_as_written_and_in_order() {
        let written = summary();
        let text = written.json().unwrap();
        assert_eq!(serde_json::from_str::<Summary>(&text).unwrap(), written);
        let place = |key: &str| text.find(&format!("\"{key}\"")).unwrap();
        assert!(place("theta") < place("theta_dot") && place("theta_dot") < place("phi"));
        assert!(place("T0") < place("I1"));
    }

    #[test]
    fn what_is_not_finite_is_a_word() {
        let mut odd = summary();
        odd.cpu_seconds = Number(f64::NEG_INFINITY);
        odd.parameters = [("cap", f64::INFINITY), ("x", f64::NAN)].into_iter().collect();
        let text = odd.json().unwrap();
        assert!(text.contains(r#""cpu_seconds": "-inf""#), "{text}");
        let back: Summary = serde_json::from_str(&text).unwrap();
        assert_eq!(back.parameters.get("cap"), Some(f64::INFINITY));
        assert!(back.parameters.get("x").unwrap().is_nan());
        assert!(serde_json::from_str::<Number>("\"much\"").is_err());
    }
}
