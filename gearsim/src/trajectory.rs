//! What a run recorded: one row an instant, in SI units, with its energy account.

use crate::model::Model;

/// Which instant a row is.
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
    /// The word that stands for it in files.
    pub fn name(self) -> &'static str {
        match self {
            Moment::Sample => "sample",
            Moment::Before => "before",
            Moment::After => "after",
        }
    }
}

/// Everything recorded, column by column; all columns have one entry a row.
#[derive(Debug, Clone)]
pub struct Trajectory {
    /// The model, for the names and units of the columns.
    pub model: &'static Model,
    /// Time [s].
    pub t: Vec<f64>,
    /// Which instant it is.
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
    /// Energy lost to damping since the start [J], integrated on its own, not by difference.
    pub dissipated: Vec<f64>,
    /// T + V - W + dissipated, less its value at the start [J]: zero where the equations conserve energy.
    pub residual: Vec<f64>,
}

impl Trajectory {
    /// An empty recording of `model`.
    pub fn new(model: &'static Model) -> Self {
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
            dissipated: vec![],
            residual: vec![],
        }
    }

    /// Memory that a row takes \[bytes\].
    pub fn bytes_of_row(model: &Model) -> usize {
        let columns = 2 * model.coordinates.len() + model.torques.len() + 6;
        columns * size_of::<f64>() + size_of::<Moment>()
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.t.len()
    }

    /// Whether nothing was recorded.
    pub fn is_empty(&self) -> bool {
        self.t.is_empty()
    }

    /// U = T + V - W in row `i` [J]: the energy that only damping may change.
    pub fn energy(&self, i: usize) -> f64 {
        self.kinetic[i] + self.strain[i] - self.work[i]
    }

    /// The largest part of the energy account at any row \[J\]: T, V, the energy dissipated, the work of a torque.
    pub fn largest_energy(&self) -> f64 {
        let parts = [&self.kinetic, &self.strain, &self.dissipated];
        parts.into_iter().chain(&self.torque_work).flatten().fold(0.0, |m: f64, x| m.max(x.abs()))
    }

    /// The rows that are samples at the recording rate, in order.
    pub fn samples(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.len()).filter(|&i| self.moment[i] == Moment::Sample)
    }
}
