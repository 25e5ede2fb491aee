//! What a command prints on the standard output: a text, its results as JSON, or nothing.

use clap::Args;

use super::failure::Failure;
use super::terminal;

/// The options that choose what is printed.
#[derive(Args)]
pub(super) struct Printing {
    /// Print the results as JSON, in SI units, instead of the text
    #[arg(long, conflicts_with = "quiet")]
    json: bool,
    /// Print nothing but warnings and errors
    #[arg(long, short)]
    pub(super) quiet: bool,
}

impl Printing {
    /// Prints the results.
    ///
    /// # Errors
    /// Those of `json`.
    pub(super) fn print<E>(
        &self,
        json: impl FnOnce() -> Result<String, E>,
        text: impl FnOnce() -> String,
    ) -> Result<(), Failure>
    where
        Failure: From<E>,
    {
        match (self.json, self.quiet) {
            (true, _) => terminal::print_out(&json()?),
            (false, true) => {}
            (false, false) => terminal::print_out(&text()),
        }
        Ok(())
    }
}
