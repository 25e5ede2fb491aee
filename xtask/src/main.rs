//! The project's chores: `cargo xtask VERB`. One verb, one file.

mod derive;
mod fuzz;
mod hard_cases;
mod oh2005;
mod soak;

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
    /// Look for inputs that break the scene reader or the engine; needs a C++ compiler.
    Fuzz(fuzz::Fuzz),
    /// Run the paper's cases again: plots and tables of models/scenes/oh2005.
    Oh2005(oh2005::Oh2005),
    /// Run very many events without damping: how the energy error grows, into out/soak.
    Soak(soak::Soak),
}

fn main() -> ExitCode {
    if let Some(code) = fuzz::compile() {
        return code;
    }
    let done = match Arguments::parse().verb {
        Verb::Derive(verb) => verb.run(),
        Verb::HardCases(verb) => verb.run(),
        Verb::Fuzz(verb) => verb.run(),
        Verb::Oh2005(verb) => verb.run(),
        Verb::Soak(verb) => verb.run(),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}
