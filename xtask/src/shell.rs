//! Commands of a text for readers, run by `sh` as a reader would type them.

use std::path::Path;
use std::process::Command;

/// `sh` with `commands`, which ends at the first that fails, to be started in `folder`.
pub fn of(commands: &str, folder: &Path) -> Command {
    let mut shell = Command::new("sh");
    shell.args(["-e", "-c", commands]).current_dir(folder);
    shell
}
