//! Statistics of every column, with the definitions of the summary ([`crate::analysis::statistics`]).

use super::Report;
use super::columns::NamedColumn;
use crate::analysis::statistics::Statistics;
use crate::page::html::{Html, TableCell};

/// Writes the section.
pub(super) fn fill(report: &Report<'_>, html: &mut Html) {
    let run = &report.run.outcome.trajectory;
    let begin = run.row_from(report.run.scene.output.from);
    let row = |(unit, factor): (&str, f64), column: &NamedColumn<'_>| {
        let numbers = Statistics::of(&run.t[begin..], &column.values[begin..], &run.moment[begin..])?.values();
        let numbers = numbers.into_iter().chain(column.values.last().copied()).map(|x| TableCell::Number(factor * x));
        Some([TableCell::text(&*column.name), TableCell::text(unit)].into_iter().chain(numbers).collect::<Vec<_>>())
    };
    let rows = report.groups.iter().flat_map(|group| {
        let unit = group.shown_unit();
        group.columns.iter().filter_map(move |column| row(unit, column))
    });
    let rows: Vec<_> = rows.collect();
    if rows.is_empty() {
        return;
    }
    html.paragraph(
        "The lowest and highest values are over all recorded rows. Mean and rms about the mean are integrals over the time. The values that \
         1 % and 99 % do not exceed are over the samples, which are evenly spaced. The numbers of outputs are those of \
         summary.json, here in the units of the plots.",
    );
    let head = ["column", "unit", "lowest", "highest", "mean", "rms", "1 %", "99 %", "end"];
    html.table("All columns", &head, &rows);
}
