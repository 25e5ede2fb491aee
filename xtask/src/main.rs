//! The project's chores: `cargo xtask VERB`. One verb, one file.

mod derive;
mod hard_cases;
mod oh2005;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

/// The project's chores.
#[derive(Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask")]
struct Arguments {
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Subcommand)]
enum Verb {
    /// Derive equations, jump rules and proofs from the energies in models/src, into gearsim/src/generated.
    Derive(derive::Derive),
    /// Run the hard cases of the engine; write their table to tests/hard-cases.md.
    HardCases(hard_cases::HardCases),
    /// Run the paper's cases again: plots and tables of models/scenes/oh2005.
    Oh2005(oh2005::Oh2005),
}

fn main() -> ExitCode {
    let done = match Arguments::parse().verb {
        Verb::Derive(verb) => verb.run(),
        Verb::HardCases(verb) => verb.run(),
        Verb::Oh2005(verb) => verb.run(),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}
