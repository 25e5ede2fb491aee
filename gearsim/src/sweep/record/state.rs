//! The state at the end of the run: every coordinate, unwrapped, and its speed.

use super::{Column, Ended, Group, column, last};
use crate::model::Model;

pub(super) const GROUP: Group = Group {
    name: "state",
    doc: "every coordinate and speed at the end: phi, phi_dot",
    samples: false,
    limits: false,
    digits: false,
    outputs: false,
    columns,
    values,
};

fn columns(model: &Model, _: &[usize]) -> Vec<Column> {
    let both = |name: &str, unit: &str| [column(name, unit), column(format!("{name}_dot"), format!("{unit}/s"))];
    model.coordinates.iter().flat_map(|c| both(c.name, c.unit)).collect()
}

fn values(ended: &Ended<'_>) -> Vec<f64> {
    let outcome = ended.outcome;
    let run = &outcome.trajectory;
    run.q.iter().zip(&run.q_dot).flat_map(|(q, v)| [last(q), last(v)]).collect()
}
