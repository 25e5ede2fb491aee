//! The result of a run, and what [`Entry::check`](super::Entry::check) states without a run.

use super::{Account, Counts, Stop};
use crate::trajectory::Trajectory;

/// The result of a run.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The recorded rows. The last one is the state at the end, or where the run had to stop.
    pub trajectory: Trajectory,
    /// T + V at the start \[J\].
    pub energy_at_start: f64,
    /// Energy of neglected bounces \[J\]. It is part of the residual.
    pub ignored: f64,
    /// Events and costs.
    pub counts: Counts,
    /// For each switch of the scene, by its name: the time spent in each of its modes \[s\].
    pub modes: Vec<(&'static str, Vec<(&'static str, f64)>)>,
    /// Number of impacts of each kind. The kinds are those that the modes of the scene's switches count, e.g. "flanks met".
    pub impacts: Vec<(&'static str, u64)>,
    /// How it was solved.
    pub solver: Solver,
    /// Why the run ended before its time, if it did.
    pub stopped_by: Option<Stop>,
    /// Damped angular frequency of the lowest elastic mode at the mid stiffness [rad/s].
    pub reference_frequency: Option<f64>,
    /// Processor time of the simulation, including recording \[s\].
    pub cpu_seconds: f64,
    /// The energy account, if it refutes the result.
    pub refuted: Option<Account>,
    /// The number of correct digits of the result, if it was estimated.
    pub digits: Option<Digits>,
    /// Remarks for the reader of the result, a sentence each.
    pub remarks: Vec<String>,
}

/// The number of correct digits of a result.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Digits {
    /// Correct digits of the least accurate coordinate or speed at the end of the run, 0 to 16.
    pub at_end: f64,
    /// Time from which no digit is correct \[s\]; `None` if some are correct until the end.
    pub none_from: Option<f64>,
}

/// How a run was solved.
#[derive(Debug, Clone, PartialEq)]
pub struct Solver {
    /// The name of the method in scenes. If a method was replaced during the run, the name of its replacement.
    pub method: &'static str,
    /// The reason for this method.
    pub why: String,
    /// Steps of a numerical method; 0 for the exact one.
    pub steps: u64,
    /// Steps that were rejected.
    pub rejected: u64,
}

/// How a scene would be run.
#[derive(Debug, Clone, PartialEq)]
pub struct Prospect {
    /// The name of the method in scenes.
    pub method: &'static str,
    /// The reason for this method.
    pub why: String,
    /// Coordinates at the start \[SI\] (n).
    pub q: Vec<f64>,
    /// Speeds at the start \[SI\] (n).
    pub q_dot: Vec<f64>,
}
