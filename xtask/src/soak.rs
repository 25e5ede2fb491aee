//! `cargo xtask soak`: the energy of a very long run without damping, in a process of its own.

use std::process::Command;

use anyhow::{Context, bail};

/// Run an undamped, aperiodic gear pair for very many events, and account for its energy.
#[derive(clap::Args)]
pub struct Soak {
    /// Cell changes and reflections to run for, e.g. 1e8.
    #[arg(long, default_value = "1e8")]
    events: String,
    /// Digits in which the state is carried: compensated or plain.
    #[arg(long, default_value = "compensated")]
    precision: String,
}

impl Soak {
    /// Starts the example and passes its verdict on.
    pub fn run(&self) -> anyhow::Result<()> {
        let mut command = Command::new(env!("CARGO"));
        command.args(["run", "--quiet", "--release", "--package", "gearsim", "--example", "soak", "--"]);
        let status = command
            .args(["--events", &self.events, "--precision", &self.precision])
            .status()
            .context("cannot start cargo")?;
        if !status.success() {
            bail!("the energy account does not hold; the message is above");
        }
        Ok(())
    }
}
