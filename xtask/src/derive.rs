//! `cargo xtask derive`: run the derivation program, the only one that needs the computer algebra system.

use std::env::consts::EXE_EXTENSION;
use std::process::Command;

use anyhow::{Context, bail};

/// Name of the derivation program; cargo builds it into the folder of this program.
const PROGRAM: &str = "gearsim-models";

/// Derive models, all of them unless some are named.
#[derive(clap::Args)]
pub struct Derive {
    /// Change nothing; fail if a committed file differs from what the energies give.
    #[arg(long)]
    check: bool,
    /// Models to derive.
    models: Vec<String>,
}

impl Derive {
    /// Builds the derivation program and runs it in its own process.
    ///
    /// # Errors
    /// If the build or the derivation fails.
    pub fn run(&self) -> anyhow::Result<()> {
        // `--workspace`, not `--package`: with the same features as for the tests, so that Symbolica is compiled once.
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
                "the derivation was aborted. Without a licence key Symbolica allows one process at a time on a machine: \
                 is another derivation or derivation test running? Wait until it ends, then run this again"
            ),
        }
    }
}
