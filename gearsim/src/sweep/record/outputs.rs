//! Statistics of every output of the model: forces, transmission errors, losses, speeds.

use super::{Column, Ended, Group, column, row_from};
use crate::analysis::statistics::Statistics;
use crate::model::Model;

pub(super) const GROUP: Group = Group {
    name: "outputs",
    doc: "of every output of the model after --from: its _min, _max, _mean, _rms, _p01, _p99",
    samples: true,
    limits: true,
    digits: false,
    outputs: true,
    columns,
    values,
};

fn columns(model: &Model) -> Vec<Column> {
    let each = |name: &'static str, unit: &'static str| {
        Statistics::NAMES.into_iter().map(move |what| column(format!("{name}_{what}"), unit))
    };
    model.outputs.iter().flat_map(|output| each(output.name, output.unit)).collect()
}

fn values(ended: &Ended<'_>) -> Vec<f64> {
    let (outcome, from) = (ended.outcome, ended.from);
    let run = &outcome.trajectory;
    let begin = row_from(run, from);
    let statistics = |name| Statistics::of(&run.t[begin..], &run.output(name)?[begin..], &run.moment[begin..]);
    run.model.outputs.iter().flat_map(|o| statistics(o.name).map_or([f64::NAN; 6], |s| s.values())).collect()
}
