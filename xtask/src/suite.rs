//! A test binary that is run as a command.

use std::process::Command;

use anyhow::{Context, bail};

use crate::chore::root;

/// `cargo test` for the test binary `name`, in the root of the repository.
///
/// # Errors
/// As [`root`].
pub fn of(name: &str) -> anyhow::Result<Command> {
    let mut command = Command::new(env!("CARGO"));
    // `--workspace`: with the same features as `cargo test --workspace`, so that nothing is compiled twice.
    command.args(["test", "--quiet", "--workspace", "--test", name]).current_dir(root()?);
    Ok(command)
}

/// Runs the tests.
///
/// # Errors
/// If cargo cannot be started; `failure` if a test fails.
pub fn run(command: &mut Command, failure: &str) -> anyhow::Result<()> {
    let status = command.status().context("cannot start cargo")?;
    if !status.success() {
        bail!("{failure}");
    }
    Ok(())
}
