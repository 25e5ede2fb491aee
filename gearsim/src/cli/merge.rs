//! `gearsim merge`: joins the shards of a sweep.

use std::path::PathBuf;

use clap::Parser;

use super::failure::Failure;
use super::sweep::{PlotOptions, summary_text};
use super::{Verb, known, terminal};
use crate::output::OutputFolder;
use crate::sweep::folder;
use crate::sweep::{manifest, merge};

/// Join the shards of a sweep that ran on several machines
#[derive(Parser)]
#[command(
    name = "merge",
    after_help = "\
Refuses shards of different sweeps. Refuses shards in which points are missing or occur twice, and
lists these points. The result is the same, byte for byte, as if one machine had run all points.

Example:
  gearsim merge shard1 shard2 shard3 --out whole --map phi_max"
)]
pub(super) struct Merge {
    /// Folders written by `gearsim sweep --shard`
    #[arg(required = true, value_name = "DIR")]
    folders: Vec<PathBuf>,
    /// Folder for the joined results
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    #[command(flatten)]
    plots: PlotOptions,
    /// Print nothing but warnings and errors
    #[arg(long, short)]
    quiet: bool,
}

impl Verb for Merge {
    fn run(self) -> Result<(), Failure> {
        merge::refuse_input(&self.folders, &self.out)?;
        OutputFolder::probe(&self.out)?;
        let (manifest, layout, rows) = merge::gather(&self.folders, known::models())?;
        self.plots.check(&layout)?;
        merge::write(&self.out, &manifest, &layout, &rows)?;
        let mut files = vec![folder::ROWS.to_owned(), manifest::FILE.to_owned()];
        files.extend(self.plots.draw(&self.out, &manifest, &layout, &rows)?);
        if !self.quiet {
            terminal::print_out(&summary_text(&self.out, &files, &manifest, &rows, None));
        }
        Failure::of_points(&rows, &self.out)
    }
}
