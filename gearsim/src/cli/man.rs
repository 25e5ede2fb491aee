//! `gearsim man`: the manual pages.

use std::path::PathBuf;

use clap::Parser;
use clap_mangen::Man;

use super::failure::Failure;
use super::printing::Quiet;
use super::{Verb, program, terminal};
use crate::output::{OutputError, OutputFolder};

/// Write manual pages for `man`: one of the program, one a command
#[derive(Parser)]
#[command(
    name = "man",
    after_help = "\
Examples:
  gearsim man ~/.local/share/man/man1"
)]
pub(super) struct ManCommand {
    /// Folder for the pages; created if missing
    folder: PathBuf,
    #[command(flatten)]
    quiet: Quiet,
}

impl Verb for ManCommand {
    fn run(self) -> Result<(), Failure> {
        let mut program = program();
        program.build();
        let mut files = OutputFolder::create(&self.folder)?;
        page(&mut files, "gearsim".into(), &program)?;
        for command in program.get_subcommands() {
            page(&mut files, format!("gearsim-{}", command.get_name()), command)?;
        }
        files.commit("gearsim.1")?;
        if !self.quiet.quiet {
            terminal::print_out(&format!("{} pages in {}\n", files.files().len(), self.folder.display()));
        }
        Ok(())
    }
}

/// Writes the page of a command.
fn page(files: &mut OutputFolder, name: String, command: &clap::Command) -> Result<(), OutputError> {
    files.write(&format!("{name}.1"), |sink| Ok(Man::new(command.clone()).title(name).render(sink)?))
}
