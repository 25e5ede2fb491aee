//! The recorded rows of a run, in SI units: time, state and energy account.

use std::borrow::Cow;
use std::ops::Range;

use crate::model::{Model, Output, Torque};

/// The kind of instant that a row belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Moment {
    /// A sample at the recording rate, the start, or the end.
    Sample,
    /// Left limit at a cell change or a reflection.
    Before,
    /// Right limit at a cell change or a reflection.
    After,
}

impl Moment {
    /// Its name in files.
    pub fn name(self) -> &'static str {
        match self {
            Moment::Sample => "sample",
            Moment::Before => "before",
            Moment::After => "after",
        }
    }
}

/// The recorded rows, stored by columns. All columns have one entry per row.
#[derive(Debug, Clone)]
pub struct Trajectory {
    /// The model, for the names and units of the columns.
    pub model: &'static Model,
    /// Time \[s\].
    pub t: Vec<f64>,
    /// Kind of instant.
    pub moment: Vec<Moment>,
    /// Coordinates, unwrapped \[SI\]: `q[i][row]` (n_q, n_rows).
    pub q: Vec<Vec<f64>>,
    /// Speeds [SI/s]: `q_dot[i][row]` (n_q, n_rows).
    pub q_dot: Vec<Vec<f64>>,
    /// The diagonal M_ii of the mass matrix at the start [J s^2/SI^2] (n_q); empty if it is not known.
    pub inertia: Vec<f64>,
    /// Kinetic energy T \[J\].
    pub kinetic: Vec<f64>,
    /// Strain energy V \[J\].
    pub strain: Vec<f64>,
    /// Net work of the external torques since the start, W \[J\].
    pub work: Vec<f64>,
    /// The external torques that are present, each with its work since the start \[J\].
    pub torque_work: Vec<(&'static Torque, Vec<f64>)>,
    /// The outputs that are recorded, each with its column \[SI\].
    pub outputs: Vec<(&'static Output, Vec<f64>)>,
    /// Energy dissipated by damping since the start \[J\]. It is integrated from the speeds, not computed as an energy difference.
    pub dissipated: Vec<f64>,
    /// T + V - W + dissipated, minus its value at the start \[J\]: zero if the energy balance holds.
    pub residual: Vec<f64>,
}

impl Trajectory {
    /// A trajectory of `model` without rows, with columns for the external `torques` and the outputs `recorded`, which are indices in the
    /// model.
    pub fn new(model: &'static Model, torques: &[usize], recorded: &[usize]) -> Self {
        let n = model.coordinates.len();
        Trajectory {
            model,
            t: vec![],
            moment: vec![],
            q: vec![vec![]; n],
            q_dot: vec![vec![]; n],
            inertia: vec![],
            kinetic: vec![],
            strain: vec![],
            work: vec![],
            torque_work: torques.iter().map(|&i| (&model.torques[i], vec![])).collect(),
            outputs: recorded.iter().map(|&i| (&model.outputs[i], vec![])).collect(),
            dissipated: vec![],
            residual: vec![],
        }
    }

    /// A trajectory with the same columns, without rows.
    pub fn without_rows(&self) -> Self {
        let outputs = self.outputs.iter().map(|(output, _)| (*output, vec![])).collect();
        let torque_work = self.torque_work.iter().map(|(torque, _)| (*torque, vec![])).collect();
        Trajectory { outputs, torque_work, ..Trajectory::new(self.model, &[], &[]) }
    }

    /// Memory of one row with these numbers of external torques and of outputs \[bytes\].
    pub fn bytes_of_row(model: &Model, torques: usize, outputs: usize) -> usize {
        let columns = 2 * model.coordinates.len() + torques + outputs + 6;
        columns * size_of::<f64>() + size_of::<Moment>()
    }

    /// The first row at or after the time `from` \[s\]; the number of rows if there is none.
    pub fn row_from(&self, from: f64) -> usize {
        self.t.partition_point(|&t| t < from)
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.t.len()
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.t.is_empty()
    }

    /// U = T + V - W in row `i` \[J\]. Only damping changes it.
    pub fn energy(&self, i: usize) -> f64 {
        self.kinetic[i] + self.strain[i] - self.work[i]
    }

    /// [`Trajectory::energy`]; `None` if one of the columns has no row `i`.
    fn checked_energy(&self, i: usize) -> Option<f64> {
        Some(self.kinetic.get(i)? + self.strain.get(i)? - self.work.get(i)?)
    }

    /// The largest magnitude of T, V, the dissipated energy and the work of each torque, over all rows \[J\].
    pub fn largest_energy(&self) -> f64 {
        let parts = [&self.kinetic, &self.strain, &self.dissipated];
        let works = self.torque_work.iter().map(|(_, work)| work);
        parts.into_iter().chain(works).flatten().fold(0.0, |m: f64, x| m.max(x.abs()))
    }

    /// The columns with numbers, in the order of files: time, each coordinate and its speed, the recorded outputs, the energy account.
    pub fn columns(&self) -> impl Iterator<Item = Series<'_>> {
        let series = |name: Cow<'static, str>, unit: Cow<'static, str>, values| Series { name, unit, of: self, values };
        let plain =
            move |name: &'static str, unit: &'static str, values| series(name.into(), unit.into(), Some(values));
        let states = self.model.coordinates.iter().zip(&self.q).zip(&self.q_dot);
        let states = states.flat_map(move |((coordinate, q), q_dot): ((&'static _, _), _)| {
            let (name, unit): (&'static str, &'static str) = (coordinate.name, coordinate.unit);
            let speed = series(format!("{name}_dot").into(), format!("{unit}/s").into(), Some(q_dot));
            [plain(name, unit, q), speed]
        });
        let outputs = self.outputs.iter().map(move |(output, values)| plain(output.name, output.unit, values));
        let torques = self.torque_work.iter();
        let torques =
            torques.map(move |(torque, work)| series(format!("work_{}", torque.name).into(), "J".into(), Some(work)));
        let energies = [("kinetic", &self.kinetic), ("strain", &self.strain), ("work", &self.work)];
        let account = [("dissipated", &self.dissipated), ("residual", &self.residual)];
        std::iter::once(plain("t", "s", &self.t))
            .chain(states)
            .chain(outputs)
            .chain(energies.into_iter().map(move |(name, values)| plain(name, "J", values)))
            .chain(torques)
            .chain(account.into_iter().map(move |(name, values)| plain(name, "J", values)))
            .chain(std::iter::once(series("energy".into(), "J".into(), None)))
    }

    /// The column with this name \[SI\]; `None` if there is none.
    pub fn column(&self, name: &str) -> Option<Cow<'_, [f64]>> {
        let series = self.columns().find(|series| series.name == name)?;
        series.part(0..self.len())
    }

    /// For each recorded event, the indices of the row before it and of the row after it.
    pub fn events(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let pair = |i: &usize| self.moment[*i] == Moment::Before && self.moment.get(i + 1) == Some(&Moment::After);
        (0..self.len()).filter(pair).map(|i| (i, i + 1))
    }

    /// The column of the recorded output `name` \[SI\]; `None` if it is not recorded.
    pub fn output(&self, name: &str) -> Option<&[f64]> {
        self.outputs.iter().find(|(output, _)| output.name == name).map(|(_, column)| &column[..])
    }

    /// The work of the external torque `name` since the start \[J\]; `None` if the scene does not have it.
    pub fn work_of(&self, name: &str) -> Option<&[f64]> {
        self.torque_work.iter().find(|(torque, _)| torque.name == name).map(|(_, column)| &column[..])
    }

    /// The recorded output or the coordinate `name`: its SI unit and its column; `None` if there is none.
    pub fn signal(&self, name: &str) -> Option<(&'static str, &[f64])> {
        let output = self.outputs.iter().find(|(output, _)| output.name == name);
        let coordinate = || self.model.coordinates.iter().position(|c| c.name == name);
        match output {
            Some((output, column)) => Some((output.unit, column)),
            None => coordinate().map(|i| (self.model.coordinates[i].unit, &self.q[i][..])),
        }
    }

    /// Indices of the rows of kind [`Moment::Sample`], in order.
    pub fn samples(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.len()).filter(|&i| self.moment[i] == Moment::Sample)
    }
}

