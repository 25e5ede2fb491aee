//! The results of a point, and the table of many points.
//!
//! Columns: `point`; the varied keys, in SI units; `status`, `reason` and `remarks`; the recorded quantities. A number that does not exist, e.g.
//! of a refused point, is NaN.

use std::borrow::Cow;

use super::axis::{self, Axis};
use super::plan::Plan;
use super::record::Column;
use super::spectra::NamedSpectrum;
use crate::output::{OutputError, Table, remarks, table::Values};
use crate::scene::unit_of;

/// How the run of a point ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// It ran to its end.
    Done,
    /// It stopped before its end. The quantities recorded until then are given.
    Stopped,
    /// It ran to its end, but its energy account does not close: the numbers are wrong.
    Refuted,
    /// It ran to its end, but at another speed than that of the point. Only points of response curves have this status.
    Unheld,
    /// It did not run: its values do not make a system that can be simulated.
    Refused,
}

impl Status {
    /// The statuses that points of a sweep can have.
    pub const ALL: [Status; 4] = [Status::Done, Status::Stopped, Status::Refuted, Status::Refused];

    /// Its name in files.
    pub fn name(self) -> &'static str {
        match self {
            Status::Done => "done",
            Status::Stopped => "stopped",
            Status::Refuted => "refuted",
            Status::Unheld => "speed not held",
            Status::Refused => "refused",
        }
    }
}

/// The results of one point.
#[derive(Debug, Clone)]
pub struct Row {
    /// Number of the point.
    pub point: usize,
    /// How the run ended.
    pub status: Status,
    /// Why the status is not [`Status::Done`]; else empty.
    pub reason: String,
    /// What a reader of its numbers must know, a sentence each.
    pub remarks: Vec<String>,
    /// The recorded quantities, in the order of their columns.
    pub numbers: Vec<f64>,
    /// Its spectra, if they are stored.
    pub spectra: Vec<NamedSpectrum>,
}

/// The table of `rows`. `columns` are the recorded ones, `units` the SI units of the varied keys. Errors: [`OutputError::Ragged`] if a
/// row has too few numbers.
pub fn table(plan: &Plan, columns: &[Column], units: &[String], rows: &[&Row]) -> Result<Table, OutputError> {
    let mut table = Table::default();
    table.push("point", "1", Values::Number(rows.iter().map(|row| row.point as f64).collect()))?;
    let mut values: Vec<Vec<String>> = plan.axes.iter().map(|_| Vec::with_capacity(rows.len())).collect();
    for row in rows {
        values.iter_mut().zip(plan.values(row.point)).for_each(|(column, value)| column.push(value));
    }
    for ((axis, unit), values) in plan.axes.iter().zip(units).zip(values) {
        push_values(&mut table, axis, unit, values)?;
    }
    let words = rows.iter().map(|row| Cow::Borrowed(row.status.name())).collect();
    table.push("status", "", Values::Text(words))?;
    table.push("reason", "", Values::Text(rows.iter().map(|row| Cow::Owned(row.reason.clone())).collect()))?;
    let remarks = rows.iter().map(|row| Cow::Owned(row.remarks.join(remarks::BETWEEN))).collect();
    table.push("remarks", "", Values::Text(remarks))?;
    for (i, (name, unit)) in columns.iter().enumerate() {
        table.push(name, unit, Values::Number(rows.iter().filter_map(|row| row.numbers.get(i).copied()).collect()))?;
    }
    Ok(table)
}

/// Adds the column of a varied key. Numbers are converted to SI; `unit` is their SI unit. Errors: [`OutputError::Ragged`].
pub(super) fn push_values(table: &mut Table, axis: &Axis, unit: &str, values: Vec<String>) -> Result<(), OutputError> {
    match axis.is_numeric() {
        true => table.push(&axis.key, unit, Values::Number(values.iter().map(|value| axis::si(value)).collect())),
        false => table.push(&axis.key, "", Values::Text(values.into_iter().map(Cow::Owned).collect())),
    }
}

/// SI units of the columns of the varied keys.
pub fn units(plan: &Plan, model: &crate::model::Model) -> Vec<String> {
    plan.axes.iter().map(|axis| unit_of(&axis.key, model).unwrap_or_default()).collect()
}

/// The first varied key whose column in a table differs from the values of the plan; `None` if all agree.
pub fn strange<'a>(table: &Table, plan: &'a Plan) -> Option<&'a str> {
    let points: Vec<usize> = table.numbers("point").unwrap_or_default().iter().map(|&point| point as usize).collect();
    let values: Vec<Vec<String>> = points.iter().map(|&point| plan.values(point)).collect();
    let is_that = |(i, axis): (usize, &Axis)| match axis.is_numeric() {
        true => {
            table.numbers(&axis.key).is_some_and(|x| values.iter().zip(x).all(|(value, x)| axis::si(&value[i]) == *x))
        }
        false => table.words(&axis.key).is_some_and(|x| values.iter().zip(x).all(|(value, x)| value[i] == *x)),
    };
    plan.axes.iter().enumerate().find(|axis| !is_that(*axis)).map(|(_, axis)| axis.key.as_str())
}

/// The rows of a table made by [`table`], without spectra; `None` if a column is missing.
pub fn read(table: &Table, columns: &[Column]) -> Option<Vec<Row>> {
    let points = table.numbers("point")?;
    let (status, reason, remarks) = (table.words("status")?, table.words("reason")?, table.words("remarks")?);
    let numbers: Vec<&[f64]> = columns.iter().map(|(name, _)| table.numbers(name)).collect::<Option<_>>()?;
    let row = |i: usize| {
        Some(Row {
            point: points[i] as usize,
            status: Status::ALL.into_iter().find(|s| s.name() == status[i])?,
            reason: reason[i].clone().into_owned(),
            remarks: remarks[i].split(remarks::BETWEEN).filter(|remark| !remark.is_empty()).map(Into::into).collect(),
            numbers: numbers.iter().map(|column| column[i]).collect(),
            spectra: vec![],
        })
    };
    (0..table.rows()).map(row).collect()
}
