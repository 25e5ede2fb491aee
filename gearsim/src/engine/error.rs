//! What the engine refuses, and what can end a run early.

/// Why a scene cannot be simulated; found before anything runs.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the messages are the documentation
pub enum Refusal {
    #[error("the effects of the scene contradict one another: {which}")]
    Effects { which: String },
    #[error(
        "the equations are not linear between two steps ({terms}), so there is no exact solution: name another method in [run], or none"
    )]
    Nonlinear { terms: String },
    #[error(
        "precision = \"compensated\" is offered up to a thousand cells, and not with play or a transmission error: leave it out"
    )]
    CompensatedCells,
    #[error(
        "the mass matrix is not positive definite with these numbers: an inertia is zero, negative, or lost beside another by rounding"
    )]
    Mass,
    #[error("a matrix of the equations overflows with these numbers: check the parameters' magnitudes")]
    Overflow,
    #[error("the stiffness is negative in some direction (omega^2 = {omega2:e} 1/s^2): the model would fly apart")]
    Unstable { omega2: f64 },
    #[error(
        "the damping brings vibrations of a cell together so closely that they are no longer independent (condition number {condition:.0e}): change a damping or an inertia by a part in 1e6, which parts them"
    )]
    Defective { condition: f64 },
    #[error(
        "the damping couples the modes of a cell, and the compensated mode has none for such cells: set run.precision = \"plain\""
    )]
    CompensatedCoupling,
    #[error(
        "only exact cells are compensated, and this scene is not solved by them ({0}): set run.precision = \"plain\""
    )]
    CompensatedNumerical(String),
    #[error(
        "only constant torques are compensated, not what varies in time ({torques}): set run.precision = \"plain\", or give a number"
    )]
    CompensatedVarying { torques: String },
    #[error("this way of running a scene has constant torques only, not what varies in time ({torques})")]
    Varying { torques: String },
    #[error(
        "the damping feeds energy to a vibration of a cell (which grows at {rate:e} 1/s): it must take energy from every motion"
    )]
    Feeding { rate: f64 },
    #[error("`{coordinate}` starts so many pitches off that the number does not say where in a pitch it is")]
    Far { coordinate: &'static str },
    #[error(
        "the static equilibrium of {coordinates} is not determined: nothing holds it. Give a value in [start] instead of \"static\""
    )]
    NoEquilibrium { coordinates: String },
}

/// Why a run ended before its time. What was recorded until then is kept.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[allow(missing_docs)]
pub enum Stop {
    #[error(
        "at t = {t} s the state is no longer finite ({state}) in cell {cell}: the motion grew beyond what numbers can hold"
    )]
    NotFinite { t: f64, state: String, cell: usize },
    #[error(
        "at t = {t} s, {events} events followed one another within {span:e} s ({state}, cell {cell}): a tooth is pressed against a step that it cannot climb"
    )]
    Cascade { t: f64, events: usize, span: f64, state: String, cell: usize },
    #[error(
        "at t = {t} s ({state}, cell {cell}) a phase is held at a step, and the motion that is left has no modes: {reason}"
    )]
    Held { t: f64, state: String, cell: usize, reason: Refusal },
    #[error("at t = {t} s ({state}, cell {cell}) the cell that is met has no modes: {reason}")]
    Cell { t: f64, state: String, cell: usize, reason: Refusal },
    #[error("at t = {t} s the search for the next crossing did not end within {steps} steps ({state}, cell {cell})")]
    Search { t: f64, steps: usize, state: String, cell: usize },
    #[error(
        "at t = {t} s no step of {method} is short enough, down to {h:e} s ({state}, cell {cell}): the motion has no limit there, or the tolerance is below what numbers can hold"
    )]
    Step { t: f64, h: f64, method: &'static str, state: String, cell: usize },
    #[error(
        "at t = {t} s {rows} rows are recorded, as many as output.most_rows allows: record less (output.events = false, a lower output.rate), end the run earlier, or raise output.most_rows"
    )]
    Rows { t: f64, rows: usize },
    #[error(
        "at t = {t} s {steps} steps were tried, and the run is given up ({state}, cell {cell}): allow a larger error or end it earlier"
    )]
    Steps { t: f64, steps: u64, state: String, cell: usize },
}
