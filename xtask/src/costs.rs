//! `cargo xtask costs`: how run time, memory and compile time grow with the number of coordinates; writes tests/costs.md.

use std::process::Command;

use anyhow::{Context, bail};

use crate::chore;

/// Measure run time and memory against the number of coordinates, or compile times; write them to tests/costs.md.
#[derive(clap::Args)]
pub struct Costs {
    /// Measure compile times, with a build of gearsim from scratch; takes several minutes.
    #[arg(long)]
    compile: bool,
}

impl Costs {
    /// Starts the program that measures. Compile times of models need the library in the release profile, built before.
    pub fn run(&self) -> anyhow::Result<()> {
        if !self.compile {
            return chore::run("costs", &[]);
        }
        let mut build = Command::new(env!("CARGO"));
        build.args(["build", "--quiet", "--release", "--package", "gearsim", "--lib"]);
        if !build.current_dir(chore::root()?).status().context("cannot start cargo")?.success() {
            bail!("gearsim does not build; the compiler's messages are above");
        }
        chore::run("costs", &["--compile"])
    }
}
