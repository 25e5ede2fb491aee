//! `cargo xtask published`: write the table of published numbers beside ours, tests/published.md.

use std::path::Path;
use std::process::Command;

use anyhow::{Context, bail};

/// Compare the models with published numbers; write their table to tests/published.md.
#[derive(clap::Args)]
pub struct Published {}

impl Published {
    /// Starts the tests in a process of their own, which write the table.
    pub fn run(&self) -> anyhow::Result<()> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().context("xtask has a parent folder")?;
        let table = root.join("tests/published.md");
        let mut command = Command::new(env!("CARGO"));
        command.args(["test", "--quiet", "--package", "gearsim-tests", "--test", "models", "published"]);
        let status =
            command.env("GEARSIM_PUBLISHED", &table).current_dir(root).status().context("cannot start cargo")?;
        if !status.success() {
            bail!("a published number was missed; see above");
        }
        println!("{}", table.display());
        Ok(())
    }
}
