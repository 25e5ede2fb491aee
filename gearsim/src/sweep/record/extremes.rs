//! Range of coordinates and speeds: minimum and maximum over samples and both sides of events; mean, and root mean square about the
//! mean, over the time. For coordinates that rotate continuously, only the speeds are recorded.

use super::{Column, Ended, Group, column, row_from, with_rotation};
use crate::analysis::statistics::Statistics;
use crate::model::Model;

pub(super) const GROUP: Group = Group {
    name: "extremes",
    doc: "of every coordinate and speed after --from: phi_min, phi_max, phi_mean, phi_rms",
    samples: true,
    limits: true,
    digits: false,
    outputs: false,
    columns,
    values,
};

fn columns(model: &Model, _: &[usize]) -> Vec<Column> {
    let four = |name: String, unit: String| {
        ["min", "max", "mean", "rms"].map(|what| column(format!("{name}_{what}"), unit.clone()))
    };
    let mut columns = vec![];
    for (c, rotates) in with_rotation(model) {
        if !rotates {
            columns.extend(four(c.name.to_owned(), c.unit.to_owned()));
        }
        columns.extend(four(format!("{}_dot", c.name), format!("{}/s", c.unit)));
    }
    columns
}

fn values(ended: &Ended<'_>) -> Vec<f64> {
    let (outcome, from) = (ended.outcome, ended.from);
    let run = &outcome.trajectory;
    let begin = row_from(run, from);
    let (t, moments) = (&run.t[begin..], &run.moment[begin..]);
    let four =
        |x: &[f64]| Statistics::of(t, &x[begin..], moments).map_or([f64::NAN; 4], |s| [s.min, s.max, s.mean, s.rms]);
    let mut values = vec![];
    for ((_, rotates), (q, v)) in with_rotation(run.model).zip(run.q.iter().zip(&run.q_dot)) {
        if !rotates {
            values.extend(four(q));
        }
        values.extend(four(v));
    }
    values
}
