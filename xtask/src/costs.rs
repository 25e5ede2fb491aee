//! `cargo xtask costs`: what grows with the number of coordinates, and how; writes tests/costs.md.

use std::path::Path;
use std::process::Command;

use anyhow::{Context, bail};

/// Measure what a cell change and derived equations cost against the number of coordinates; write it to tests/costs.md.
#[derive(clap::Args)]
pub struct Costs {}

impl Costs {
    /// Builds the library that generated files are compiled against, and starts the example that measures.
    pub fn run(&self) -> anyhow::Result<()> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().context("xtask has a parent folder")?;
        for arguments in [&["build", "--lib"][..], &["run", "--example", "costs"]] {
            let mut command = Command::new(env!("CARGO"));
            command.args(arguments).args(["--quiet", "--release", "--package", "gearsim"]);
            if !command.current_dir(root).status().context("cannot start cargo")?.success() {
                bail!("the costs were not measured; the message is above");
            }
        }
        Ok(())
    }
}
