//! Records a run: samples at a chosen rate, and the left and right limits at events.

use std::time::Instant;

use smallvec::SmallVec;

use crate::engine::equations::Equations;
use crate::engine::equations::Known;
use crate::engine::error::Stop;
use crate::engine::hybrid::Hybrid;
use crate::engine::known::known;
use crate::engine::vector::Vector;
use crate::scene::Scene;
use crate::trajectory::{Moment, Trajectory};

/// Whole pitches of each coordinate (n).
pub type Turns = SmallVec<[i64; 10]>;

/// A state in the form of the engine: remainders of the angles, and counts of whole pitches.
#[derive(Debug, Clone)]
pub struct State {
    /// Coordinates without their whole pitches (n).
    pub q: Vector,
    /// Speeds (n).
    pub q_dot: Vector,
    /// Whole pitches of each coordinate (n).
    pub turns: Turns,
    /// Sum of the rounding errors of the speeds since they were set (n), see [`State::gain`].
    pub lost: Vector,
    /// The low parts of the coordinates in double-double precision (n); empty in plain precision.
    pub low: Vector,
}

impl State {
    /// A state with no turns counted yet.
    pub fn new(q: Vector, q_dot: Vector) -> Self {
        let (turns, lost) = (SmallVec::from_elem(0, q.len()), Vector::zeros(q.len()));
        State { q, q_dot, turns, lost, low: Vector::zeros(0) }
    }

    /// Whether all speeds are zero.
    #[inline]
    pub fn is_at_rest(&self) -> bool {
        self.q_dot.iter().all(|v| *v == 0.0)
    }

    /// Sets coordinate `i` to `x` exactly.
    #[inline]
    pub fn put(&mut self, i: usize, x: f64) {
        self.q[i] = x;
        if let Some(low) = self.low.get_mut(i) {
            *low = 0.0;
        }
    }

    /// The state after the increments `dq` and `dv` (n each).
    pub fn moved(&self, dq: &Vector, dv: &Vector) -> Self {
        State { turns: self.turns.clone(), ..State::new(&self.q + dq, &self.q_dot + dv) }
    }

    /// The same for the end of a motion: keeps the rounding errors of the speeds ([`State::gain`]).
    pub fn advanced(&self, dq: &Vector, dv: &Vector) -> Self {
        let mut state = self.clone();
        state.q += dq;
        state.gain(dv);
        state
    }

    /// Adds `dv` to the speeds (n), and keeps their rounding errors (Knuth's two-sum). The speed of a rolling coordinate is large compared
    /// with its change at an event. Without the correction the rounding errors add up, and the angles drift.
    #[inline]
    pub fn gain(&mut self, dv: &Vector) {
        for ((speed, lost), dv) in self.q_dot.iter_mut().zip(self.lost.iter_mut()).zip(&**dv) {
            let (v, dv) = (*speed, dv + *lost);
            let sum = v + dv;
            let part = sum - v;
            (*speed, *lost) = (sum, (v - (sum - part)) + (dv - part));
        }
    }

    /// Whether all coordinates and speeds are finite.
    #[inline]
    pub fn is_finite(&self) -> bool {
        // If a value is not finite, neither is the sum. If only the sum overflows, the values are tested one by one.
        let sum: f64 = self.q.iter().zip(&*self.q_dot).map(|(q, v)| q + v).sum();
        sum.is_finite() || self.q.iter().chain(self.q_dot.iter()).all(|x| x.is_finite())
    }

    /// The state in words, for messages.
    pub fn describe(&self) -> String {
        let list = |v: &[f64]| v.iter().map(|x| format!("{x:.6e}")).collect::<Vec<_>>().join(", ");
        format!("q = [{}], q' = [{}]", list(&self.q), list(&self.q_dot))
    }

    /// The coordinates unwrapped, with `pitch` the length of one turn of each.
    pub fn unwrapped(&self, pitch: &[f64]) -> Vector {
        Vector::from_fn(pitch.len(), |i| self.turns[i] as f64 * pitch[i] + self.q[i])
    }
}

