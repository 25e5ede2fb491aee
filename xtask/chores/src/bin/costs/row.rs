//! A row of the tables: one system, run for many cell changes.

use std::time::Duration;

use anyhow::Context;
use cpu_time::ThreadTime;
use gearsim::__private::Simulation;
use gearsim::__private::equations::Equations;
use gearsim::scene::Scene;

use crate::planetary::planetary;
use crate::train::train;

/// A system to measure.
pub struct System {
    pub name: &'static str,
    /// The table that it is in.
    pub group: Group,
    pub measure: fn() -> anyhow::Result<Row>,
}

/// A group of systems that differ only in n, the number of coordinates. Each group has a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Group {
    Undamped,
    Coupled,
    Planetary,
}

/// Measured values of one system.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Number of coordinates.
    pub n: usize,
    /// Processor time per cell change [s].
    pub change: f64,
    /// Evaluations of the motion per cell change.
    pub evaluations: f64,
    /// Processor time to prepare the run, which computes its cells and their modes [s].
    pub prepare: f64,
    /// Increase of the peak memory of the process [kB].
    pub memory: f64,
}

const fn system(name: &'static str, group: Group, measure: fn() -> anyhow::Result<Row>) -> System {
    System { name, group, measure }
}

/// All systems, by table and size.
pub const ROWS: &[System] = &[
    system("train of 2 discs", Group::Undamped, || train(2, 0.0)),
    system("train of 4 discs", Group::Undamped, || train(4, 0.0)),
    system("train of 8 discs", Group::Undamped, || train(8, 0.0)),
    system("train of 16 discs", Group::Undamped, || train(16, 0.0)),
    system("train of 32 discs", Group::Undamped, || train(32, 0.0)),
    system("train of 64 discs", Group::Undamped, || train(64, 0.0)),
    system("train of 128 discs", Group::Undamped, || train(128, 0.0)),
    system("train of 4 discs, damped", Group::Coupled, || train(4, 1e-5)),
    system("train of 8 discs, damped", Group::Coupled, || train(8, 1e-5)),
    system("train of 16 discs, damped", Group::Coupled, || train(16, 1e-5)),
    system("train of 32 discs, damped", Group::Coupled, || train(32, 1e-5)),
    system("train of 64 discs, damped", Group::Coupled, || train(64, 1e-5)),
    system("planetary, 3 planets", Group::Planetary, || planetary(3)),
    system("planetary, 4 planets", Group::Planetary, || planetary(4)),
    system("planetary, 5 planets", Group::Planetary, || planetary(5)),
    system("planetary, 6 planets", Group::Planetary, || planetary(6)),
    system("planetary, 7 planets", Group::Planetary, || planetary(7)),
];

/// Cell changes before the measurement, and in each part of it.
const CHANGES: u64 = 400;
/// Parts of a measurement; the time is that of the fastest part.
const PARTS: usize = 9;

impl Row {
    /// Measures a scene with its equations.
    ///
    /// # Errors
    /// If it does not run.
    pub fn of(scene: &Scene, equations: &dyn Equations) -> anyhow::Result<Row> {
        let before = memory()?;
        let begun = ThreadTime::now();
        let mut simulation = Simulation::new(equations, scene)?;
        let prepare = begun.elapsed().as_secs_f64();
        let mut part = |changes: u64| -> anyhow::Result<(Duration, u64, u64)> {
            let (counts, begun) = (simulation.now.counts.clone(), ThreadTime::now());
            simulation.now.t_end = f64::MAX;
            while simulation.now.counts.cell_changes < counts.cell_changes + changes {
                simulation.step(&mut None)?;
            }
            let (elapsed, now) = (begun.elapsed(), &simulation.now.counts);
            let evaluations = now.cost.evaluations - counts.cost.evaluations;
            Ok((elapsed, now.cell_changes - counts.cell_changes, evaluations))
        };
        part(CHANGES)?;
        let parts = (0..PARTS).map(|_| part(CHANGES)).collect::<anyhow::Result<Vec<_>>>()?;
        let each = |(elapsed, changes, _): &(Duration, u64, u64)| elapsed.as_secs_f64() / *changes as f64;
        let (changes, evaluations) = parts.iter().fold((0, 0), |(c, e), part| (c + part.1, e + part.2));
        Ok(Row {
            n: equations.coordinates(),
            change: parts.iter().map(each).fold(f64::INFINITY, f64::min),
            evaluations: evaluations as f64 / changes as f64,
            prepare,
            memory: memory()? - before,
        })
    }

    /// The row as a line of numbers.
    pub fn line(&self) -> String {
        let Row { n, change, evaluations, prepare, memory } = self;
        format!("{n} {change} {evaluations} {prepare} {memory}")
    }

    /// The row from a line that [`Row::line`] wrote; `None` if it is not such a line.
    pub fn parse(line: &str) -> Option<Row> {
        let mut words = line.split_whitespace();
        let n = words.next()?.parse().ok()?;
        let mut number = || words.next()?.parse().ok();
        Some(Row { n, change: number()?, evaluations: number()?, prepare: number()?, memory: number()? })
    }
}

/// Peak memory of this process so far [kB].
fn memory() -> anyhow::Result<f64> {
    let status = std::fs::read_to_string("/proc/self/status")
        .context("cannot read /proc/self/status: memory is measured on Linux only")?;
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let peak = peak.and_then(|line| line.trim().strip_suffix("kB")?.trim().parse().ok());
    peak.context("/proc/self/status does not hold the peak memory, VmHWM")
}
