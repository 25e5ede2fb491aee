//! `cargo xtask hard-cases`: run the hard cases of the engine and write their results to the table tests/hard-cases.md.

use std::path::Path;
use std::process::Command;

use anyhow::{Context, bail};

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
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().context("xtask has a parent folder")?;
        let table = root.join("tests/hard-cases.md");
        let cells = std::env::var("GEARSIM_CELLS").unwrap_or_else(|_| CELLS.to_string());
        let mut command = Command::new(env!("CARGO"));
        // `--workspace`: with the same features as `cargo test --workspace`, so that nothing is compiled twice.
        command.args(["test", "--quiet", "--workspace", "--test", "hard_cases"]);
        command.env("GEARSIM_HARD_CASES", &table).env("GEARSIM_CELLS", cells).current_dir(root);
        let status = command.status().context("cannot start cargo")?;
        if !status.success() {
            bail!("a hard case failed; its numbers are above, and in {} if all cases ran", table.display());
        }
        println!("{}", table.display());
        Ok(())
    }
}
