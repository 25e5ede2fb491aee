//! `cargo xtask manual`: run the commands of the manual's chapters, and write the book with what they print and plot.
//!
//! The chapters are in gearsim/manual/src. The book is Markdown with SVG, for any reader of Markdown and for `mdbook build`. What a
//! chapter may contain besides Markdown: [`chapter`].

mod chapter;
mod folder;
mod generated;
mod part;

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
}

impl Manual {
    /// Builds the program in the dev profile, and runs the chapters one after another, each in a fresh folder.
    ///
    /// # Errors
    /// At the first chapter of which a command fails, or a plot, a text or a linked chapter is missing.
    pub fn run(&self) -> anyhow::Result<()> {
        let root = chore::root()?;
        let source = root.join("gearsim/manual");
        let book = root.join(&self.folder);
        if book.starts_with(root.join("target")) && book.exists() {
            fs::remove_dir_all(&book).context("cannot remove the book of an earlier run")?;
        }
        ensure!(!book.exists(), "{} exists already: give a folder that does not", book.display());
        build(root)?;
        folder::copy(&source, &book, &|file| file.extension().is_none_or(|end| end != "md") || is(file, "SUMMARY"))?;
        for path in folder::files(&source.join("src"))? {
            let name = path.strip_prefix(source.join("src"))?.with_extension("");
            let wanted = self.only.as_ref().is_none_or(|only| name.to_string_lossy().contains(only));
            if path.extension().is_none_or(|end| end != "md") || is(&path, "SUMMARY") || !wanted {
                continue;
            }
            let start = Instant::now();
            chapter::write(&source.join("src"), &name, &book).with_context(|| format!("in {}", path.display()))?;
            println!("{:5.1} s  {}", start.elapsed().as_secs_f64(), name.display());
        }
        println!("{}", book.display());
        Ok(())
    }
}

fn is(file: &Path, stem: &str) -> bool {
    file.file_stem().is_some_and(|found| found == stem)
}

/// Builds the program that the chapters call, with interactive pages. It is then beside this program.
fn build(root: &Path) -> anyhow::Result<()> {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--quiet", "--locked", "--package", "gearsim", "--features", "html"]);
    ensure!(cargo.current_dir(root).status().context("cannot start cargo")?.success(), "gearsim does not build");
    Ok(())
}
