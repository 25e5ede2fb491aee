//! Statistics of the recorded outputs in `summary.json`.

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use super::Number;
use crate::analysis::statistics::Statistics;
use crate::model::Output;
use crate::trajectory::Trajectory;

/// Statistics of a recorded output, from `output.from` to the end of the run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Observed {
    /// SI unit of the numbers.
    pub unit: String,
    /// Least value, over samples and both sides of events.
    pub min: Number,
    /// Greatest value, likewise.
    pub max: Number,
    /// Mean over the time.
    pub mean: Number,
    /// Root mean square about the mean, over the time.
    pub rms: Number,
    /// The value that 1 % of the samples do not exceed.
    pub p01: Number,
    /// The value that 99 % of the samples do not exceed.
    pub p99: Number,
}

impl Observed {
    /// The statistics of the recorded outputs of a run from the time `from` \[s\] on, by name. Empty if the run has no samples there.
    pub fn all(run: &Trajectory, from: f64) -> IndexMap<String, Self> {
        let begin = run.row_from(from);
        let statistics = |(output, column): &(&Output, Vec<f64>)| {
            let [min, max, mean, rms, p01, p99] =
                Statistics::of(&run.t[begin..], &column[begin..], &run.moment[begin..])?.values().map(Number);
            Some((output.name.into(), Observed { unit: output.unit.into(), min, max, mean, rms, p01, p99 }))
        };
        run.outputs.iter().filter_map(statistics).collect()
    }

    /// All its numbers, with their names.
    pub(super) fn numbers(&self) -> [(&'static str, Number); 6] {
        let Observed { min, max, mean, rms, p01, p99, .. } = self;
        [("min", *min), ("max", *max), ("mean", *mean), ("rms", *rms), ("p01", *p01), ("p99", *p99)]
    }
}
