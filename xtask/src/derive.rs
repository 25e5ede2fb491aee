//! `cargo xtask derive`: run the derivation program, which alone needs the computer algebra system.

use std::env::consts::EXE_EXTENSION;
use std::process::Command;

use anyhow::{Context, bail};

/// The derivation program; built into the folder where this program is.
const PROGRAM: &str = "gearsim-models";

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
        // For the workspace, not for its package: with the features that the tests ask of it, Symbolica is compiled once.
        let mut build = Command::new(env!("CARGO"));
        build.args(["build", "--quiet", "--workspace", "--bin", PROGRAM]);
        if !build.status().context("cannot start cargo")?.success() {
            bail!("the derivation program does not compile; the compiler's messages are above");
        }
        let itself = std::env::current_exe().context("cannot tell where this program is")?;
        let mut command = Command::new(itself.with_file_name(PROGRAM).with_extension(EXE_EXTENSION));
        if self.check {
            command.arg("--check");
        }
        let status = command.args(&self.models).status().context("cannot start the derivation program")?;
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
