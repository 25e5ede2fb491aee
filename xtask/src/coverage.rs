//! `cargo xtask coverage`: what works with what, as the table tests/coverage.md.

use std::process::Command;

use anyhow::{Context, bail};

use crate::chore::root;

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
        let mut command = Command::new(env!("CARGO"));
        command.args(["test", "--quiet", "--workspace", "--test", "coverage"]);
        let status =
            command.env("GEARSIM_COVERAGE", &table).current_dir(root()?).status().context("cannot start cargo")?;
        if !status.success() {
            bail!("the table cannot be made; the message is above");
        }
        println!("{}", table.display());
        Ok(())
    }
}