/// A column of a trajectory.
#[derive(Debug, Clone)]
pub struct Series<'a> {
    /// Name, e.g. `theta_dot`.
    pub name: Cow<'static, str>,
    /// SI unit, e.g. `rad/s`.
    pub unit: Cow<'static, str>,
    of: &'a Trajectory,
    /// Its numbers; `None` for the energy T + V - W, which is not stored.
    values: Option<&'a Vec<f64>>,
}

impl<'a> Series<'a> {
    /// The numbers of the rows `rows` \[SI\]; `None` if the column does not have exactly one number per row, or some of these rows do not
    /// exist.
    pub fn part(&self, rows: Range<usize>) -> Option<Cow<'a, [f64]>> {
        match self.values {
            Some(values) => values.get(rows).filter(|_| values.len() == self.of.len()).map(Cow::Borrowed),
            None => rows.map(|i| self.of.checked_energy(i)).collect::<Option<Vec<_>>>().map(Cow::Owned),
        }
    }

    /// Length of the column.
    pub fn rows(&self) -> usize {
        self.values.map_or(self.of.len(), Vec::len)
    }
}

/// The interval between two rows that contains `time`: the row at its start, and the position of `time` in it, from 0 (start) to 1 (end).
/// The times `t` of the rows do not decrease, and there are at least two. A time outside all intervals is moved to the nearest end.
pub(crate) fn place(t: &[f64], time: f64) -> (usize, f64) {
    let next = t.partition_point(|&t| t < time).clamp(1, t.len() - 1);
    let [from, to] = [t[next - 1], t[next]];
    // If both rows have the same time, take the first one.
    (next - 1, if to > from { ((time - from) / (to - from)).clamp(0.0, 1.0) } else { 0.0 })
}

/// The value of the column `x` at `time`, by linear interpolation between the rows at the times `t`. Outside the times `t` it is the value
/// of the nearest row.
pub(crate) fn value_at(t: &[f64], x: &[f64], time: f64) -> f64 {
    let (row, share) = place(t, time);
    x[row] + share * (x[row + 1] - x[row])
}
