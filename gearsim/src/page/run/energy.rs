//! The energy account: its parts against time, and their values at the start and at the end.

use super::Report;
use super::columns::{ColumnGroup, ColumnKind};
use super::{losses, motion};
use crate::output::number::short;
use crate::page::html::{Html, TableCell};

/// The parts whose changes are drawn at first.
const SHOWN: [&str; 5] = ["energy", "kinetic", "strain", "work", "dissipated"];

/// Writes the section.
pub(super) fn fill(report: &Report<'_>, html: &mut Html) {
    let Some(all) = report.groups.iter().find(|group| group.kind == ColumnKind::Energy) else { return };
    if report.run.outcome.trajectory.is_empty() {
        return;
    }
    let energy = &report.run.summary.energy;
    let (residual, largest) = (energy.residual.0, energy.largest.0);
    let of_largest = if largest > 0.0 {
        format!(", {} of the largest part", short((residual / largest).abs()))
    } else {
        String::new()
    };
    html.paragraph(&format!(
        "At the end {} J are unaccounted for{of_largest}. Lost: {} J.",
        short(residual),
        short(energy.dissipated.0)
    ));
    if let Some(refuted) = &report.run.summary.refuted {
        html.note(&format!("The account does not close, so the result is wrong: {refuted}"));
    }
    table(all, html);
    losses::table(report, html);
    let ColumnGroup { kind, unit, columns } = all;
    let (residual, mut parts): (Vec<_>, Vec<_>) = columns.iter().cloned().partition(|c| c.name == "residual");
    for part in &mut parts {
        let start = part.values.first().copied().unwrap_or(0.0);
        part.values = part.values.iter().map(|x| x - start).collect();
    }
    parts.sort_by_key(|part| SHOWN.iter().position(|name| *name == part.name).unwrap_or(SHOWN.len()));
    let shown: Vec<bool> = parts.iter().map(|part| SHOWN.contains(&&*part.name)).collect();
    let group = |columns| ColumnGroup { kind: *kind, unit: unit.clone(), columns };
    motion::plot(report, html, "Changes since the start", &group(parts), &|i| shown[i]);
    motion::plot(report, html, "Residual of the account", &group(residual), &|_| true);
}

/// The table of the account.
fn table(all: &ColumnGroup<'_>, html: &mut Html) {
    let rows = all.columns.iter().filter_map(|column| {
        let (start, end) = (*column.values.first()?, *column.values.last()?);
        let numbers = [start, end, end - start].map(TableCell::Number);
        Some(
            [TableCell::text(&*column.name)].into_iter().chain(numbers).chain([TableCell::text(&column.doc)]).collect(),
        )
    });
    html.table(
        "Energy account",
        &["part", "start [J]", "end [J]", "change [J]", "what it is"],
        &rows.collect::<Vec<_>>(),
    );
}
