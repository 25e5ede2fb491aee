//! `cargo xtask derive`: run the derivation program, which alone needs the computer algebra system.

use std::process::Command;

use anyhow::{Context, bail};

/// Derive models, all of them unless some are named.
#[derive(clap::Args)]
pub struct Derive {
    /// Change nothing; fail if a committed file is not what the energies say.
    #[arg(long)]
    check: bool,
    /// Models to derive.
    models: Vec<String>,
}

impl Derive {
    /// Starts the derivation in a process of its own and passes its verdict on.
    pub fn run(&self) -> anyhow::Result<()> {
        let mut command = Command::new(env!("CARGO"));
        command.args(["run", "--quiet", "--package", "gearsim-models", "--"]);
        if self.check {
            command.arg("--check");
        }
        let status = command.args(&self.models).status().context("cannot start cargo")?;
        match status.code() {
            Some(0) => Ok(()),
            Some(_) => bail!("the derivation failed; its message is above"),
            None => bail!(
                "the derivation was aborted. Without a licence key Symbolica runs one process at a time on a machine: \
                 is another derivation or test of it running? Wait for it, and run this again"
            ),
        }
    }
}
