//! What is kept of a point: groups of quantities, one file and one line of [`GROUPS`] each.

mod digits;
mod energy;
mod events;
mod extremes;
mod peak;
mod state;

use crate::model::{Coordinate, Model};
use crate::run::Outcome;
use crate::trajectory::Trajectory;

/// All groups, in the order of their columns.
pub const GROUPS: &[Group] = &[events::GROUP, state::GROUP, digits::GROUP, energy::GROUP, extremes::GROUP, peak::GROUP];

/// Quantities that are kept together.
#[derive(Clone, Copy)]
pub struct Group {
    /// Name on the command line.
    pub name: &'static str,
    /// One line saying what it has.
    pub doc: &'static str,
    /// Whether it is worked out from samples of the motion, which cost more time than the motion itself.
    pub samples: bool,
    /// Whether it is worked out from the limits at events.
    pub limits: bool,
    /// Whether it asks how many digits are left, which takes a second run of each point.
    pub digits: bool,
    /// Names of its columns and their units, for a model.
    pub columns: fn(&Model) -> Vec<Column>,
    /// Their values for a run, of the time from [s] on where that matters. What there is not is NaN.
    pub values: fn(&Outcome, f64) -> Vec<f64>,
}

/// A column: its name and its SI unit.
pub type Column = (String, String);

/// The columns of `groups`, for a model.
pub fn columns(groups: &[&Group], model: &Model) -> Vec<Column> {
    groups.iter().flat_map(|group| (group.columns)(model)).collect()
}

/// A column.
fn column(name: impl Into<String>, unit: impl Into<String>) -> Column {
    (name.into(), unit.into())
}

/// The coordinates of `model`, and whether each only rolls on: then its speed says more than its value.
fn rolling(model: &Model) -> impl Iterator<Item = (&Coordinate, bool)> {
    let rolls = |c: &Coordinate| model.laws.iter().any(|law| law.rolling && law.phase == c.name);
    model.coordinates.iter().map(move |c| (c, rolls(c)))
}

/// Indices of the coordinates that do not roll on.
pub fn elastic(model: &Model) -> Vec<usize> {
    rolling(model).enumerate().filter(|(_, (_, rolls))| !rolls).map(|(i, _)| i).collect()
}

/// The last entry of a column of a recording.
fn last(column: &[f64]) -> f64 {
    column.last().copied().unwrap_or(f64::NAN)
}

/// The first row at or after `from` [s].
fn row_from(run: &Trajectory, from: f64) -> usize {
    run.t.partition_point(|&t| t < from)
}
