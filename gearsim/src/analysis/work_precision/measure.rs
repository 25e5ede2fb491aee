//! What one run costs, and how far off it is.

use std::time::{Duration, Instant};

use super::error::{self, Errors};
use super::ladder::{Family, Kind, Rung};
use super::{Reference, Runner};

/// A family, measured.
#[derive(Debug, Clone)]
pub struct Curve {
    /// Its name.
    pub label: &'static str,
    /// What its error comes from.
    pub kind: Kind,
    /// Its settings, from coarse to fine.
    pub points: Vec<Point>,
}

/// One setting, measured.
#[derive(Debug, Clone)]
pub struct Point {
    /// Which.
    pub setting: String,
    /// Processor time of a run without recording, the least and the median of several \[s\].
    pub seconds: (f64, f64),
    /// Evaluations of the right-hand side, or of the motion.
    pub evaluations: u64,
    /// Steps of a method, in vain ones included.
    pub steps: u64,
    /// Events.
    pub events: u64,
    /// How far off it is; where it failed, why.
    pub errors: Result<Errors, String>,
    /// Whether it has the events of the reference, as far as it has events.
    pub right_events: bool,
    /// Whether it was run at all.
    pub tried: bool,
}

/// No point is measured for longer than this, once it has been measured.
const PATIENCE: Duration = Duration::from_secs(2);
/// Settings finer than one that takes this long are not tried.
const MOST: Duration = Duration::from_secs(5);

impl Point {
    /// Whether it stopped early, or has other events than the reference.
    pub fn failed(&self) -> bool {
        self.tried && (self.errors.is_err() || !self.right_events)
    }

    /// Its error along the path, where it ran to its end.
    pub fn error(&self) -> Option<f64> {
        self.errors.as_ref().ok().map(|errors| errors.path).filter(|error| error.is_finite())
    }
}

/// The point of a rung that is not run, since one before it took so long \[s\].
pub fn not_tried(rung: &Rung, seconds: f64) -> Point {
    Point { tried: false, ..failed(rung, format!("not tried: a coarser setting took {seconds:.0} s")) }
}

/// Whether the next rung, which is finer, would take too long.
pub fn is_slow(point: &Point) -> bool {
    point.seconds.0 > MOST.as_secs_f64()
}

fn failed(rung: &Rung, why: String) -> Point {
    Point {
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

/// Measures a rung: once with everything recorded, then `repetitions` times with nothing.
pub fn point(family: &Family, rung: &Rung, reference: &Reference, run: Runner<'_>, repetitions: usize) -> Point {
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
    let begin = Instant::now();
    let mut seconds = vec![];
    while seconds.len() < repetitions.max(1) && (seconds.is_empty() || begin.elapsed() < PATIENCE) {
        match run(&quiet) {
            Ok(outcome) => seconds.push(outcome.cpu_seconds),
            Err(refusal) => return failed(rung, refusal.to_string()),
        }
    }
    seconds.sort_by(f64::total_cmp);
    Point {
        setting: rung.setting.clone(),
        seconds: (seconds[0], seconds[seconds.len() / 2]),
        evaluations: counts.cost.evaluations,
        steps: outcome.solver.steps + outcome.solver.rejected,
        events: counts.events(),
        errors,
        // A ramp has no events, and other equations have their own.
        right_events: right || rung.blur > 0.0 || family.kind == Kind::Equations,
        tried: true,
    }
}
