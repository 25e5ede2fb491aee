//! `cargo xtask published`: compare the models with published numbers and write the table tests/published.md.

use std::path::Path;
use std::process::Command;

use anyhow::{Context, bail};

/// Compare the models with published numbers; write their table to tests/published.md.
#[derive(clap::Args)]
pub struct Published {}

impl Published {
    /// Runs the tests that write the table.
    ///
    /// # Errors
    /// If a number is not reproduced.
    pub fn run(&self) -> anyhow::Result<()> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().context("xtask has a parent folder")?;
        let table = root.join("tests/published.md");
        let mut command = Command::new(env!("CARGO"));
        command.args(["test", "--quiet", "--workspace", "--test", "models", "published"]);
        let status =
            command.env("GEARSIM_PUBLISHED", &table).current_dir(root).status().context("cannot start cargo")?;
        if !status.success() {
            bail!("a published number was not reproduced; the message is above");
        }
        println!("{}", table.display());
        Ok(())
    }
}
