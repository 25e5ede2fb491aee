//! A chapter, with the output and the plots of its commands.
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
use std::path::Path;

use anyhow::{Context, bail, ensure};

use super::part::{self, Part};
use super::reader::Reader;
use super::{Book, folder, generated};
use crate::chore;

/// Runs the chapter `name` of a book, and writes it.
pub fn write(book: &Book, name: &Path) -> anyhow::Result<()> {
    let text = fs::read_to_string(book.source.join(name).with_extension("md"))?;
    let reader = Reader::new(book, name)?;
    let mut chapter = Chapter { book, name, reader, text: String::new(), printed: String::new(), note: None };
    for part in part::of(&text) {
        chapter.add(&part)?;
    }
    if let Some((key, value)) = chapter.note {
        bail!("no block follows `{key}: {value}`");
    }
    let to = book.folder.join("src").join(name).with_extension("md");
    fs::create_dir_all(to.parent().context("a chapter is in a folder")?)?;
    Ok(fs::write(to, chapter.text)?)
}

/// A chapter that is being written.
struct Chapter<'a> {
    book: &'a Book,
    /// Path in the folder of the chapters, without the ending.
    name: &'a Path,
    /// Runs the commands.
    reader: Reader,
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
            Part::Note(key, value) => self.text += &generated::of(key, value, &self.reader)?,
            Part::Block(info, lines) => {
                let lines: String = lines.iter().map(|line| format!("{line}\n")).collect();
                self.text += &format!("```{info}\n{lines}```\n");
                match self.note.take() {
                    Some(("file", name)) => fs::write(self.reader.folder.join(name), &lines)?,
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
            None => self.reader.output(commands)?,
            Some(until) => self.reader.output_until(commands, until)?,
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
                folder::put(&self.reader.folder.join(target), &self.book.folder.join("src/plots").join(&name))?;
                let up = "../".repeat(self.name.components().count() - 1);
                text = text.replace(&format!("({target})"), &format!("({up}plots/{name})"));
            } else if let Some(chapter) = target.split('#').next().filter(|target| target.ends_with(".md")) {
                let file = self.book.source.join(self.name).with_file_name(chapter);
                ensure!(file.exists(), "this link leads to no chapter: {target}");
            }
        }
        Ok(text)
    }
}

fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
