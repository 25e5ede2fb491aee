//! Error against processor time: methods and approximations on one scene, each with settings from coarse to fine, compared with a
//! reference.
//!
//! [`reference`] computes the reference motion and its own error. [`ladder`] lists the methods and settings to run. [`error`] defines
//! the errors of a run: at the end, along the path, in times and number of events, and in energy. [`measure`] times the runs.
//! [`table`] writes the time at equal error as a table and in words.

pub mod error;
pub mod ladder;
pub mod measure;
pub mod reference;
pub mod table;

pub use error::Errors;
pub use ladder::Scenes;
pub use measure::{MeasuredFamily, MeasuredSetting};
pub use reference::{By, Reference};

use crate::engine::Refusal;
use crate::run::Outcome;
use crate::scene::Scene;

/// Runs a scene, as [`Entry::run`](crate::run::Entry::run) does.
pub type Runner<'a> = &'a dyn Fn(&Scene) -> Result<Outcome, Refusal>;

/// The measurements of a scene.
#[derive(Debug, Clone)]
pub struct WorkPrecision {
    /// Name of the scene.
    pub scene: String,
    /// Number of events in the reference.
    pub events: u64,
    /// How the reference was computed.
    pub reference: By,
    /// Estimated error of the reference. Errors below this value are not resolved.
    pub floor: f64,
    /// One curve per method or approximation.
    pub curves: Vec<MeasuredFamily>,
}

/// Measures a scene, and the same scene under the cheaper equations of `scenes`. Each point is timed by at most `repetitions` runs. `say`
/// gets the name of what is being run.
///
/// # Errors
/// Why the reference cannot be computed, in words.
pub fn measure(
    scenes: &Scenes,
    run: Runner<'_>,
    repetitions: usize,
    say: &mut dyn FnMut(&str),
) -> Result<WorkPrecision, String> {
    say("reference");
    let reference = reference::of(&scenes.exact, run)?;
    let mut curves = vec![];
    for family in ladder::families(scenes, &reference) {
        say(family.label);
        let mut points: Vec<MeasuredSetting> = vec![];
        for rung in &family.rungs {
            let slow = points.iter().find(|point| measure::is_slow(point));
            points.push(match slow {
                Some(slow) => measure::not_tried(rung, slow.seconds.0),
                None => measure::point(&family, rung, &reference, run, repetitions),
            });
        }
        curves.push(MeasuredFamily { label: family.label, kind: family.kind, points });
    }
    Ok(WorkPrecision {
        scene: scenes.exact.name.clone(),
        events: reference.events(),
        reference: reference.by,
        floor: reference.error,
        curves,
    })
}

#[cfg(test)]
mod tests;
