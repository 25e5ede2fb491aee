//! Parts of `summary.json`: rows, meshes, load spectra, sounds.

use serde::{Deserialize, Serialize};

use super::Number;
use crate::analysis::dynamic_factor::DynamicFactor;
use crate::analysis::from_teeth::FromTeeth;
use crate::analysis::pulling::Pulling;
use crate::profile::Step;
use crate::trajectory::Trajectory;

/// Rows of the trajectory by their kind. The rows with `moment == "sample"` are the evenly spaced samples. At an event there are two more
/// rows of the same time.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rows {
    /// Samples at the recording rate, with the start and the end.
    pub samples: u64,
    /// Left and right limits at events.
    pub at_events: u64,
}

impl Rows {
    /// The rows of a run.
    pub fn of(run: &Trajectory) -> Self {
        let samples = run.samples().count();
        Rows { samples: samples as u64, at_events: (run.len() - samples) as u64 }
    }
}

/// A mesh stiffness that the scene gives by its teeth.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LawFromTeeth {
    /// Transverse contact ratio \[1\].
    pub contact_ratio: Number,
    /// Overlap ratio, 0 of spur gears \[1\].
    pub overlap_ratio: Number,
    /// SI unit of the values.
    pub unit: String,
    /// SI unit of the widths.
    pub phase_unit: String,
    /// Mean over the period.
    pub mean: Number,
    /// Smallest value.
    pub min: Number,
    /// Largest value.
    pub max: Number,
    /// The cells of one period. The value of a cell in which the law is curved is its mean there.
    pub levels: Vec<Level>,
}

/// A cell of a law.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Level {
    /// Value [unit of the law].
    pub value: Number,
    /// Width [unit of the phase].
    pub width: Number,
}

impl LawFromTeeth {
    /// The summary of a law that is computed from teeth.
    pub fn of(of: &FromTeeth<'_>) -> Self {
        let (min, max) = of.profile.extremes();
        let level = |step: &Step| Level { value: Number(step.value), width: Number(step.width) };
        LawFromTeeth {
            contact_ratio: Number(of.contact_ratio),
            overlap_ratio: Number(of.overlap_ratio),
            unit: of.law.unit.into(),
            phase_unit: of.phase_unit.into(),
            mean: Number(of.profile.mean()),
            min: Number(min),
            max: Number(max),
            levels: of.profile.steps.iter().map(level).collect(),
        }
    }
}

/// The load of a mesh in a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mesh {
    /// The output that is its force, or its torque.
    pub force: String,
    /// SI unit of the forces.
    pub unit: String,
    /// Largest magnitude.
    pub largest: Number,
    /// Magnitude in static equilibrium at the torques of the start.
    pub at_rest: Number,
    /// Largest over static \[1\].
    pub dynamic_factor: Number,
    /// K_v of ISO 6336-1, method B \[1\].
    pub kv_iso6336: Number,
    /// Mean over the time.
    pub mean: Number,
    /// Share of the time in which the teeth pull: the force has the sign opposite to its mean, and the mesh has no play \[1\].
    pub pulling_share: Number,
    /// Largest magnitude of the pulling force.
    pub largest_pull: Number,
}

impl Mesh {
    /// The load of the mesh of a dynamic factor. Also returns the reason for each value that does not exist, with the name of the value.
    pub fn of(of: &DynamicFactor) -> (Self, Vec<(&'static str, String)>) {
        let mut reasons = vec![];
        let mut number = |name: &'static str, value: &Result<f64, String>| match value {
            Ok(value) => Number(*value),
            Err(why) => {
                reasons.push((name, why.clone()));
                Number(f64::NAN)
            }
        };
        let at_rest = number("at_rest", &of.at_rest);
        let dynamic_factor = number("dynamic_factor", &of.factor);
        let kv_iso6336 = number("kv_iso6336", &of.iso6336);
        let (force, unit) = (of.force.name.into(), of.force.unit.into());
        let pulling = |value: fn(&Pulling) -> f64| Number(of.pulling.as_ref().map_or(f64::NAN, value));
        let mesh = Mesh {
            force,
            unit,
            largest: Number(of.largest),
            at_rest,
            dynamic_factor,
            kv_iso6336,
            mean: pulling(|pulling| pulling.mean),
            pulling_share: pulling(|pulling| pulling.share),
            largest_pull: pulling(|pulling| pulling.largest),
        };
        (mesh, reasons)
    }

    /// All its numbers, with their names.
    pub(super) fn numbers(&self) -> [(&'static str, Number); 7] {
        let Mesh { largest, at_rest, dynamic_factor, kv_iso6336, mean, pulling_share, largest_pull, .. } = *self;
        [
            ("largest", largest),
            ("at_rest", at_rest),
            ("dynamic_factor", dynamic_factor),
            ("kv_iso6336", kv_iso6336),
            ("mean", mean),
            ("pulling_share", pulling_share),
            ("largest_pull", largest_pull),
        ]
    }
}

/// The load spectrum of a signal.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LoadSpectrum {
    /// SI unit of the ranges.
    pub unit: String,
    /// Cycles; half cycles count 0.5.
    pub cycles: Number,
    /// The largest range.
    pub largest_range: Number,
}

/// A signal as sound.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sound {
    /// The file.
    pub file: String,
    /// Playing time over model time.
    pub stretch: Number,
    /// SI unit of the signal.
    pub unit: String,
    /// The value of the signal, without its mean, that is full scale. Loudness is relative to it.
    pub full_scale: Number,
    /// The mean that was subtracted.
    pub mean: Number,
}
