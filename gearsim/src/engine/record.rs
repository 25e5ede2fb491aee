//! Writes down what a run does: samples at a chosen rate, and the left and right limits at events.

use nalgebra::SVector;

use crate::engine::equations::Equations;
use crate::engine::error::Stop;
use crate::model::Model;
use crate::trajectory::{Moment, Trajectory};

/// A state as the engine has it: remainders of the angles, and the pitches counted off.
#[derive(Debug, Clone, Copy)]
pub struct State<const N: usize> {
    /// Coordinates, less whole pitches (N).
    pub q: SVector<f64, N>,
    /// Speeds (N).
    pub q_dot: SVector<f64, N>,
    /// Whole pitches of each coordinate (N).
    pub turns: [i64; N],
    /// What the speeds have lost to rounding since they were set (N), see [`State::gain`].
    pub lost: SVector<f64, N>,
}

impl<const N: usize> State<N> {
    /// A state that has lost nothing yet.
    pub fn new(q: SVector<f64, N>, q_dot: SVector<f64, N>, turns: [i64; N]) -> Self {
        State { q, q_dot, turns, lost: SVector::zeros() }
    }

    /// Adds `dv` to the speeds (N), and keeps what their last digits do not hold (Knuth's two-sum). A speed that rolls on
    /// is large beside what it gains at an event: rounded away, that adds up, and angles drift by it.
    #[inline]
    pub fn gain(&mut self, dv: &SVector<f64, N>) {
        for i in 0..N {
            let (v, dv) = (self.q_dot[i], dv[i] + self.lost[i]);
            let sum = v + dv;
            let part = sum - v;
            (self.q_dot[i], self.lost[i]) = (sum, (v - (sum - part)) + (dv - part));
        }
    }

    /// Whether all of it is finite.
    #[inline]
    pub fn is_finite(&self) -> bool {
        // What is not finite stays so in a sum; where the sum alone is beyond numbers, one by one.
        let mut sum = 0.0;
        for i in 0..N {
            sum += self.q[i] + self.q_dot[i];
        }
        sum.is_finite() || self.q.iter().chain(self.q_dot.iter()).all(|x| x.is_finite())
    }

    /// The state in words, for messages.
    pub fn describe(&self) -> String {
        let list = |v: &SVector<f64, N>| v.iter().map(|x| format!("{x:.6e}")).collect::<Vec<_>>().join(", ");
        format!("q = [{}], q' = [{}]", list(&self.q), list(&self.q_dot))
    }

    /// The coordinates unwrapped, with `pitch` the length of one turn of each.
    pub fn unwrapped(&self, pitch: &[f64; N]) -> [f64; N] {
        std::array::from_fn(|i| self.turns[i] as f64 * pitch[i] + self.q[i])
    }
}

/// The account and the columns of a run.
pub struct Recorder<'a, const N: usize> {
    equations: &'a dyn Equations<N>,
    pitch: [f64; N],
    start: State<N>,
    /// T + V at the start [J].
    pub energy_at_start: f64,
    /// Work of each torque beyond that of a constant one [J] in the next row (n_torques); empty where all are constant.
    pub beyond: Vec<f64>,
    /// The rows.
    pub trajectory: Trajectory,
    /// Rows that may be recorded.
    pub most_rows: u64,
}

impl<'a, const N: usize> Recorder<'a, N> {
    /// A recorder of a run that starts at `start` with law values `k`.
    pub fn new(
        model: &'static Model,
        equations: &'a dyn Equations<N>,
        pitch: [f64; N],
        start: State<N>,
        k: &[f64],
    ) -> Self {
        let energy_at_start = equations.kinetic(&start.q_dot.into()) + equations.potential(&start.q.into(), k);
        let (beyond, trajectory) = (vec![], Trajectory::new(model));
        Recorder { equations, pitch, start, energy_at_start, beyond, trajectory, most_rows: u64::MAX }
    }

    /// Ends a run that has recorded as many rows as it may.
    ///
    /// # Errors
    /// [`Stop::Rows`].
    #[inline]
    pub fn demand_room(&self) -> Result<(), Stop> {
        if (self.trajectory.len() as u64) < self.most_rows { Ok(()) } else { Err(self.full()) }
    }

    #[cold]
    fn full(&self) -> Stop {
        Stop::Rows { t: self.trajectory.t.last().copied().unwrap_or(0.0), rows: self.trajectory.len() }
    }

    /// Adds a row; `lost` is what damping took so far, and what was ignored in contacts [J].
    pub fn row(&mut self, t: f64, moment: Moment, state: &State<N>, k: &[f64], lost: (f64, f64)) {
        let (dissipated, ignored) = lost;
        let q: [f64; N] = state.q.into();
        let (kinetic, strain) = (self.equations.kinetic(&state.q_dot.into()), self.equations.potential(&q, k));
        // Displacements from differences of counts and of remainders: whole pitches cancel exactly.
        let moved: [f64; N] = std::array::from_fn(|i| {
            (state.turns[i] - self.start.turns[i]) as f64 * self.pitch[i] + (q[i] - self.start.q[i])
        });
        let mut work = self.equations.work(&moved);
        self.beyond.iter().for_each(|beyond| work += beyond);
        let row = &mut self.trajectory;
        row.t.push(t);
        row.moment.push(moment);
        for (i, x) in state.unwrapped(&self.pitch).into_iter().enumerate() {
            row.q[i].push(x);
            row.q_dot[i].push(state.q_dot[i]);
        }
        row.kinetic.push(kinetic);
        row.strain.push(strain);
        row.work.push(work);
        for (i, column) in row.torque_work.iter_mut().enumerate() {
            let constant = self.equations.torque_work(i, &moved);
            column.push(self.beyond.get(i).map_or(constant, |beyond| constant + beyond));
        }
        row.dissipated.push(dissipated);
        row.residual.push(kinetic + strain - work + dissipated + ignored - self.energy_at_start);
    }
}
