//! The reference motion that runs are compared with, and an estimate of its own error.

use crate::engine::Refusal;
use crate::run::Outcome;
use crate::scene::Scene;
use crate::scene::solver::{Method, Precision, Solver};

use super::Runner;
use super::error::{self, Errors};
use crate::tolerance::analysis::{self, REFERENCE};

/// A reference motion.
#[derive(Debug, Clone)]
pub struct Reference {
    /// How it was computed.
    pub by: By,
    /// The run, with samples and the rows before and after events.
    pub outcome: Outcome,
    /// Estimate of its error along the path.
    pub error: f64,
}

/// How a reference is computed: the most accurate way that the scene allows.
#[derive(Debug, Clone, PartialEq)]
pub enum By {
    /// Exact cells in double-double precision.
    Compensated,
    /// Two numerical methods at the tightest tolerance. The text says why there are no exact cells.
    Steps(String),
}

impl Reference {
    /// Number of its events.
    pub fn events(&self) -> u64 {
        self.outcome.counts.events()
    }
}

/// Number of samples along the path: enough to resolve every oscillation of a short scene, few enough to keep in memory.
pub const SAMPLES: f64 = 2000.0;

/// The reference for `scene`: the run of the exact engine in double-double precision, whose error is the rounding of the recorded values
/// (`tests/suite/engine.rs` compares it with another engine in 50 digits). If the scene has no exact cells, two numerical methods of
/// different kinds.
///
/// # Errors
/// Why no reference runs to its end, in words.
pub fn of(scene: &Scene, run: Runner<'_>) -> Result<Reference, String> {
    let mut scene = recorded(scene);
    scene.solver = Solver { method: Some(Method::Exact), precision: Precision::Compensated, ..Solver::default() };
    match run(&scene) {
        Err(Refusal::Nonlinear { terms } | Refusal::CompensatedNumerical(terms)) => by_steps(&scene, terms, run),
        outcome => {
            let outcome = complete(outcome)?;
            Ok(Reference { by: By::Compensated, outcome, error: analysis::SAMPLE_ROUNDINGS * f64::EPSILON })
        }
    }
}

/// The run by the explicit method of high order. Its error is the difference to an implicit method, which shares no formula with it.
fn by_steps(scene: &Scene, why: String, run: Runner<'_>) -> Result<Reference, String> {
    let by = |method| {
        let mut scene = scene.clone();
        scene.solver = Solver { method: Some(method), tolerance: REFERENCE, ..Solver::default() };
        complete(run(&scene))
    };
    let (outcome, other) = (by(Method::Dop853)?, by(Method::Radau)?);
    let Errors { path, end, events, .. } = error::of(&other, &outcome, 0.0);
    if events != 0 {
        return Err(format!("dop853 and radau find different numbers of events at a tolerance of {REFERENCE:e}"));
    }
    Ok(Reference { by: By::Steps(why), outcome, error: path.max(end).max(analysis::SAMPLE_ROUNDINGS * f64::EPSILON) })
}

fn complete(outcome: Result<Outcome, Refusal>) -> Result<Outcome, String> {
    let outcome = outcome.map_err(|refusal| refusal.to_string())?;
    match (&outcome.stopped_by, &outcome.refuted) {
        (Some(stop), _) => Err(stop.to_string()),
        (None, Some(account)) => Err(account.to_string()),
        (None, None) => Ok(outcome),
    }
}

/// The scene with the samples and events recorded that errors are computed from.
pub fn recorded(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    scene.output.rate = SAMPLES / scene.t_end;
    scene.output.events = true;
    scene.output.record.clear();
    scene
}
