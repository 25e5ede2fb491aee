//! `cargo xtask instructions`: counts of instructions of the main paths, under callgrind.

use std::path::Path;
use std::process::Command;

use anyhow::{Context, bail};

/// Count the instructions of the main paths under callgrind; write them to tests/instructions.md.
#[derive(clap::Args)]
pub struct Instructions {
    /// Compare with the counts that are there, and write nothing.
    #[arg(long)]
    check: bool,
}

impl Instructions {
    /// Starts the example that counts.
    pub fn run(&self) -> anyhow::Result<()> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().context("xtask has a parent folder")?;
        let mut command = Command::new(env!("CARGO"));
        command.args(["run", "--quiet", "--release", "--package", "gearsim", "--example", "instructions", "--"]);
        if self.check {
            command.arg("--check");
        }
        if !command.current_dir(root).status().context("cannot start cargo")?.success() {
            bail!("the instructions were not counted, or are not those kept; the message is above");
        }
        Ok(())
    }
}
