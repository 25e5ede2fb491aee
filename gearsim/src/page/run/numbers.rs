//! Extremes, mean and rms of every column.

use super::Report;
use super::columns::Named;
use crate::page::html::{Cell, Html};

/// Writes the section.
pub(super) fn fill(report: &Report<'_>, html: &mut Html) {
    let t = &report.run.outcome.trajectory.t;
    let row = |unit: &str, column: &Named<'_>| {
        let finite = || column.values.iter().copied().filter(|x| x.is_finite());
        let (low, high) = (finite().fold(f64::INFINITY, f64::min), finite().fold(f64::NEG_INFINITY, f64::max));
        let (mean, rms) = means(t, &column.values);
        let numbers = [low, high, mean, rms, column.values.last().copied().unwrap_or(f64::NAN)].map(Cell::Number);
        [Cell::text(column.name), Cell::text(unit)].into_iter().chain(numbers).collect::<Vec<_>>()
    };
    let rows = report.groups.iter().flat_map(|group| group.columns.iter().map(|column| row(group.unit, column)));
    let rows: Vec<_> = rows.collect();
    if !t.is_empty() {
        html.paragraph("Over the recorded rows. Mean, and rms about the mean, weigh each interval by its length.");
        html.table("All columns", &["column", "unit", "lowest", "highest", "mean", "rms", "end"], &rows);
    }
}

/// Mean over time of `x`, and its root mean square about the mean, by the trapezoidal rule; NaN without an interval.
fn means(t: &[f64], x: &[f64]) -> (f64, f64) {
    let integral = |f: &dyn Fn(f64) -> f64| {
        let parts = t.windows(2).zip(x.windows(2)).map(|(t, x)| 0.5 * (t[1] - t[0]) * (f(x[0]) + f(x[1])));
        parts.sum::<f64>() / (t.last().unwrap_or(&f64::NAN) - t.first().unwrap_or(&f64::NAN))
    };
    let mean = integral(&|x| x);
    (mean, integral(&|x| (x - mean) * (x - mean)).sqrt())
}

#[test]
fn the_mean_weighs_intervals_by_their_length() {
    // A step from 0 to 4 after a quarter of the time.
    let (mean, rms) = means(&[0.0, 1.0, 1.0, 4.0], &[0.0, 0.0, 4.0, 4.0]);
    assert_eq!((mean, rms), (3.0, 3f64.sqrt()));
}
