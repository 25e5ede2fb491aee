//! A point's results, and many of them as a table.
//!
//! Columns: `point`; the varied keys, in SI; `status` and `reason`; what was recorded. A number that there is not, as of
//! a point that was refused, is NaN.

use std::borrow::Cow;

use super::axis;
use super::plan::Plan;
use super::record::Column;
use super::spectra::Line;
use crate::output::{OutputError, Table, table::Values};
use crate::scene::unit_of;

/// What came of a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// It ran to its end.
    Done,
    /// It stopped before its end; what was recorded until then is there.
    Stopped,
    /// It ran to its end, and its energy account does not close: the numbers are wrong.
    Refuted,
    /// It made no system that can be simulated.
    Refused,
}

impl Status {
    const ALL: [Status; 4] = [Status::Done, Status::Stopped, Status::Refuted, Status::Refused];

    /// The word that stands for it in files.
    pub fn name(self) -> &'static str {
        match self {
            Status::Done => "done",
            Status::Stopped => "stopped",
            Status::Refuted => "refuted",
            Status::Refused => "refused",
        }
    }
}

/// The results of one point.
#[derive(Debug, Clone)]
pub struct Row {
    /// Number of the point.
    pub point: usize,
    /// What came of it.
    pub status: Status,
    /// Why it is not done; else empty.
    pub reason: String,
    /// The recorded quantities, in the order of their columns.
    pub numbers: Vec<f64>,
    /// Its spectra, if asked for.
    pub spectra: Vec<Line>,
}

/// `rows` as a table. Errors: [`OutputError::Ragged`] if a row has too few numbers.
pub fn table(plan: &Plan, columns: &[Column], units: &[String], rows: &[&Row]) -> Result<Table, OutputError> {
    let mut table = Table::default();
    table.push("point", "1", Values::Number(rows.iter().map(|row| row.point as f64).collect()))?;
    let mut values: Vec<Vec<String>> = plan.axes.iter().map(|_| Vec::with_capacity(rows.len())).collect();
    for row in rows {
        values.iter_mut().zip(plan.values(row.point)).for_each(|(column, value)| column.push(value));
    }
    for ((axis, unit), values) in plan.axes.iter().zip(units).zip(values) {
        match axis.is_numeric() {
            true => {
                table.push(&axis.key, unit, Values::Number(values.iter().map(|value| axis::si(value)).collect()))?
            }
            false => table.push(&axis.key, "", Values::Text(values.into_iter().map(Cow::Owned).collect()))?,
        }
    }
    let words = rows.iter().map(|row| Cow::Borrowed(row.status.name())).collect();
    table.push("status", "", Values::Text(words))?;
    table.push("reason", "", Values::Text(rows.iter().map(|row| Cow::Owned(row.reason.clone())).collect()))?;
    for (i, (name, unit)) in columns.iter().enumerate() {
        table.push(name, unit, Values::Number(rows.iter().filter_map(|row| row.numbers.get(i).copied()).collect()))?;
    }
    Ok(table)
}

/// SI units of the columns of the varied keys.
pub fn units(plan: &Plan, model: &crate::model::Model) -> Vec<String> {
    plan.axes.iter().map(|axis| unit_of(&axis.key, model).unwrap_or_default()).collect()
}

/// The rows of such a table, without spectra; `None` if it lacks a column.
pub fn read(table: &Table, columns: &[Column]) -> Option<Vec<Row>> {
    let points = table.numbers("point")?;
    let (status, reason) = (table.words("status")?, table.words("reason")?);
    let numbers: Vec<&[f64]> = columns.iter().map(|(name, _)| table.numbers(name)).collect::<Option<_>>()?;
    let row = |i: usize| {
        Some(Row {
            point: points[i] as usize,
            status: Status::ALL.into_iter().find(|s| s.name() == status[i])?,
            reason: reason[i].clone().into_owned(),
            numbers: numbers.iter().map(|column| column[i]).collect(),
            spectra: vec![],
        })
    };
    (0..table.rows()).map(row).collect()
}
