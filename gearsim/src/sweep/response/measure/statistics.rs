//! Mean, root mean square about the mean, and peak-to-peak value of an output [its unit].

use super::Measure;
use crate::analysis::statistics::Statistics;
use crate::sweep::response::ResponsePoint;

pub(super) const MEAN: Measure = Measure { name: "mean", value: |point, i| of(point, i, |s| s.mean), ..RMS };
pub(super) const RMS: Measure = Measure {
    name: "rms",
    unit: None,
    beside: None,
    is_of: |_, _| true,
    value: |point, i| of(point, i, |s| s.rms),
    lacks: |_, _| None,
};
pub(super) const PEAK_TO_PEAK: Measure =
    Measure { name: "peak_to_peak", value: |point, i| of(point, i, |s| s.max - s.min), ..RMS };

fn of(point: &ResponsePoint, i: usize, value: fn(&Statistics) -> f64) -> f64 {
    point.observed[i].as_ref().map_or(f64::NAN, value)
}
