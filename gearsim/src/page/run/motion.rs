//! The motion: speeds, signals and deflections against time, a plot for each unit.

use super::Report;
use super::columns::{ColumnGroup, ColumnKind};
use super::view::Source;
use crate::page::data::{Column, Counts};
use crate::page::html::Html;
use crate::page::plot::{Axis, PageCurve, Plot};
use crate::trajectory::Moment;

/// The group of the plots over time, and of the gears.
pub(super) const GROUP: &str = "time";

/// Times in the page, embedded once for all plots.
pub(super) struct Times {
    /// Those of the rows [s].
    pub(super) rows: Column,
    /// Those of the events [s]; `None` without events.
    events: Option<Column>,
}

/// Writes the section.
pub(super) fn fill(report: &Report<'_>, html: &mut Html) {
    let trajectory = &report.run.outcome.trajectory;
    if trajectory.is_empty() {
        return html.note("The run recorded no rows.");
    }
    if report.all.rows.every > 1 {
        html.note(&format!(
            "This page has the extremes over every {} of the {} recorded rows. All rows are in trajectory.parquet.",
            report.all.rows.every,
            trajectory.len()
        ));
    }
    for group in report.groups.iter().filter(|group| group.kind != ColumnKind::Energy) {
        let shown = |i: usize| group.shown(i);
        plot(report, html, group.title(), group, &shown);
    }
}

/// Adds a plot of the columns of `group` over time; `shown` says which of them are drawn at first.
pub(super) fn plot(
    report: &Report<'_>,
    html: &mut Html,
    title: &str,
    group: &ColumnGroup<'_>,
    shown: &dyn Fn(usize) -> bool,
) {
    let outcome = report.run.outcome;
    let source = report.plotted();
    let times = times(report, source, html);
    let curves = group.columns.iter().enumerate().map(|(i, column)| {
        let values = if source.has(title, &column.name) { source.rows.values(&column.values) } else { vec![] };
        let y = html.embed(&values, Counts::Short);
        PageCurve::new(&*column.name, &column.doc, times.rows.clone(), y, shown(i))
    });
    let curves = curves.collect();
    // Speeds of rotors are read in revolutions a minute.
    let usual = (group.kind == ColumnKind::Signal && group.unit == "rad/s").then_some("rpm");
    html.plot(&Plot {
        title: title.to_owned(),
        x: Axis::linear("time t", "s"),
        y: Axis { usual, ..Axis::linear("", &*group.unit) },
        curves,
        group: Some(GROUP.into()),
        events: times.events.clone(),
        lines: vec![],
        shaded_from: outcome.digits.and_then(|digits| digits.none_from),
        square: false,
    });
}

/// The times of a source, embedded when a plot first needs them.
pub(super) fn times<'a>(report: &Report<'_>, source: &'a Source<'_>, html: &mut Html) -> &'a Times {
    source.times.get_or_init(|| {
        let events = events(report);
        let rows = html.embed(&source.rows.times(&report.run.outcome.trajectory.t), Counts::Long);
        Times { rows, events: (!events.is_empty()).then(|| html.embed(&events, Counts::Long)) }
    })
}

/// The times of the events [s].
fn events(report: &Report<'_>) -> Vec<f64> {
    let trajectory = &report.run.outcome.trajectory;
    let before = trajectory.moment.iter().zip(&trajectory.t).filter(|(moment, _)| **moment == Moment::Before);
    before.map(|(_, t)| *t).collect()
}
