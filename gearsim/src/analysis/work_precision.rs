//! What accuracy costs: methods and approximations, from coarse to fine, on one scene, each measured against a reference.
//!
//! `reference` (the motion to compare with, and how far it is to be trusted), `ladder` (what is run), `error` (how far off
//! a run is, apart: at the end, along the path, in the times and number of events, in energy), `measure` (what it costs),
//! `table` (time at equal error, and in words).

pub mod error;
pub mod ladder;
pub mod measure;
pub mod reference;
pub mod table;

pub use error::Errors;
pub use ladder::{Family, Rung, Scenes};
pub use measure::{Curve, Point};
pub use reference::{By, Reference};

use crate::engine::Refusal;
use crate::run::Outcome;
use crate::scene::Scene;

/// Runs a scene, as [`Entry::run`](crate::run::Entry::run) does.
pub type Runner<'a> = &'a dyn Fn(&Scene) -> Result<Outcome, Refusal>;

/// A scene measured.
#[derive(Debug, Clone)]
pub struct WorkPrecision {
    /// The scene.
    pub scene: String,
    /// Events in the reference.
    pub events: u64,
    /// How the reference was found.
    pub reference: By,
    /// Its own error, as it is estimated: errors are not told from it.
    pub floor: f64,
    /// One curve a method or approximation.
    pub curves: Vec<Curve>,
}

/// Measures a scene, and the cheaper equations among `scenes`; `repetitions` runs a point at most, and `say` is told what runs.
///
/// # Errors
/// Where the reference cannot be computed, in words.
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
        let mut points: Vec<Point> = vec![];
        for rung in &family.rungs {
            let slow = points.iter().find(|point| measure::is_slow(point));
            points.push(match slow {
                Some(slow) => measure::not_tried(rung, slow.seconds.0),
                None => measure::point(&family, rung, &reference, run, repetitions),
            });
        }
        curves.push(Curve { label: family.label, kind: family.kind, points });
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
