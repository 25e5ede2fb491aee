//! Statistics of the outputs that the points record: forces, transmission errors, losses, speeds.

use super::{Column, Ended, Group, column, row_from};
use crate::analysis::statistics::Statistics;
use crate::model::Model;

pub(super) const GROUP: Group = Group {
    name: "outputs",
    doc: "of every recorded output after --from: its _min, _max, _mean, _rms, _p01, _p99",
    samples: true,
    limits: true,
    digits: false,
    outputs: true,
    columns,
    values,
};

fn columns(model: &Model, outputs: &[usize]) -> Vec<Column> {
    let each = |name: &'static str, unit: &'static str| {
        Statistics::NAMES.into_iter().map(move |what| column(format!("{name}_{what}"), unit))
    };
    outputs.iter().map(|&i| &model.outputs[i]).flat_map(|output| each(output.name, output.unit)).collect()
}

fn values(ended: &Ended<'_>) -> Vec<f64> {
    let (outcome, from) = (ended.outcome, ended.from);
    let run = &outcome.trajectory;
    let begin = row_from(run, from);
    let statistics = |name| Statistics::of(&run.t[begin..], &run.output(name)?[begin..], &run.moment[begin..]);
    let outputs = ended.outputs.iter().map(|&i| &run.model.outputs[i]);
    outputs.flat_map(|o| statistics(o.name).map_or([f64::NAN; 6], |s| s.values())).collect()
}
