//! `cargo xtask oh2005`: run the cases of the paper again.

use crate::chore;

/// Run the cases of Oh, Grosh & Barber (2005) again.
#[derive(clap::Args)]
pub struct Oh2005 {
    /// Write nothing; fail if a table of models/scenes/oh2005/README.md differs from what the runs give.
    #[arg(long)]
    check: bool,
}

impl Oh2005 {
    /// Starts the program that runs them.
    pub fn run(&self) -> anyhow::Result<()> {
        chore::run("oh2005", if self.check { &["--check"] } else { &[] })
    }
}
