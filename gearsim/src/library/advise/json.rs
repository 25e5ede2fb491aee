//! The advice as JSON.

use serde::Serialize;

use super::{Advice, Error, Estimate, Verdict};
use crate::analysis::advise::{Apart, LIMITS};
use crate::output::document;
use crate::scene::Scene;

/// Version of the format.
const VERSION: u32 = 1;

/// Relative deviations of two runs; 0.01 is 1 %.
#[derive(Serialize)]
struct Deviation {
    rms: f64,
    peak: f64,
    /// Of the power in a frequency band [dB].
    bands_db: f64,
    speed: f64,
    energy: f64,
    events: f64,
}

#[derive(Serialize)]
struct Candidate<'a> {
    /// What is left out.
    without: &'a str,
    /// How the list of effects changes.
    how: &'a str,
    /// From what the deviation is estimated.
    estimated_from: &'static str,
    /// `null` where there is no estimate.
    estimate: Option<Deviation>,
    /// Between full runs; `null` if one cannot be run.
    truth: Option<Deviation>,
    /// Why there is no estimate or no truth.
    why: Vec<&'a str>,
    negligible_by_estimate: Option<bool>,
    negligible: Option<bool>,
    /// Processor time without it, over that of the scene.
    time_ratio: f64,
}

#[derive(Serialize)]
struct Mesh<'a> {
    law: &'a str,
    jump_strength: f64,
    mesh_frequency: f64,
    stiffness_ratio: f64,
}

#[derive(Serialize)]
struct Report<'a> {
    scene: &'a str,
    model: &'a str,
    /// Groups of every law that steps; `null` if the scene has none.
    meshes: Option<Vec<Mesh<'a>>>,
    /// Damped natural frequency [Hz] and damping factor of each mode; `null` if the scene has none.
    modes: Option<Vec<[f64; 2]>>,
    /// Deviations up to these are negligible.
    limits: Deviation,
    candidates: Vec<Candidate<'a>>,
    /// Processor time of the scene [s].
    seconds: f64,
    reflections: u64,
    /// Why the run of the scene stopped early, or is wrong.
    wrong: Option<String>,
}

impl Advice {
    /// The advice on a scene as JSON, of the format `gearsim.advise`.
    ///
    /// # Errors
    /// If JSON cannot be written.
    pub fn json(&self, scene: &Scene) -> Result<String, Error> {
        let groups = self.groups.as_ref().ok();
        let mesh = |mesh: &crate::analysis::advise::groups::Mesh| Mesh {
            law: mesh.law,
            jump_strength: mesh.strength,
            mesh_frequency: mesh.frequency,
            stiffness_ratio: mesh.ratio,
        };
        let report = Report {
            scene: &scene.name,
            model: scene.model.name,
            meshes: groups.map(|groups| groups.meshes.iter().map(mesh).collect()),
            modes: groups.map(|groups| groups.modes.iter().map(|mode| [mode.0, mode.1]).collect()),
            limits: deviation(&LIMITS),
            candidates: self.verdicts.iter().map(candidate).collect(),
            seconds: self.seconds,
            reflections: self.reflections,
            wrong: self.wrong(),
        };
        Ok(document::json("advise", VERSION, &report)?)
    }
}

fn candidate(verdict: &Verdict) -> Candidate<'_> {
    let estimated_from = match &verdict.estimate {
        Estimate::Settled(_) => "settled motion",
        Estimate::Short(_) => "short runs",
        Estimate::TurnedBack => "the strength of the steps",
        Estimate::None(_) => "nothing",
    };
    let no_truth = verdict.truth.as_ref().err().map(String::as_str);
    let (negligible_by_estimate, negligible) = verdict.negligible();
    Candidate {
        without: &verdict.candidate.without,
        how: &verdict.candidate.how,
        estimated_from,
        estimate: verdict.estimate.deviation().map(deviation),
        truth: verdict.truth.as_ref().ok().map(deviation),
        why: verdict.estimate.why_not().into_iter().chain(no_truth).collect(),
        negligible_by_estimate,
        negligible,
        time_ratio: verdict.time,
    }
}

fn deviation(apart: &Apart) -> Deviation {
    let Apart { rms, peak, bands, speed, energy, events } = *apart;
    Deviation { rms, peak, bands_db: bands, speed, energy, events }
}
