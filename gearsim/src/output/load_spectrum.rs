//! Tables of load spectra: `rainflow_NAME.csv` and `load_duration_NAME.csv`.

use super::OutputError;
use super::table::{Table, Values};
use crate::analysis::rainflow::{self, Cycle};
use crate::trajectory::Trajectory;

/// Classes of ranges, and of loads.
const CLASSES: usize = 100;

/// Counted cycles in classes of ranges. Errors: [`OutputError::Ragged`].
pub fn rainflow(cycles: &[Cycle], unit: &str) -> Result<Table, OutputError> {
    let classes = rainflow::classes(cycles, CLASSES);
    let column = |of: fn(&rainflow::Class) -> f64| Values::Number(classes.iter().map(of).collect());
    let mut table = Table::default();
    table.push("range_above", unit, column(|class| class.low))?;
    table.push("range_up_to", unit, column(|class| class.high))?;
    table.push("cycles", "1", column(|class| class.count))?;
    table.push("mean", unit, column(|class| class.mean))?;
    table.push("cycles_above", "1", column(|class| class.exceeded))?;
    Ok(table)
}

/// The time of a column in classes of loads, from the time `from` \[s\] on. Errors: [`OutputError::Ragged`].
pub fn durations(run: &Trajectory, from: f64, column: &[f64], unit: &str) -> Result<Table, OutputError> {
    let durations = rainflow::durations(run, from, column, CLASSES);
    let whole: f64 = durations.iter().map(|class| class.time).sum();
    let numbers = |of: &dyn Fn(&rainflow::Duration) -> f64| Values::Number(durations.iter().map(of).collect());
    let mut table = Table::default();
    table.push("load_from", unit, numbers(&|class| class.low))?;
    table.push("load_to", unit, numbers(&|class| class.high))?;
    table.push("time", "s", numbers(&|class| class.time))?;
    table.push("share", "1", numbers(&|class| class.time / whole))?;
    Ok(table)
}
