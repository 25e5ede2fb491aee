//! The number of digits left of the end state. A second run of the point, the companion, starts a few roundings away.

use super::{Column, Group, column};
use crate::model::Model;
use crate::run::Outcome;

pub(super) const GROUP: Group = Group {
    name: "digits",
    doc: "digits left of the end state, 0 in chaos; runs each point twice",
    samples: false,
    limits: false,
    digits: true,
    outputs: false,
    columns,
    values,
};

fn columns(_: &Model) -> Vec<Column> {
    vec![column("digits", "1")]
}

fn values(outcome: &Outcome, _: f64) -> Vec<f64> {
    vec![outcome.digits.map_or(f64::NAN, |digits| digits.at_end)]
}
