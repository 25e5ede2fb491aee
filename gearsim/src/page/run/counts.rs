//! Events and steps, counted.

use super::Report;
use crate::output::summary::Number;
use crate::page::html::{Html, TableCell};

/// Writes the section.
pub(super) fn fill(report: &Report<'_>, html: &mut Html) {
    let summary = report.run.summary;
    let counts = &summary.counts;
    let impacts = summary.impacts.iter().map(|(kind, impacts)| (&**kind, *impacts, "after being apart"));
    let rows = [
        ("cell changes", summary.cell_changes, "steps of a law that the motion passed"),
        ("reflections", summary.reflections, "steps that the motion could not pass"),
        ("came to rest", counts.sticks, "held by friction or a clutch"),
        ("held at a step", counts.holds, "once the bounces were negligible"),
        ("grazes", counts.grazes, "boundaries touched and not passed, within rounding errors"),
        ("ambiguous", counts.ambiguous, "steps of two meshes at the same instant: the result depends on their order"),
        ("time steps", summary.method.steps, "of a numerical method"),
        ("rejected steps", summary.method.rejected, "tried again with a shorter step"),
        ("evaluations", counts.function_evaluations, "of the solution, or of the right-hand side"),
        ("steps of root finding", counts.root_steps, "to locate events"),
        ("recorded rows", report.run.outcome.trajectory.len() as u64, "samples, and both sides of events"),
    ];
    let row = |(name, count, what): (&str, u64, &str)| {
        vec![TableCell::text(name), TableCell::Number(count as f64), TableCell::text(what)]
    };
    let modes = summary.modes.iter().flat_map(|(switch, shares)| {
        let row = |(mode, share): (&String, &Number)| {
            vec![TableCell::text(switch), TableCell::text(mode), TableCell::Number(share.0)]
        };
        shares.0.iter().map(row).collect::<Vec<_>>()
    });
    html.table("Share of the time in each mode", &["switch", "mode", "share"], &modes.collect::<Vec<_>>());
    html.table("Events and steps", &["what", "count", "meaning"], &impacts.chain(rows).map(row).collect::<Vec<_>>());
}
