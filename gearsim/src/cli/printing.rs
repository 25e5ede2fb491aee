//! What a command prints on the standard output: a report, its results as JSON, or nothing.

use clap::Args;

use super::failure::Failure;
use super::terminal;

/// The option that all commands have. `models`, `scene` and `completions` print with it too, because the text is their result.
#[derive(Args)]
pub(super) struct Quiet {
    /// Print no report and no progress; warnings and errors remain
    #[arg(long, short, global = true)]
    pub(super) quiet: bool,
}

/// The options that choose what is printed.
#[derive(Args)]
pub(super) struct Printing {
    /// Print the results as JSON, in SI units, instead of the report
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    quiet: Quiet,
}

impl Printing {
    /// Whether progress is not shown.
    pub(super) fn quiet(&self) -> bool {
        self.quiet.quiet
    }

    /// Writes remarks on results to stderr if neither a report nor JSON has them.
    pub(super) fn warn<'a>(&self, remarks: impl Iterator<Item = &'a String>) {
        if self.quiet() && !self.json {
            remarks.for_each(|remark| terminal::warn(remark));
        }
    }

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
        match (self.json, self.quiet()) {
            (true, _) => terminal::print_out(&json()?),
            (false, true) => {}
            (false, false) => terminal::print_out(&text()),
        }
        Ok(())
    }
}
