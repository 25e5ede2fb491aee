//! The number of digits left of the end state. The start of a second run of the point, the companion, differs by rounding
//! errors.

use super::{Column, Ended, Group, column};
use crate::model::Model;

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

fn columns(_: &Model, _: &[usize]) -> Vec<Column> {
    vec![column("digits", "1")]
}

fn values(ended: &Ended<'_>) -> Vec<f64> {
    let outcome = ended.outcome;
    vec![outcome.digits.map_or(f64::NAN, |digits| digits.at_end)]
}
