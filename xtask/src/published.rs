//! `cargo xtask published`: compare the models with published numbers and write the table tests/published.md.

use crate::chore::root;
use crate::suite;

/// Compare the models with published numbers; write their table to tests/published.md.
#[derive(clap::Args)]
pub struct Published {}

impl Published {
    /// Runs the tests that write the table.
    ///
    /// # Errors
    /// If a number is not reproduced.
    pub fn run(&self) -> anyhow::Result<()> {
        let table = root()?.join("tests/published.md");
        let mut tests = suite::of("models")?;
        tests.arg("published").env("GEARSIM_PUBLISHED", &table);
        suite::run(&mut tests, "a published number was not reproduced; the message is above")?;
        println!("{}", table.display());
        Ok(())
    }
}
