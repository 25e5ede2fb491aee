//! The time over which a point of a response curve is measured: whole periods of the slowest excitation, so that a root mean square does
//! not depend on where in a period the run ends.
//!
//! An excitation is a law that changes along its phase, or a harmonic of a torque. The period of a law is counted in the recorded phase: a
//! pitch or, with damaged teeth or pitch errors, a revolution. The period of a harmonic is a time.

use std::f64::consts::TAU;

use crate::engine::equations::{Equations, Switching};
use crate::scene::Scene;
use crate::trajectory::Trajectory;

/// The quantity by which periods are counted.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Clock {
    /// A coordinate, by its index, and its change in a period \[unit of the coordinate\].
    Phase(usize, f64),
    /// The time, and the length of a period \[s\].
    Time(f64),
}

/// The excitations of a scene: the name of the law or parameter, and its period.
pub(super) struct Excitations(Vec<(&'static str, Clock)>);

/// The measured part of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// Its start \[s\], which may lie between two samples.
    pub begin: f64,
    /// Its end, the end of the run \[s\].
    pub end: f64,
    /// Number of whole periods; 0 if the run is shorter than one, or if nothing excites the scene. Then all of the settled time is measured.
    pub periods: u32,
    /// The law or parameter whose periods these are; empty if nothing excites the scene.
    pub of: &'static str,
}

impl Excitations {
    /// The excitations of a scene with its `equations`.
    pub(super) fn of(scene: &Scene, equations: &dyn Equations) -> Self {
        let varies = |i: usize, steps: usize, curves: usize| {
            equations.switching(i) != Switching::Never && (steps > 1 || curves > 0)
        };
        let laws = scene.present().enumerate().filter(|(i, (_, law))| varies(*i, law.steps.len(), law.curves.len()));
        let laws = laws.filter_map(|(_, (law, given))| {
            let phase = scene.model.coordinates.iter().position(|c| c.name == law.phase)?;
            Some((law.name, Clock::Phase(phase, law.period * f64::from(given.pitches))))
        });
        let torques = scene.time_histories.iter().flat_map(|(p, history)| {
            let waves = history.harmonics.iter().filter(|h| h.amplitude != 0.0 && h.omega != 0.0);
            waves.map(|h| (scene.model.parameters[*p].name, Clock::Time(TAU / h.omega.abs())))
        });
        Excitations(laws.chain(torques).collect())
    }

    /// The last whole periods of the slowest excitation in the run from the time `from` \[s\] on.
    pub(super) fn span(&self, run: &Trajectory, from: f64) -> Span {
        let (first, last) = (run.row_from(from), run.len() - 1);
        let end = run.t[last];
        let all = Span { begin: run.t[first], end, periods: 0, of: "" };
        let time = end - all.begin;
        // Periods in the measured time. A phase that does not move has none.
        let passed = |clock: &Clock| match *clock {
            Clock::Phase(i, period) => (run.q[i][last] - run.q[i][first]).abs() / period,
            Clock::Time(period) => time / period,
        };
        let moving = self.0.iter().filter(|(_, clock)| passed(clock) > 0.0);
        let Some((of, clock)) = moving.min_by(|a, b| passed(&a.1).total_cmp(&passed(&b.1))) else { return all };
        // A period that is incomplete only by rounding errors counts as whole.
        let periods = (passed(clock) * (1.0 + 1e-12)).floor();
        if periods < 1.0 {
            return Span { of, ..all };
        }
        let begin = match *clock {
            Clock::Time(period) => (end - periods * period).max(all.begin),
            Clock::Phase(i, period) => {
                let (s, way) = (&run.q[i], periods * period);
                let left = |row: usize| (s[last] - s[row]).abs() - way;
                let row = (first..last).rev().find(|&row| left(row) >= 0.0).unwrap_or(first);
                let share = (left(row) / (left(row) - left(row + 1))).clamp(0.0, 1.0);
                run.t[row] + share * (run.t[row + 1] - run.t[row])
            }
        };
        Span { begin, end, periods: periods as u32, of }
    }
}

impl Span {
    /// How long it is \[s\].
    pub fn time(&self) -> f64 {
        self.end - self.begin
    }
}
