//! The table of a run: measured numbers to two digits and no timings, so that it changes only if a result changes.

use std::fmt::Write;
use std::sync::{Arc, Mutex};

use crate::case::{Case, Measured};

/// Environment variable with the path of the file to write.
const FILE: &str = "GEARSIM_HARD_CASES";

const HEAD: &str = "\
# Hard cases

What the engine promises, as numbers. `cargo xtask hard-cases` writes this file from a run; do not edit it. A row is a kind of
difficulty; margin is tolerance over measured; a count must be 0.

| row | case | proves | tolerance | measured | margin | why that tolerance |
| --- | --- | --- | --- | --- | --- | --- |
";

/// Whether a table is to be written.
pub fn asked_for() -> bool {
    std::env::var_os(FILE).is_some()
}

/// The numbers measured so far, shared by the threads that measure.
#[derive(Clone)]
pub struct Table {
    cases: Arc<[&'static Case]>,
    measured: Arc<Mutex<Vec<Option<Measured>>>>,
}

impl Table {
    /// An empty table of these cases.
    pub fn new(cases: &[&'static Case]) -> Self {
        Table { cases: cases.into(), measured: Arc::new(Mutex::new(vec![None; cases.len()])) }
    }

    /// Enters the number of case `i`.
    pub fn enter(&self, i: usize, measured: Measured) {
        self.measured.lock().expect("no thread fails while it enters a number")[i] = Some(measured);
    }

    /// Writes the table if the environment variable is set. Fails if a case was not measured.
    pub fn write(&self) -> Result<(), String> {
        let Some(path) = std::env::var_os(FILE) else { return Ok(()) };
        let mut text = HEAD.to_string();
        for (case, measured) in self.cases.iter().zip(self.measured.lock().expect("all threads have ended").iter()) {
            let Some(Measured { value, note }) = measured else {
                return Err(format!("no table: {} was not measured", case.name));
            };
            let Case { row, name, proves, tolerance, unit, reason, .. } = case;
            let note = if note.is_empty() { String::new() } else { format!("; {note}") };
            let margin = match *value {
                0.0 => "-".to_string(),
                value if value <= *tolerance => digits(tolerance / value),
                _ => "**fails**".to_string(),
            };
            let (tolerance, value) = (digits(*tolerance), digits(*value));
            let [name, proves, unit, reason] = [name, proves, unit, reason].map(|text| text.replace('|', "\\|"));
            let line =
                format!("| {row} | {name} | {proves}{note} | {tolerance} {unit} | {value} | {margin} | {reason} |");
            writeln!(text, "{line}").expect("a string takes any text");
        }
        std::fs::write(&path, text).map_err(|e| format!("cannot write {}: {e}", path.display()))
    }
}

/// A number with two digits.
fn digits(x: f64) -> String {
    match x.abs() {
        0.0 => "0".to_string(),
        0.01..100.0 => {
            let places = (1 - x.abs().log10().floor() as i32).max(0) as usize;
            format!("{x:.places$}")
        }
        _ => format!("{x:.1e}"),
    }
}
