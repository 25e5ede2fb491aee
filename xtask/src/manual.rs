//! `cargo xtask manual`: run the commands of the manual's chapters, and write the book with what they print and plot.
//!
//! The chapters are in gearsim/manual/src. The book is Markdown with SVG, for any reader of Markdown and for `mdbook build`. What a
//! chapter may contain besides Markdown: [`chapter`].

mod chapter;
mod folder;
mod generated;
mod part;
mod reader;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use anyhow::{Context, ensure};

use super::chore;

/// Run the commands of the manual's chapters, and write the book with what they print and plot.
#[derive(clap::Args)]
pub struct Manual {
    /// Folder for the book; `mdbook build FOLDER` makes HTML of it.
    #[arg(long, default_value = "target/manual")]
    folder: PathBuf,
    /// Only chapters whose path contains this text; the other chapters are left out of the book.
    #[arg(long)]
    only: Option<String>,
    /// Program to run in place of the one that this command builds; it must have the feature `html`.
    #[arg(long)]
    program: Option<PathBuf>,
}

/// A book that is being written.
struct Book {
    /// The folder of the chapters.
    source: PathBuf,
    /// The folder of the book.
    folder: PathBuf,
    /// The folder of the program.
    programs: PathBuf,
}

impl Manual {
    /// Builds the program in the dev profile, and runs the chapters one after another, each in a fresh folder.
    ///
    /// # Errors
    /// At the first chapter in which a command fails, or a plot, a text or a linked chapter is missing.
    pub fn run(&self) -> anyhow::Result<()> {
        let root = chore::root()?;
        let manual = root.join("gearsim/manual");
        let folder = root.join(&self.folder);
        if folder.starts_with(root.join("target")) && folder.exists() {
            fs::remove_dir_all(&folder).context("cannot remove the book of an earlier run")?;
        }
        ensure!(!folder.exists(), "{} exists already: give a folder that does not", folder.display());
        let program = self.program.as_ref().map_or_else(|| build(root), |program| Ok(program.canonicalize()?))?;
        let programs = program.parent().context("a program is in a folder")?.to_path_buf();
        folder::copy(&manual, &folder, &|file| !is_chapter(file))?;
        let book = Book { source: manual.join("src"), folder, programs };
        for path in folder::files(&book.source)?.into_iter().filter(|file| is_chapter(file)) {
            let name = path.strip_prefix(&book.source)?.with_extension("");
            if self.only.as_ref().is_some_and(|only| !name.to_string_lossy().contains(only)) {
                continue;
            }
            let start = Instant::now();
            chapter::write(&book, &name).with_context(|| format!("in {}", path.display()))?;
            println!("{:5.1} s  {}", start.elapsed().as_secs_f64(), name.display());
        }
        println!("{}", book.folder.display());
        Ok(())
    }
}

/// Whether a file of the manual is a chapter: the table of contents has no commands.
fn is_chapter(file: &Path) -> bool {
    file.extension().is_some_and(|end| end == "md") && file.file_stem().is_some_and(|stem| stem != "SUMMARY")
}

/// Builds the program that the chapters call, with interactive pages, in the profile of this program. It is then in the folder of this
/// program.
fn build(root: &Path) -> anyhow::Result<PathBuf> {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--quiet", "--locked", "--package", "gearsim", "--features", "html"]);
    ensure!(cargo.current_dir(root).status().context("cannot start cargo")?.success(), "gearsim does not build");
    Ok(std::env::current_exe()?.with_file_name(format!("gearsim{}", std::env::consts::EXE_SUFFIX)))
}
