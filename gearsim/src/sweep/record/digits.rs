//! How many digits of the state at the end are left, by a second run of the point from a start a rounding away.

use super::{Column, Group, column};
use crate::model::Model;
use crate::run::Outcome;

pub(super) const GROUP: Group = Group {
    name: "digits",
    doc: "how many are left of the end state, 0 in chaos; a second run of each point",
    samples: false,
    limits: false,
    digits: true,
    columns,
    values,
};

fn columns(_: &Model) -> Vec<Column> {
    vec![column("digits", "1")]
}

fn values(outcome: &Outcome, _: f64) -> Vec<f64> {
    vec![outcome.digits.map_or(f64::NAN, |digits| digits.at_end)]
}
