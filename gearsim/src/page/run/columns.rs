//! The columns of a run, sorted by what a reader looks at first.

use std::borrow::Cow;

use crate::output::OutputError;
use crate::output::unit::readable;
use crate::plot::outputs::{is_further_planet, same};
use crate::plot::rotates;
use crate::trajectory::Trajectory;

/// The kind of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum ColumnKind {
    /// An output of the model: a force, a transmission error, the speed of a rotor.
    Signal,
    /// Speed of a coordinate that rotates.
    Speed,
    /// A coordinate that does not rotate.
    Deflection,
    /// The rate of a coordinate that does not rotate.
    Rate,
    /// A coordinate that rotates.
    Rotation,
    /// A part of the energy account.
    Energy,
}

/// Columns of one kind and one unit.
pub(super) struct ColumnGroup<'a> {
    pub kind: ColumnKind,
    pub unit: Cow<'static, str>,
    pub columns: Vec<NamedColumn<'a>>,
}

/// A column with its numbers and its description, which may be empty.
#[derive(Clone)]
pub(super) struct NamedColumn<'a> {
    pub name: Cow<'static, str>,
    pub doc: String,
    pub values: Cow<'a, [f64]>,
    /// Whether an earlier column of the group is the same curve.
    pub again: bool,
}

/// Units of outputs in the order in which people look at them: speeds, forces, transmission errors, loss of contact. Others follow.
const UNITS: [&str; 6] = ["rad/s", "N", "N*m", "m", "rad", "1"];

/// Maximum number of curves of a group that are drawn at first.
const FIRST: usize = 4;

/// The parts of the energy account, with their descriptions.
const ENERGIES: [(&str, &str); 6] = [
    ("energy", "U = T + V - W; only losses change it"),
    ("kinetic", "kinetic energy T"),
    ("strain", "strain energy V"),
    ("work", "work of the torques W"),
    ("dissipated", "energy lost, integrated from the speeds"),
    ("residual", "T + V - W + dissipated, less its value at the start"),
];

impl ColumnGroup<'_> {
    /// The title of its plot.
    pub fn title(&self) -> &'static str {
        match (self.kind, &*self.unit) {
            (ColumnKind::Speed, _) => "Speeds of coordinates",
            (ColumnKind::Signal, "N") => "Forces",
            (ColumnKind::Signal, "N*m") => "Torques",
            (ColumnKind::Signal, "m") => "Displacements",
            (ColumnKind::Signal, "W") => "Powers",
            (ColumnKind::Signal, "rad/s") => "Speeds",
            (ColumnKind::Signal, "rad") => "Angles",
            (ColumnKind::Signal, _) => {
                if self.columns.iter().all(|column| column.name.starts_with("contact_loss")) {
                    "Loss of contact"
                } else {
                    "Signals"
                }
            }
            (ColumnKind::Deflection, "rad") => "Angular deflections",
            (ColumnKind::Deflection, _) => "Deflections",
            (ColumnKind::Rate, "rad/s") => "Rates of angular deflections",
            (ColumnKind::Rate, _) => "Rates of deflections",
            (ColumnKind::Rotation, _) => "Angles of rotation",
            (ColumnKind::Energy, _) => "Energies",
        }
    }

    /// The unit of its plot, and the factor to it from the SI unit. Speeds of rotors are in revolutions a minute, other angular speeds in
    /// rad/s. Other columns have the unit that suits the size of the curves that are drawn at first.
    pub fn shown_unit(&self) -> (&str, f64) {
        if self.unit == "rad/s" && self.kind != ColumnKind::Signal {
            return ("rad/s", 1.0);
        }
        let shown = self.columns.iter().enumerate().filter(|(i, _)| self.shown(*i));
        let largest = shown.flat_map(|(_, column)| column.values.iter()).fold(0.0, |most: f64, x| most.max(x.abs()));
        readable(&self.unit, largest)
    }

    /// Whether the column `index` is drawn at first: one of the first few columns that vary, but no rate and no rotation. Of columns that
    /// are the same curve, only the first is drawn.
    pub fn shown(&self, index: usize) -> bool {
        let varies = |column: &NamedColumn<'_>| !column.again && column.values.iter().any(|x| *x != column.values[0]);
        let before = self.columns[..index].iter().filter(|column| varies(column)).count();
        !matches!(self.kind, ColumnKind::Rate | ColumnKind::Rotation) && before < FIRST && varies(&self.columns[index])
    }
}

