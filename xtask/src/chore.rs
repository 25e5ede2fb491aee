//! Starts a program of `gearsim-chores` (xtask/chores), in a process of its own: xtask itself must build where gearsim does not.

use std::path::Path;
use std::process::Command;

use anyhow::{Context, bail};

/// The root of the repository.
///
/// # Errors
/// If the folder of this package has no parent.
pub fn root() -> anyhow::Result<&'static Path> {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().context("the folder xtask has no parent folder")
}

/// Builds the program `name` in the release profile and runs it from the root of the repository.
///
/// # Errors
/// If it does not build, or if it fails; its own message then precedes this one.
pub fn run(name: &str, arguments: &[&str]) -> anyhow::Result<()> {
    let mut command = Command::new(env!("CARGO"));
    command.args(["run", "--quiet", "--release", "--package", "gearsim-chores", "--bin", name, "--"]);
    let status = command.args(arguments).current_dir(root()?).status().context("cannot start cargo")?;
    if !status.success() {
        bail!("`{name}` failed; its message is above");
    }
    Ok(())
}
