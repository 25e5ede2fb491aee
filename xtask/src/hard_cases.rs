//! `cargo xtask hard-cases`: run the hard cases of the engine and write their results to the table tests/hard-cases.md.

use crate::chore::root;
use crate::suite;

/// Number of random cells, unless GEARSIM_CELLS gives it: more than a normal test run has time for.
const CELLS: &str = "100000";

/// Run the hard cases of the engine; write their table to tests/hard-cases.md.
#[derive(clap::Args)]
pub struct HardCases {}

impl HardCases {
    /// Runs the test binary that writes the table.
    ///
    /// # Errors
    /// If a hard case fails.
    pub fn run(&self) -> anyhow::Result<()> {
        let table = root()?.join("tests/hard-cases.md");
        let cells = std::env::var("GEARSIM_CELLS").unwrap_or_else(|_| CELLS.to_string());
        let mut tests = suite::of("hard_cases")?;
        tests.env("GEARSIM_HARD_CASES", &table).env("GEARSIM_CELLS", cells);
        let failure = format!("a hard case failed; its numbers are above, and in {} if all cases ran", table.display());
        suite::run(&mut tests, &failure)?;
        println!("{}", table.display());
        Ok(())
    }
}
