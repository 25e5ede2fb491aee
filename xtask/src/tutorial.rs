//! `cargo xtask tutorial`: make a crate by `gearsim new`, and do all that its README says, word for word.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, bail, ensure};

use super::shell;

/// Make a crate by `gearsim new` in a folder of its own, and follow its README: run its commands and apply its changes.
#[derive(clap::Args)]
pub struct Tutorial {
    /// Folder for the crate, which must not exist; it stays there.
    #[arg(long, default_value = "target/tutorial/my-axle")]
    folder: PathBuf,
    /// Target folder of the crate's builds; one that is shared compiles Symbolica only once.
    #[arg(long, default_value = "target")]
    target: PathBuf,
}

/// A step of the README.
#[derive(Debug, PartialEq)]
enum Step {
    /// A command.
    Run(String),
    /// A change to a file.
    Change(String),
}

impl Tutorial {
    /// Follows the README.
    ///
    /// # Errors
    /// At the first step that fails.
    pub fn run(&self) -> anyhow::Result<()> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize()?;
        let (folder, target) = (root.join(&self.folder), root.join(&self.target));
        if folder.starts_with(root.join("target")) && folder.exists() {
            fs::remove_dir_all(&folder).context("cannot remove the crate of an earlier run")?;
        }
        let mut new = Command::new(env!("CARGO"));
        new.args(["run", "--quiet", "--release", "--locked", "--package", "gearsim", "--", "new"])
            .arg(&folder)
            .arg("--gearsim")
            .arg(&root);
        ensure!(new.current_dir(&root).status()?.success(), "`gearsim new` failed");
        // The versions of the dependencies are those that gearsim is tested with.
        fs::copy(root.join("Cargo.lock"), folder.join("Cargo.lock"))?;
        let readme = fs::read_to_string(folder.join("README.md"))?;
        let steps = steps(&readme);
        ensure!(steps.len() >= 6, "the README has only {} steps", steps.len());
        let before = symbolicas(&target);
        for step in steps {
            match step {
                Step::Run(command) => {
                    println!("\n$ {command}");
                    let status = shell::of(&command, &folder).env("CARGO_TARGET_DIR", &target).status()?;
                    ensure!(status.success(), "this command of the README failed: {command}");
                }
                Step::Change(change) => apply(&folder, &change)?,
            }
        }
        // Symbolica takes minutes to compile, so it must have the same features in `cargo derive`, in `cargo test --workspace` and in this
        // workspace.
        let after = symbolicas(&target);
        ensure!(
            after <= before.max(1),
            "Symbolica was compiled {} times, with other features: `cargo tree -e features`",
            after - before
        );
        Ok(())
    }
}

/// How often Symbolica was compiled for programs in a target folder, each time with other features of it or of its dependencies.
fn symbolicas(target: &Path) -> usize {
    let libraries = fs::read_dir(target.join("debug/deps")).into_iter().flatten().flatten();
    let name = |entry: fs::DirEntry| entry.file_name().into_string().unwrap_or_default();
    libraries.map(name).filter(|name| name.starts_with("libsymbolica-") && name.ends_with(".rlib")).count()
}

/// The steps of a README: indented lines are commands, blocks of the kind `diff` are changes.
fn steps(readme: &str) -> Vec<Step> {
    let (mut steps, mut change) = (vec![], None::<String>);
    for line in readme.lines() {
        match (&mut change, line) {
            (None, "```diff") => change = Some(String::new()),
            (Some(_), "```") => steps.extend(change.take().map(Step::Change)),
            (Some(text), _) => *text += &format!("{line}\n"),
            (None, _) => steps.extend(line.strip_prefix("    ").map(|command| Step::Run(command.into()))),
        }
    }
    steps
}

/// Applies a change to the crate, as a reader would with an editor.
fn apply(folder: &Path, change: &str) -> anyhow::Result<()> {
    println!("\n{change}");
    let mut git = Command::new("git");
    git.args(["apply", "--unidiff-zero", "--whitespace=nowarn", "-"]).current_dir(folder).stdin(Stdio::piped());
    // Without this, git takes paths relative to the repository around the crate.
    let mut git = git.env("GIT_DIR", "/dev/null").spawn().context("cannot start git")?;
    std::io::Write::write_all(&mut git.stdin.take().context("git has no input")?, change.as_bytes())?;
    if !git.wait()?.success() {
        bail!("this change of the README does not apply:\n{change}");
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_and_changes_are_found_in_order() {
        let readme = "text\n\n    cargo test\n\n```diff\n-a\n+b\n```\n    cargo derive\n";
        let expected =
            [Step::Run("cargo test".into()), Step::Change("-a\n+b\n".into()), Step::Run("cargo derive".into())];
        assert_eq!(steps(readme), expected);
    }
}
