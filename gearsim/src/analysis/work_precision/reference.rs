//! The motion that others are compared with, and how far it is to be trusted itself.

use crate::engine::Refusal;
use crate::run::Outcome;
use crate::scene::Scene;
use crate::scene::solver::{Method, Precision, Solver};

use super::Runner;
use super::error::{self, Errors};

/// A reference.
#[derive(Debug, Clone)]
pub struct Reference {
    /// How it was found.
    pub by: By,
    /// What it came to, with samples and the limits at events.
    pub outcome: Outcome,
    /// Its error along the path, as it is estimated.
    pub error: f64,
}

/// How a reference is found: in the best way that a scene allows.
#[derive(Debug, Clone, PartialEq)]
pub enum By {
    /// Exact cells in twice the digits.
    Compensated,
    /// Exact cells in plain numbers.
    Plain,
    /// Two methods by steps, at the tightest tolerance; and why there are no exact cells, in words.
    Steps(String),
}

impl Reference {
    /// Its events.
    pub fn events(&self) -> u64 {
        self.outcome.counts.events()
    }
}

/// Samples along the path: enough to see every oscillation of a short scene, few enough to keep.
pub const SAMPLES: f64 = 2000.0;
/// Roundings by which the start is moved to see what becomes of one.
const MOVED: f64 = 4.0;
/// Tolerance of references by steps: below it rounding takes over.
const TIGHTEST: f64 = 1e-13;
/// Roundings in a sample of a compensated run, which is taken by a plain flight from the last event.
const RECORDED: f64 = 16.0;

/// The reference for `scene`: the exact engine's run in twice the digits, whose error is the rounding of what it records.
/// (`tests/suite/engine.rs` holds it to another engine, in 50 digits.) Where a scene cannot have that, the plain run; where
/// it has no exact cells, two methods of different kinds.
///
/// # Errors
/// Where none of them runs to its end, in words.
pub fn of(scene: &Scene, run: Runner<'_>) -> Result<Reference, String> {
    let mut scene = recorded(scene);
    scene.solver = Solver { method: Some(Method::Exact), precision: Precision::Compensated, ..Solver::default() };
    match run(&scene) {
        Err(Refusal::CompensatedCoupling | Refusal::CompensatedCells | Refusal::CompensatedVarying { .. }) => {
            plain(&scene, run)
        }
        Err(Refusal::Nonlinear { terms } | Refusal::CompensatedNumerical(terms)) => by_steps(&scene, terms, run),
        outcome => {
            let outcome = complete(outcome)?;
            Ok(Reference { by: By::Compensated, outcome, error: RECORDED * f64::EPSILON })
        }
    }
}

/// The plain run. Its error is roundings, one an event or so, each carried on by the motion: the scene is run again from
/// speeds that are a few roundings higher, and what becomes of these is scaled to as many as add up at random over the
/// events.
fn plain(scene: &Scene, run: Runner<'_>) -> Result<Reference, String> {
    let mut scene = scene.clone();
    scene.solver.precision = Precision::Plain;
    let outcome = complete(run(&scene))?;
    let mut moved = scene.clone();
    for speed in moved.start.q_dot.iter_mut().flatten().chain(&mut moved.start.motions) {
        *speed *= 1.0 + MOVED * f64::EPSILON;
    }
    for parameter in &mut moved.parameters {
        *parameter *= 1.0 + MOVED * f64::EPSILON;
    }
    let away = complete(run(&moved))?;
    let Errors { path, end, .. } = error::of(&away, &outcome, 0.0);
    let carried = path.max(end) / MOVED * (outcome.counts.events() as f64).sqrt().max(1.0);
    Ok(Reference { by: By::Plain, outcome, error: carried.max(f64::EPSILON) })
}

/// The run by the explicit method of high order. Its error is how far an implicit one, with which it has no formula in
/// common, comes out from it.
fn by_steps(scene: &Scene, why: String, run: Runner<'_>) -> Result<Reference, String> {
    let by = |method| {
        let mut scene = scene.clone();
        scene.solver = Solver { method: Some(method), tolerance: TIGHTEST, ..Solver::default() };
        complete(run(&scene))
    };
    let (outcome, other) = (by(Method::Dop853)?, by(Method::Radau)?);
    let Errors { path, end, events, .. } = error::of(&other, &outcome, 0.0);
    if events != 0 {
        return Err(format!("dop853 and radau find different numbers of events at a tolerance of {TIGHTEST:e}"));
    }
    Ok(Reference { by: By::Steps(why), outcome, error: path.max(end).max(RECORDED * f64::EPSILON) })
}

fn complete(outcome: Result<Outcome, Refusal>) -> Result<Outcome, String> {
    let outcome = outcome.map_err(|refusal| refusal.to_string())?;
    outcome.stopped_by.as_ref().map_or(Ok(()), |stop| Err(stop.to_string()))?;
    Ok(outcome)
}

/// The scene, recorded as errors need it.
pub fn recorded(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    scene.output.rate = SAMPLES / scene.t_end;
    scene.output.events = true;
    scene
}
