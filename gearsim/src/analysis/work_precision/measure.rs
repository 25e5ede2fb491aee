//! Measures the processor time and the errors of one setting.

use std::time::{Duration, Instant};

use super::error::{self, Errors};
use super::ladder::{Family, Kind, Rung};
use super::{Reference, Runner};

/// A family, measured.
#[derive(Debug, Clone)]
pub struct MeasuredFamily {
    /// Its name.
    pub label: &'static str,
    /// The origin of its error.
    pub kind: Kind,
    /// Its settings, from coarse to fine.
    pub points: Vec<MeasuredSetting>,
}

/// One setting, measured.
#[derive(Debug, Clone)]
pub struct MeasuredSetting {
    /// The setting as text.
    pub setting: String,
    /// Processor time of a run without recording, minimum and median of several \[s\].
    pub seconds: (f64, f64),
    /// Number of evaluations of the right-hand side, or of the motion.
    pub evaluations: u64,
    /// Number of time steps, including rejected ones.
    pub steps: u64,
    /// Number of events.
    pub events: u64,
    /// Its errors; or why it failed.
    pub errors: Result<Errors, String>,
    /// Whether it has as many events as the reference; always true for ramps and for other equations.
    pub right_events: bool,
    /// Whether it was run.
    pub tried: bool,
}

/// After this time a point is not timed again; it is timed at least once.
const PATIENCE: Duration = Duration::from_secs(2);
/// If a setting takes longer than this, finer ones are not run.
const MOST: Duration = Duration::from_secs(5);

impl MeasuredSetting {
    /// Whether it stopped early, or has other events than the reference.
    pub fn failed(&self) -> bool {
        self.tried && (self.errors.is_err() || !self.right_events)
    }

    /// Its error along the path; `None` if it did not run to its end.
    pub fn error(&self) -> Option<f64> {
        self.errors.as_ref().ok().map(|errors| errors.path).filter(|error| error.is_finite())
    }
}

/// The point of a rung that is not run, because a coarser one took `seconds` \[s\].
pub fn not_tried(rung: &Rung, seconds: f64) -> MeasuredSetting {
    MeasuredSetting { tried: false, ..failed(rung, format!("not tried: a coarser setting took {seconds:.0} s")) }
}

/// Whether a point took so long that finer settings are not run.
pub fn is_slow(point: &MeasuredSetting) -> bool {
    point.seconds.0 > MOST.as_secs_f64()
}

fn failed(rung: &Rung, why: String) -> MeasuredSetting {
    MeasuredSetting {
        setting: rung.setting.clone(),
        seconds: (f64::NAN, f64::NAN),
        evaluations: 0,
        steps: 0,
        events: 0,
        errors: Err(why),
        right_events: false,
        tried: true,
    }
}

/// Measures a rung: one run with everything recorded for the errors, then up to `repetitions` runs without recording for the time.
pub fn point(
    family: &Family,
    rung: &Rung,
    reference: &Reference,
    run: Runner<'_>,
    repetitions: usize,
) -> MeasuredSetting {
    let outcome = match run(&rung.scene) {
        Ok(outcome) => outcome,
        Err(refusal) => return failed(rung, refusal.to_string()),
    };
    let counts = &outcome.counts;
    let errors = match &outcome.stopped_by {
        Some(stop) => Err(stop.to_string()),
        None => Ok(error::of(&outcome, &reference.outcome, rung.blur)),
    };
    let right = errors.as_ref().is_ok_and(|errors| errors.events == 0);
    let mut quiet = rung.scene.clone();
    (quiet.output.events, quiet.output.rate) = (false, 1.0 / quiet.t_end);
    quiet.output.record.clear();
    let begin = Instant::now();
    let mut seconds = vec![];
    while seconds.len() < repetitions.max(1) && (seconds.is_empty() || begin.elapsed() < PATIENCE) {
        match run(&quiet) {
            Ok(outcome) => seconds.push(outcome.cpu_seconds),
            Err(refusal) => return failed(rung, refusal.to_string()),
        }
    }
    seconds.sort_by(f64::total_cmp);
    MeasuredSetting {
        setting: rung.setting.clone(),
        seconds: (seconds[0], seconds[seconds.len() / 2]),
        evaluations: counts.cost.evaluations,
        steps: outcome.solver.steps + outcome.solver.rejected,
        events: counts.events(),
        errors,
        // Ramps have no events, and other equations have other events.
        right_events: right || rung.blur > 0.0 || family.kind == Kind::Equations,
        tried: true,
    }
}