/// The columns of the run, in groups of one kind and unit. The groups are in the order of [`ColumnKind`]. In each group the columns of
/// meshes come first, and the columns of the first of several planets come before those of the others.
///
/// Errors: [`OutputError::Ragged`] if they differ in length.
pub(super) fn groups(trajectory: &Trajectory) -> Result<Vec<ColumnGroup<'_>>, OutputError> {
    let mut groups: Vec<ColumnGroup<'_>> = vec![];
    for series in trajectory.columns() {
        let Some((kind, doc)) = describe(trajectory, &series.name) else { continue };
        let values = series.part(0..trajectory.len()).ok_or_else(|| {
            let (column, rows) = (series.name.to_string(), series.rows());
            OutputError::Ragged { column, rows, expected: trajectory.len() }
        })?;
        let named = NamedColumn { name: series.name, doc, values, again: false };
        match groups.iter_mut().find(|group| (group.kind, &group.unit) == (kind, &series.unit)) {
            Some(group) => group.columns.push(named),
            None => groups.push(ColumnGroup { kind, unit: series.unit, columns: vec![named] }),
        }
    }
    let unit = |group: &ColumnGroup<'_>| UNITS.iter().position(|unit| *unit == group.unit).unwrap_or(UNITS.len());
    groups.sort_by_key(|group| (group.kind, if group.kind == ColumnKind::Signal { unit(group) } else { 0 }));
    for group in &mut groups {
        group.columns.sort_by_key(|column| (!column.name.starts_with("mesh_"), is_further_planet(&column.name)));
        for i in 1..group.columns.len() {
            let (before, rest) = group.columns.split_at_mut(i);
            if let Some(known) = before.iter().find(|known| !known.again && same(&known.values, &rest[0].values)) {
                rest[0].again = true;
                rest[0].doc = format!("the same as {}; {}", known.name, rest[0].doc);
            }
        }
    }
    Ok(groups)
}

/// The kind and the description of a column; `None` for the time.
fn describe(trajectory: &Trajectory, name: &str) -> Option<(ColumnKind, String)> {
    if name == "t" {
        return None;
    }
    for coordinate in trajectory.model.coordinates {
        if name == coordinate.name {
            let rotates = rotates(trajectory, name);
            return Some((
                if rotates { ColumnKind::Rotation } else { ColumnKind::Deflection },
                coordinate.doc.to_owned(),
            ));
        }
        if name.strip_suffix("_dot") == Some(coordinate.name) {
            let rotates = rotates(trajectory, coordinate.name);
            return Some((
                if rotates { ColumnKind::Speed } else { ColumnKind::Rate },
                format!("rate of: {}", coordinate.doc),
            ));
        }
    }
    if let Some((_, doc)) = ENERGIES.iter().find(|(energy, _)| *energy == name) {
        return Some((ColumnKind::Energy, (*doc).to_owned()));
    }
    if let Some((output, _)) = trajectory.outputs.iter().find(|(output, _)| output.name == name) {
        return Some((ColumnKind::Signal, output.doc.to_owned()));
    }
    let torque = trajectory.torque_work.iter().find(|(torque, _)| name.strip_prefix("work_") == Some(torque.name));
    Some(torque.map_or((ColumnKind::Signal, String::new()), |(torque, _)| {
        (ColumnKind::Energy, format!("work: {}", torque.doc))
    }))
}