/// The recorded columns of a run, with its energy account.
pub struct Recorder<'a> {
    equations: &'a dyn Equations,
    /// The outputs that are recorded, by their numbers.
    outputs: Vec<usize>,
    /// Their values in the present row.
    values: Vec<f64>,
    pitch: Vector,
    start: State,
    /// T + V at the start \[J\].
    pub energy_at_start: f64,
    /// Work of the varying part of each torque of the scene, for the next row \[J\]; empty if all torques are constant.
    pub beyond: Vec<f64>,
    /// The rows.
    pub trajectory: Trajectory,
    /// Rows that may be recorded.
    pub most_rows: u64,
    /// When the run is stopped, finished or not; `None` if there is no limit.
    pub until: Option<Instant>,
    /// Number of calls of [`Recorder::allow`].
    turns: u32,
}

impl<'a> Recorder<'a> {
    /// A recorder of a run of `scene` that starts at `start` with law values `k`.
    pub fn new(scene: &Scene, equations: &'a dyn Equations, pitch: Vector, start: State, k: &[f64]) -> Self {
        let energy_at_start = equations.kinetic(&start.q, &start.q_dot) + equations.potential(&start.q, k);
        let outputs = scene.output.record.clone();
        let mut trajectory = Trajectory::new(scene.model, &scene.torques(), &outputs);
        trajectory.inertia = equations.mass(&start.q).diagonal().iter().copied().collect();
        Recorder {
            equations,
            values: vec![0.0; outputs.len()],
            outputs,
            pitch,
            start,
            energy_at_start,
            beyond: vec![],
            trajectory,
            most_rows: u64::MAX,
            until: None,
            turns: 0,
        }
    }

    /// Stops a run that has the largest allowed number of rows, or that has reached the time `until`. The clock is read at every 16th call.
    ///
    /// # Errors
    /// [`Stop::Rows`], [`Stop::Time`].
    #[inline]
    pub fn allow(&mut self) -> Result<(), Stop> {
        let rows = self.trajectory.len();
        if rows as u64 >= self.most_rows {
            return Err(Stop::Rows { t: self.reached(), rows });
        }
        self.turns = self.turns.wrapping_add(1);
        match self.until {
            Some(until) if self.turns.is_multiple_of(16) && Instant::now() >= until => {
                Err(Stop::Time { t: self.reached() })
            }
            _ => Ok(()),
        }
    }

    /// The time of the last row \[s\].
    #[cold]
    fn reached(&self) -> f64 {
        self.trajectory.t.last().copied().unwrap_or(0.0)
    }

    /// Adds a row of the run `now` in a `state` of its present mode with the law values `k`; `dissipated` is the energy that damping has
    /// taken so far, and `ignored` the energy neglected in contacts \[J\].
    pub fn row(
        &mut self,
        now: &Hybrid<'_>,
        (t, moment): (f64, Moment),
        state: &State,
        k: &[f64],
        (dissipated, ignored): (f64, f64),
    ) {
        let asked = self.trajectory.outputs.iter().any(|(output, _)| output.known);
        let known = if asked { known(now, t, state, k) } else { Known::default() };
        let (kinetic, strain) = (self.equations.kinetic(&state.q, &state.q_dot), self.equations.potential(&state.q, k));
        // Displacements from differences of counts and of remainders: whole pitches cancel exactly.
        let moved = Vector::from_fn(state.q.len(), |i| {
            (state.turns[i] - self.start.turns[i]) as f64 * self.pitch[i] + (state.q[i] - self.start.q[i])
        });
        let mut work = self.equations.work(&moved);
        self.beyond.iter().for_each(|beyond| work += beyond);
        let row = &mut self.trajectory;
        row.t.push(t);
        row.moment.push(moment);
        let q = state.unwrapped(&self.pitch);
        if !self.outputs.is_empty() {
            self.equations.write_outputs(&self.outputs, &q, &state.q_dot, k, &known, &mut self.values);
            row.outputs.iter_mut().zip(&self.values).for_each(|((_, column), value)| column.push(*value));
        }
        for (i, x) in q.iter().enumerate() {
            row.q[i].push(*x);
            row.q_dot[i].push(state.q_dot[i]);
        }
        row.kinetic.push(kinetic);
        row.strain.push(strain);
        row.work.push(work);
        for (at, (&i, (_, column))) in now.torques.iter().zip(&mut row.torque_work).enumerate() {
            let constant = self.equations.torque_work(i, &moved);
            column.push(self.beyond.get(at).map_or(constant, |beyond| constant + beyond));
        }
        row.dissipated.push(dissipated);
        row.residual.push(kinetic + strain - work + dissipated + ignored - self.energy_at_start);
    }
}
