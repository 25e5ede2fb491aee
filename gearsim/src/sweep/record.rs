//! The quantities that are recorded for a point, in groups. Each group has one file and one entry in [`GROUPS`].

mod digits;
mod energy;
mod events;
mod extremes;
mod meshes;
mod outputs;
mod peak;
mod state;

use crate::model::{Coordinate, Model};
use crate::run::{Entry, Outcome};
use crate::scene::Scene;
use crate::trajectory::Trajectory;

/// All groups, in the order of their columns.
pub const GROUPS: &[Group] = &[
    events::GROUP,
    state::GROUP,
    digits::GROUP,
    energy::GROUP,
    extremes::GROUP,
    peak::GROUP,
    outputs::GROUP,
    meshes::GROUP,
];

/// Quantities that are recorded together.
#[derive(Clone, Copy)]
pub struct Group {
    /// Name on the command line.
    pub name: &'static str,
    /// One line saying which quantities it has.
    pub doc: &'static str,
    /// Whether it needs samples at the recording rate. They take more time than the motion itself.
    pub samples: bool,
    /// Whether it needs the rows before and after events.
    pub limits: bool,
    /// Whether it needs the number of digits left, for which each point runs a second time.
    pub digits: bool,
    /// Whether it needs the outputs of the model.
    pub outputs: bool,
    /// The columns for a model. The second argument has the recorded outputs, as indices into `model.outputs`.
    pub columns: fn(&Model, &[usize]) -> Vec<Column>,
    /// The values of the columns for a run, NaN where a value does not exist.
    pub values: fn(&Ended<'_>) -> Vec<f64>,
}

/// A run that has ended.
pub struct Ended<'a> {
    /// The scene that ran.
    pub scene: &'a Scene,
    /// Its model.
    pub entry: &'a Entry,
    /// The run.
    pub outcome: &'a Outcome,
    /// The time from which on rows count \[s\]. Groups that use only the end ignore it.
    pub from: f64,
    /// The outputs that have columns, as indices into `model.outputs`: those that at least one point records.
    pub outputs: &'a [usize],
}

/// A column: its name and its SI unit.
pub type Column = (String, String);

/// The columns of `groups` for `model`. `outputs` are the recorded outputs, as indices into `model.outputs`.
pub fn columns(groups: &[&Group], model: &Model, outputs: &[usize]) -> Vec<Column> {
    groups.iter().flat_map(|group| (group.columns)(model, outputs)).collect()
}

/// Makes a column.
fn column(name: impl Into<String>, unit: impl Into<String>) -> Column {
    (name.into(), unit.into())
}

/// The coordinates of `model`, each with whether it rotates continuously. It does if it is the phase of a rolling law. Only the speed
/// of such a coordinate is recorded.
fn with_rotation(model: &Model) -> impl Iterator<Item = (&Coordinate, bool)> {
    let rotates = |c: &Coordinate| model.laws.iter().any(|law| law.rolling && law.phase == c.name);
    model.coordinates.iter().map(move |c| (c, rotates(c)))
}

/// Indices of the coordinates that do not rotate continuously.
pub fn elastic(model: &Model) -> Vec<usize> {
    with_rotation(model).enumerate().filter(|(_, (_, rotates))| !rotates).map(|(i, _)| i).collect()
}

/// The last entry of a recorded column; NaN if it is empty.
fn last(column: &[f64]) -> f64 {
    column.last().copied().unwrap_or(f64::NAN)
}

/// The first row at or after `from` [s].
fn row_from(run: &Trajectory, from: f64) -> usize {
    run.t.partition_point(|&t| t < from)
}
