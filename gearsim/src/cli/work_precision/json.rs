//! The measurements of a scene as JSON.

use serde::Serialize;

use crate::analysis::work_precision::{By, MeasuredSetting, WorkPrecision};
use crate::output::{OutputError, document};

/// Version of the format.
const VERSION: u32 = 1;

#[derive(Serialize)]
struct Report<'a> {
    scene: &'a str,
    /// Number of events in the reference.
    events: u64,
    /// How the reference was computed.
    reference: &'static str,
    /// Estimated relative error of the reference.
    floor: f64,
    methods: Vec<Method<'a>>,
}

#[derive(Serialize)]
struct Method<'a> {
    name: &'a str,
    settings: Vec<Setting<'a>>,
}

/// One setting. Errors are relative, and `null` if the run did not reach its end.
#[derive(Serialize)]
struct Setting<'a> {
    setting: &'a str,
    /// Processor time of a run without recording, minimum and median of several [s].
    cpu_min: f64,
    cpu_median: f64,
    evaluations: u64,
    steps: u64,
    events: u64,
    error_end: Option<f64>,
    error_path: Option<f64>,
    energy_error: Option<f64>,
    /// Whether it has as many events as the reference.
    right_events: bool,
    /// Why it did not reach its end, or was not run.
    failure: Option<&'a str>,
}

/// The text of the JSON document.
///
/// # Errors
/// [`OutputError::Format`].
pub(super) fn json(measured: &WorkPrecision) -> Result<String, OutputError> {
    let methods = measured.curves.iter();
    let methods =
        methods.map(|curve| Method { name: curve.label, settings: curve.points.iter().map(setting).collect() });
    let reference = match &measured.reference {
        By::Compensated => "exact cells, compensated",
        By::Steps(_) => "methods by steps",
    };
    let report = Report {
        scene: &measured.scene,
        events: measured.events,
        reference,
        floor: measured.floor,
        methods: methods.collect(),
    };
    document::json("work-precision", VERSION, &report)
}

fn setting(point: &MeasuredSetting) -> Setting<'_> {
    let errors = point.errors.as_ref().ok();
    Setting {
        setting: &point.setting,
        cpu_min: point.seconds.0,
        cpu_median: point.seconds.1,
        evaluations: point.evaluations,
        steps: point.steps,
        events: point.events,
        error_end: errors.map(|errors| errors.end),
        error_path: errors.map(|errors| errors.path),
        energy_error: errors.map(|errors| errors.energy),
        right_events: point.right_events,
        failure: point.errors.as_ref().err().map(String::as_str),
    }
}
