//! `gearsim completions`: completion of commands and options in shells.

use clap::Parser;
use clap_complete::Shell;

use super::failure::Failure;
use super::{Verb, program, terminal};

/// Print a script by which a shell completes commands and options
#[derive(Parser)]
#[command(
    name = "completions",
    after_help = "\
Examples:
  gearsim completions bash > ~/.local/share/bash-completion/completions/gearsim
  gearsim completions zsh > ~/.zfunc/_gearsim
  gearsim completions fish > ~/.config/fish/completions/gearsim.fish"
)]
pub(super) struct Completions {
    /// The shell
    shell: Shell,
}

impl Verb for Completions {
    fn run(self) -> Result<(), Failure> {
        let mut script = vec![];
        clap_complete::generate(self.shell, &mut program(), "gearsim", &mut script);
        terminal::print_out(&String::from_utf8_lossy(&script));
        Ok(())
    }
}
