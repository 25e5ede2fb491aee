//! A chapter, with what its commands print and plot.
//!
//! | in a chapter | what becomes of it |
//! | --- | --- |
//! | a block `sh` | its commands are run; what they print follows as a block `text` |
//! | `<!-- file: NAME -->` before a block | the block is written to the file NAME before the next command |
//! | `<!-- until: TEXT -->` before a block `sh` | its command, which does not end, is stopped once it has printed TEXT |
//! | `<!-- prints: TEXT -->` after a block `sh` | a check: the block has printed TEXT, with any blanks between the words |
//! | `![words](PLOT)` | the plot is copied into the book; it must be there |
//! | `<!-- model: NAME -->` and others | a generated part: [`super::generated`] |
//!
//! The commands of a chapter share a folder, in which `models/scenes` has the committed scenes.

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, bail, ensure};

use super::part::{self, Part};
use super::{folder, generated};
use crate::{chore, shell};

/// Runs the chapter `name` of the manual in `source`, and writes it to `book`.
pub fn write(source: &Path, name: &Path, book: &Path) -> anyhow::Result<()> {
    let text = fs::read_to_string(source.join(name).with_extension("md"))?;
    let work = book.join("work").join(name);
    fs::create_dir_all(&work)?;
    let scenes = Path::new("models/scenes");
    let is_scene = |file: &Path| file.extension().is_some_and(|end| end == "toml");
    folder::copy(&chore::root()?.join(scenes), &work.join(scenes), &is_scene)?;
    let mut chapter = Chapter { source, name, book, work, text: String::new(), printed: String::new(), note: None };
    for part in part::of(&text) {
        chapter.add(&part)?;
    }
    if let Some((key, value)) = chapter.note {
        bail!("no block follows `{key}: {value}`");
    }
    let to = book.join("src").join(name).with_extension("md");
    fs::create_dir_all(to.parent().context("a chapter is in a folder")?)?;
    Ok(fs::write(to, chapter.text)?)
}

/// A chapter that is being written.
struct Chapter<'a> {
    /// The folder of all chapters.
    source: &'a Path,
    /// Path in that folder, without the ending.
    name: &'a Path,
    book: &'a Path,
    /// The folder in which the commands run.
    work: PathBuf,
    /// What is written so far.
    text: String,
    /// What the last commands printed.
    printed: String,
    /// The note before a block.
    note: Option<(&'a str, &'a str)>,
}

impl<'a> Chapter<'a> {
    fn add(&mut self, part: &Part<'a>) -> anyhow::Result<()> {
        match part {
            Part::Line(line) => {
                let line = self.line(line)?;
                self.text += &format!("{line}\n");
            }
            Part::Note("prints", wanted) => ensure!(
                words(&self.printed).contains(&words(wanted)),
                "`{wanted}` is not in what the commands before it print:\n{}",
                self.printed
            ),
            Part::Note(key @ ("file" | "until"), value) => self.note = Some((key, value)),
            Part::Note(key, value) => self.text += &generated::of(key, value, &self.work)?,
            Part::Block(info, lines) => {
                let lines: String = lines.iter().map(|line| format!("{line}\n")).collect();
                self.text += &format!("```{info}\n{lines}```\n");
                match self.note.take() {
                    Some(("file", name)) => fs::write(self.work.join(name), &lines)?,
                    note if *info == "sh" => self.run(&lines, note.map(|(_, until)| until))?,
                    Some((key, _)) => bail!("`{key}` stands before a block that is not run"),
                    None => {}
                }
            }
        }
        Ok(())
    }

    fn run(&mut self, commands: &str, until: Option<&str>) -> anyhow::Result<()> {
        let printed = match until {
            None => output(commands, &self.work)?,
            Some(until) => output_until(commands, until, &self.work)?,
        };
        self.printed = printed.replace(&format!("{}/", chore::root()?.display()), "");
        if !self.printed.trim().is_empty() {
            self.text += &format!("\n```text\n{}\n```\n", self.printed.trim_end());
        }
        Ok(())
    }

    /// A line of Markdown with its plots copied into the book, and its links checked.
    fn line(&self, line: &str) -> anyhow::Result<String> {
        let mut text = line.to_string();
        for (before, rest) in line.match_indices("](").map(|(at, _)| (&line[..at], &line[at + 2..])) {
            let target = rest.split(')').next().unwrap_or_default();
            let is_plot = before.rfind('[').is_some_and(|at| before[..at].ends_with('!'));
            if is_plot {
                let name = format!("{}_{}", self.name.display(), target.replace("out/", "")).replace('/', "_");
                folder::put(&self.work.join(target), &self.book.join("src/plots").join(&name))?;
                let up = "../".repeat(self.name.components().count() - 1);
                text = text.replace(&format!("({target})"), &format!("({up}plots/{name})"));
            } else if let Some(chapter) = target.split('#').next().filter(|target| target.ends_with(".md")) {
                let file = self.source.join(self.name).with_file_name(chapter);
                ensure!(file.exists(), "this link leads to no chapter: {target}");
            }
        }
        Ok(text)
    }
}

/// `sh` in `folder`, where `gearsim` is the program beside this one.
fn reader(commands: &str, folder: &Path) -> anyhow::Result<Command> {
    let programs = std::env::current_exe()?.parent().context("a program is in a folder")?.to_path_buf();
    let path = std::env::var_os("PATH").unwrap_or_default();
    let paths = std::env::join_paths([programs].into_iter().chain(std::env::split_paths(&path)))?;
    let mut shell = shell::of(&format!("exec 2>&1\n{commands}"), folder);
    shell.env("PATH", paths);
    Ok(shell)
}

/// What commands print.
pub fn output(commands: &str, folder: &Path) -> anyhow::Result<String> {
    let output = reader(commands, folder)?.output()?;
    let printed = String::from_utf8_lossy(&output.stdout).into_owned();
    ensure!(output.status.success(), "this command failed:\n{commands}\n{printed}");
    Ok(printed)
}

/// What a command prints until it has printed `until`; then it is stopped.
fn output_until(command: &str, until: &str, folder: &Path) -> anyhow::Result<String> {
    let mut child = reader(&format!("exec {command}"), folder)?.stdout(Stdio::piped()).spawn()?;
    let mut lines = BufReader::new(child.stdout.take().context("no output")?).lines();
    let mut printed = String::new();
    while !printed.contains(until) {
        let line = lines.next().with_context(|| format!("this command ended without `{until}`:\n{command}\n{printed}"))?;
        printed += &format!("{}\n", line?);
    }
    child.kill()?;
    child.wait()?;
    Ok(printed)
}

fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
