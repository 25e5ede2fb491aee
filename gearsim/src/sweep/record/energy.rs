//! The energy account at the end of the run; the same numbers as in `summary.json`.

use super::{Column, Ended, Group, column};
use crate::model::Model;
use crate::output::summary::Energy;

pub(super) const GROUP: Group = Group {
    name: "energy",
    doc: "kinetic, strain, work, dissipated, residual, energy_at_start, ignored",
    samples: false,
    limits: false,
    digits: false,
    outputs: false,
    columns,
    values,
};

fn columns(_: &Model, _: &[usize]) -> Vec<Column> {
    let names = ["kinetic", "strain", "work", "dissipated", "residual", "energy_at_start", "ignored"];
    names.map(|name| column(name, "J")).into()
}

fn values(ended: &Ended<'_>) -> Vec<f64> {
    let outcome = ended.outcome;
    let Some(e) = Energy::at_end(&outcome.trajectory) else { return vec![f64::NAN; 7] };
    let account = [e.kinetic, e.strain, e.work, e.dissipated, e.residual, e.at_start];
    account.iter().map(|x| x.0).chain([outcome.ignored]).collect()
}
