//! `gearsim merge`: joins the shards of a sweep.

use std::path::PathBuf;

use clap::Parser;

use super::failure::Failure;
use super::printing::Printing;
use super::sweep::Evaluation;
use super::{Verb, known};
use crate::output::OutputFolder;
use crate::sweep::merge;

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
    evaluation: Evaluation,
    #[command(flatten)]
    printing: Printing,
}

impl Verb for Merge {
    fn run(self) -> Result<(), Failure> {
        merge::refuse_input(&self.folders, &self.out)?;
        OutputFolder::probe(&self.out)?;
        let (manifest, layout, rows) = merge::gather(&self.folders, known::models())?;
        self.evaluation.check(&layout)?;
        merge::write(&self.out, &manifest, &layout, &rows)?;
        self.evaluation.finish(&self.out, &manifest, &layout, &rows, None, &self.printing)?;
        Failure::of_points(&rows, &self.out)
    }
}
