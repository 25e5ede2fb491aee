//! The visible part of the plots over time, orders and frequencies. `gearsim explore` first sends only this part.

use std::cell::OnceCell;

use serde::Deserialize;

use super::motion::Times;
use crate::page::shared::rows::Rows;

/// The curves that are on the screen, and the part of the run that those over time show.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct View {
    /// The times between which the plots are seen \[s\]; `None`: the whole run.
    range: Option<(f64, f64)>,
    /// The number of parts of this range in each of which a curve has its lowest and its highest value: the width of a plot in pixels.
    parts: usize,
    /// The curves that are drawn: title of the plot and name.
    curves: Vec<(String, String)>,
    /// The captions of the tables that are on the screen.
    #[serde(default)]
    tables: Vec<String>,
}

/// The curves that get values, and the rows of those over time.
pub(super) struct Source<'a> {
    /// `None`: all curves have rows.
    pub(super) view: Option<&'a View>,
    pub(super) rows: Rows,
    /// The times of the rows and of the events, once a plot has them.
    pub(super) times: OnceCell<Times>,
}

impl<'a> Source<'a> {
    /// All curves, with these rows.
    pub(super) fn of(rows: Rows) -> Self {
        Source { view: None, rows, times: OnceCell::new() }
    }

    /// The part of a run with the times `t` that is in `view`.
    pub(super) fn seen(view: &'a View, t: &[f64]) -> Self {
        let (from, to) = view.range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        // One row beyond each end, so that the curves reach the frame.
        let begin = t.partition_point(|t| *t < from).saturating_sub(1);
        let end = (t.partition_point(|t| *t <= to) + 1).min(t.len());
        let rows = Rows::within(begin..end.max(begin), view.parts);
        Source { view: Some(view), rows, times: OnceCell::new() }
    }

    /// Whether a curve is wanted.
    pub(super) fn has(&self, title: &str, name: &str) -> bool {
        self.view.is_none_or(|view| view.curves.iter().any(|(plot, curve)| plot == title && curve == name))
    }

    /// Whether a table is wanted.
    pub(super) fn has_table(&self, caption: &str) -> bool {
        self.view.is_none_or(|view| view.tables.iter().any(|table| table == caption))
    }
}
