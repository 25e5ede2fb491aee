//! `cargo xtask oh2005`: run the paper's cases again, in a process of its own: chores must not need code that compiles.

use std::process::Command;

use anyhow::{Context, bail};

/// Run the cases of Oh, Grosh & Barber (2005) again.
#[derive(clap::Args)]
pub struct Oh2005 {
    /// Change nothing; fail if a table of the README is not what a run gives.
    #[arg(long)]
    check: bool,
}

impl Oh2005 {
    /// Starts the example and passes its verdict on.
    pub fn run(&self) -> anyhow::Result<()> {
        let mut command = Command::new(env!("CARGO"));
        command.args(["run", "--quiet", "--release", "--package", "gearsim", "--example", "oh2005", "--"]);
        if self.check {
            command.arg("--check");
        }
        let status = command.status().context("cannot start cargo")?;
        if !status.success() {
            bail!("the cases of the paper failed; the message is above");
        }
        Ok(())
    }
}
