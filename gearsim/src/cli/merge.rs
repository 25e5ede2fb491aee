//! `gearsim merge`: the shards of a sweep, joined.

use std::path::PathBuf;

use clap::Parser;

use super::failure::Failure;
use super::sweep::{Pictures, said};
use super::{Verb, terminal};
use crate::generated::MODELS;
use crate::output::OutputFolder;
use crate::sweep::folder;
use crate::sweep::{manifest, merge};

/// Join the shards of a sweep, which may have run on many machines
#[derive(Parser)]
#[command(
    name = "merge",
    after_help = "\
Refuses shards of different sweeps, and shards that lack a point or have one twice; it says which.
The result is the same, byte for byte, as if one machine had run all points.

Example:
  gearsim merge shard1 shard2 shard3 --out whole --map phi_max"
)]
pub(super) struct Merge {
    /// Folders that `gearsim sweep --shard` has filled
    #[arg(required = true, value_name = "DIR")]
    folders: Vec<PathBuf>,
    /// Folder for the whole
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    #[command(flatten)]
    pictures: Pictures,
    /// Say nothing unless something is wrong
    #[arg(long, short)]
    quiet: bool,
}

impl Verb for Merge {
    fn run(self) -> Result<(), Failure> {
        OutputFolder::probe(&self.out)?;
        let (manifest, layout, rows) = merge::gather(&self.folders, MODELS)?;
        self.pictures.check(&layout)?;
        merge::write(&self.out, &manifest, &layout, &rows)?;
        let mut files = vec![folder::ROWS.to_owned(), manifest::FILE.to_owned()];
        files.extend(self.pictures.draw(&self.out, &manifest, &layout, &rows)?);
        if !self.quiet {
            terminal::say(&said(&self.out, &files, &manifest, &rows, None));
        }
        Ok(())
    }
}
