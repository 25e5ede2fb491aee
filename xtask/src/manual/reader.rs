//! Runs the commands of a chapter as a reader would, in a folder of its own.

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, ensure};

use super::{Book, folder};
use crate::{chore, shell};

/// The scenes that commands name, from the root of the repository.
const SCENES: &str = "models/scenes";

/// Runs the commands of a chapter in a folder of its own.
pub struct Reader {
    /// The folder in which the commands run.
    pub folder: PathBuf,
    /// The folders of programs, that of gearsim first.
    path: std::ffi::OsString,
}

impl Reader {
    /// A reader of the chapter `name` with a fresh folder, in which `models/scenes` has the committed scenes.
    pub fn new(book: &Book, name: &Path) -> anyhow::Result<Reader> {
        let work = book.folder.join("work").join(name);
        fs::create_dir_all(&work)?;
        let is_scene = |file: &Path| file.extension().is_some_and(|end| end == "toml");
        folder::copy(&chore::root()?.join(SCENES), &work.join(SCENES), &is_scene)?;
        let path = std::env::var_os("PATH").unwrap_or_default();
        let path = std::env::join_paths([book.programs.clone()].into_iter().chain(std::env::split_paths(&path)))?;
        Ok(Reader { folder: work, path })
    }

    /// What commands print.
    ///
    /// # Errors
    /// If one of them fails.
    pub fn output(&self, commands: &str) -> anyhow::Result<String> {
        let output = self.shell(commands).output()?;
        let printed = String::from_utf8_lossy(&output.stdout).into_owned();
        ensure!(output.status.success(), "this command failed:\n{commands}\n{printed}");
        Ok(printed)
    }

    /// What a command prints until it has printed `until`; then it is stopped.
    ///
    /// # Errors
    /// If it ends before.
    pub fn output_until(&self, command: &str, until: &str) -> anyhow::Result<String> {
        let mut child = self.shell(&format!("exec {command}")).stdout(Stdio::piped()).spawn()?;
        let mut lines = BufReader::new(child.stdout.take().context("no output")?).lines();
        let mut printed = String::new();
        while !printed.contains(until) {
            let line = lines.next().with_context(|| format!("ended without `{until}`:\n{command}\n{printed}"))?;
            printed += &format!("{}\n", line?);
        }
        child.kill()?;
        child.wait()?;
        Ok(printed)
    }

    fn shell(&self, commands: &str) -> Command {
        let mut shell = shell::of(&format!("exec 2>&1\n{commands}"), &self.folder);
        shell.env("PATH", &self.path);
        shell
    }
}
