//! `cargo xtask instructions`: instruction counts of the main code paths, under callgrind.

use crate::chore;

/// Count the instructions of the main code paths under callgrind; write them to tests/instructions.md.
#[derive(clap::Args)]
pub struct Instructions {
    /// Write nothing; fail if a count differs from the one in the table by more than 3 %.
    #[arg(long)]
    check: bool,
}

impl Instructions {
    /// Starts the program that counts.
    pub fn run(&self) -> anyhow::Result<()> {
        chore::run("instructions", if self.check { &["--check"] } else { &[] })
    }
}
