//! Errors of the engine: why a scene is refused before a run, and why a run stops early.

use crate::engine::cells::Number;

/// Why a scene cannot be simulated. It is detected before the run starts.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the messages are the documentation
pub enum Refusal {
    #[error("the scene has no [run], and so no end: add\n[run]\nt_end = \"... s\"")]
    NoRun,
    #[error("the effects of the scene contradict one another: {which}")]
    Effects { which: String },
    #[error(
        "the equations of a cell are nonlinear ({terms}), so the exact method cannot solve them: set another run.method, or leave it out"
    )]
    Nonlinear { terms: String },
    #[error(
        "the mass matrix is not positive definite: check the inertias. One is zero or negative, or so much smaller than another that rounding removes it"
    )]
    Mass,
    #[error(
        "the energy of the start is beyond the range of floating-point numbers, 1.8e308 J: check the speeds and coordinates in [start], and the inertias"
    )]
    StartOverflow,
    #[error("an entry of a matrix of the equations is not finite: check the magnitudes of the parameters")]
    Overflow,
    #[error(
        "the stiffness matrix of a cell is not positive semidefinite (omega^2 = {omega2:e} 1/s^2), so the motion grows without bound: check the stiffnesses"
    )]
    Unstable { omega2: f64 },
    #[error(
        "the damping makes modes of a cell almost linearly dependent (condition number {condition:.0e}): change a damping or an inertia by a factor of 1 + 1e-6 to separate them"
    )]
    Defective { condition: f64 },
    #[error(
        "the computed modes of a cell do not represent every motion: a part of {missed:.0e} of one is missing. Change a damping or an inertia by a factor of 1 + 1e-6, or choose a method by steps, such as run.method = \"dop853\""
    )]
    ModesMissed { missed: f64 },
    #[error(
        "precision = \"compensated\" needs the exact method, and this scene is solved by another one ({0}): set run.precision = \"plain\""
    )]
    CompensatedNumerical(String),
    #[error("this way of running a scene needs constant torques, but one varies in time ({torques}): give a number")]
    Varying { torques: String },
    #[error(
        "the damping adds energy to a mode of a cell, which grows at {rate:e} 1/s: check the damping, which must remove energy from every motion"
    )]
    Feeding { rate: f64 },
    #[error(
        "`{coordinate}` starts more than 1e15 pitches from 0, where its rounding error is as large as a pitch: give it a smaller value in [start]"
    )]
    Far { coordinate: &'static str },
    #[error(
        "no static equilibrium of {coordinates} is found, or the forces do not determine it: give a value in [start] instead of \"static\""
    )]
    NoEquilibrium { coordinates: String },
}

/// Why a run stopped before its end time. The rows recorded until then are kept.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[allow(missing_docs)]
pub enum Stop {
    #[error(
        "at t = {} s the state is no longer finite ({state}) in cell {cell}: the motion grew beyond the range of floating-point numbers",
        at(*t)
    )]
    NotFinite { t: f64, state: String, cell: Number },
    #[error(
        "at t = {} s, {events} events followed one another within {span:e} s ({state}, cell {cell}): a phase is pressed against a step of the stiffness that its energy cannot pass, or it turns so fast that these steps take no time compared with the vibration: check the speeds in [start]",
        at(*t)
    )]
    Cascade { t: f64, events: usize, span: f64, state: String, cell: Number },
    #[error(
        "at t = {} s ({state}, cell {cell}) a phase is held at a step, and the modes of the motion with this phase held cannot be computed: {reason}",
        at(*t)
    )]
    Held { t: f64, state: String, cell: Number, reason: Refusal },
    #[error(
        "at t = {} s ({state}, cell {cell}) the modes of the cell entered there cannot be computed: {reason}",
        at(*t)
    )]
    Cell { t: f64, state: String, cell: Number, reason: Refusal },
    #[error(
        "at t = {} s the search for the next crossing did not end within {steps} steps ({state}, cell {cell})",
        at(*t)
    )]
    Search { t: f64, steps: usize, state: String, cell: Number },
    #[error(
        "at t = {} s {method} does not meet the tolerance with steps down to {h:e} s ({state}, cell {cell}): the motion is singular there, or the tolerance is below the rounding error",
        at(*t)
    )]
    Step { t: f64, h: f64, method: &'static str, state: String, cell: Number },
    #[error(
        "at t = {} s the run has recorded {rows} rows, the limit output.most_rows: record less (output.events = false, a lower output.rate), end the run earlier, or raise output.most_rows",
        at(*t)
    )]
    Rows { t: f64, rows: usize },
    #[error("at t = {} s the run had used the computing time that it is allowed", at(*t))]
    Time { t: f64 },
    #[error(
        "at t = {} s the run has reached the limit of {steps} steps ({state}, cell {cell}): raise run.tolerance or run.step, or end the run earlier",
        at(*t)
    )]
    Steps { t: f64, steps: u64, state: String, cell: Number },
}

/// A time [s], short for very small ones.
fn at(t: f64) -> String {
    if t != 0.0 && t.abs() < 1e-4 { format!("{t:e}") } else { format!("{t}") }
}
