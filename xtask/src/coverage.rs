//! `cargo xtask coverage`: which effects of which models work with which commands, as the table tests/coverage.md.

use crate::chore::root;
use crate::suite;

/// Run every effect of every model under every command; write the table to tests/coverage.md.
#[derive(clap::Args)]
pub struct Coverage {}

impl Coverage {
    /// Runs the test that writes the table.
    ///
    /// # Errors
    /// If the test fails.
    pub fn run(&self) -> anyhow::Result<()> {
        let table = root()?.join("tests/coverage.md");
        let mut tests = suite::of("coverage")?;
        tests.env("GEARSIM_COVERAGE", &table);
        suite::run(&mut tests, "the table cannot be made; the message is above")?;
        println!("{}", table.display());
        Ok(())
    }
}
