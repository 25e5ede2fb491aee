//! The recorded rows of a run, in SI units: time, state and energy account.

use crate::model::{Model, Output};

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
    /// Time [s].
    pub t: Vec<f64>,
    /// Kind of instant.
    pub moment: Vec<Moment>,
    /// Coordinates, unwrapped [SI]: `q[i][row]` (n_q, n_rows).
    pub q: Vec<Vec<f64>>,
    /// Speeds [SI/s]: `q_dot[i][row]` (n_q, n_rows).
    pub q_dot: Vec<Vec<f64>>,
    /// Kinetic energy T [J].
    pub kinetic: Vec<f64>,
    /// Strain energy V [J].
    pub strain: Vec<f64>,
    /// Net work of the external torques since the start, W [J].
    pub work: Vec<f64>,
    /// Work of each external torque since the start [J]: (n_torques, n_rows).
    pub torque_work: Vec<Vec<f64>>,
    /// The outputs that are recorded, each with its column [SI].
    pub outputs: Vec<(&'static Output, Vec<f64>)>,
    /// Energy dissipated by damping since the start [J]. It is integrated from the speeds, not computed as an energy difference.
    pub dissipated: Vec<f64>,
    /// T + V - W + dissipated, minus its value at the start [J]: zero if the energy balance holds.
    pub residual: Vec<f64>,
}

impl Trajectory {
    /// A trajectory of `model` without rows that has the outputs `recorded`, by their numbers.
    pub fn new(model: &'static Model, recorded: &[usize]) -> Self {
        let n = model.coordinates.len();
        Trajectory {
            model,
            t: vec![],
            moment: vec![],
            q: vec![vec![]; n],
            q_dot: vec![vec![]; n],
            kinetic: vec![],
            strain: vec![],
            work: vec![],
            torque_work: vec![vec![]; model.torques.len()],
            outputs: recorded.iter().map(|&i| (&model.outputs[i], vec![])).collect(),
            dissipated: vec![],
            residual: vec![],
        }
    }

    /// A trajectory with the same columns, without rows.
    pub fn without_rows(&self) -> Self {
        let outputs = self.outputs.iter().map(|(output, _)| (*output, vec![])).collect();
        Trajectory { outputs, ..Trajectory::new(self.model, &[]) }
    }

    /// Memory of one row with a number of outputs \[bytes\].
    pub fn bytes_of_row(model: &Model, outputs: usize) -> usize {
        let columns = 2 * model.coordinates.len() + model.torques.len() + outputs + 6;
        columns * size_of::<f64>() + size_of::<Moment>()
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.t.len()
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.t.is_empty()
    }

    /// U = T + V - W in row `i` [J]. Only damping changes it.
    pub fn energy(&self, i: usize) -> f64 {
        self.kinetic[i] + self.strain[i] - self.work[i]
    }

    /// The largest magnitude of T, V, the dissipated energy and the work of each torque, over all rows \[J\].
    pub fn largest_energy(&self) -> f64 {
        let parts = [&self.kinetic, &self.strain, &self.dissipated];
        parts.into_iter().chain(&self.torque_work).flatten().fold(0.0, |m: f64, x| m.max(x.abs()))
    }

    /// The column of the recorded output `name`.
    pub fn output(&self, name: &str) -> Option<&[f64]> {
        self.outputs.iter().find(|(output, _)| output.name == name).map(|(_, column)| &column[..])
    }

    /// The recorded output or the coordinate `name`: its SI unit and its column.
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
