//! The development commands of this project: `cargo xtask VERB`. One file for each verb.

mod chore;
mod combinations;
mod costs;
mod coverage;
mod derivation_costs;
mod derive;
mod fuzz;
mod gallery;
mod hard_cases;
mod instructions;
mod manual;
mod oh2005;
mod peers;
mod published;
mod shell;
mod soak;
mod suite;
mod tutorial;
mod work_precision;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

/// The development commands of this project.
#[derive(Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask")]
struct Arguments {
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Subcommand)]
enum Verb {
    /// Run random scenes with random sets of effects, and check what must hold of each.
    Combinations(combinations::Combinations),
    /// Measure run time, memory and compile time against the number of coordinates; write them to tests/costs.md.
    Costs(costs::Costs),
    /// Run every effect of every model under every command; write the table to tests/coverage.md.
    Coverage(coverage::Coverage),
    /// Count the instructions of derivations with their proofs under valgrind; write them to tests/derivation-costs.md.
    DerivationCosts(derivation_costs::DerivationCosts),
    /// Derive equations, jump rules and proofs from the energies in models/src, into gearsim/generated/src.
    Derive(derive::Derive),
    /// Run the hard cases of the engine; write their table to tests/hard-cases.md.
    HardCases(hard_cases::HardCases),
    /// Compare the models with published numbers; write their table to tests/published.md.
    Published(published::Published),
    /// Run the example scenes; write a plot of each to models/scenes/plots.
    Gallery(gallery::Gallery),
    /// Search for inputs that break the scene reader or the engine; needs a C++ compiler.
    Fuzz(fuzz::Fuzz),
    /// Count the instructions of the main code paths under valgrind; write them to tests/instructions.md.
    Instructions(instructions::Instructions),
    /// Run the commands of the manual's chapters, and write the book with what they print and plot.
    Manual(manual::Manual),
    /// Run the cases of Oh, Grosh & Barber (2005) again; write the plots and tables of models/scenes/oh2005.
    Oh2005(oh2005::Oh2005),
    /// Run other tools on our scenes; write their errors, times and missed events to tests/peers.md.
    Peers(peers::Peers),
    /// Run very many events without damping; write how the energy error grows to out/soak.
    Soak(soak::Soak),
    /// Make a crate for models of one's own, and follow its README word for word.
    Tutorial(tutorial::Tutorial),
    /// Measure time against error on the scenes of the paper; write plots and tables into the READMEs.
    WorkPrecision(work_precision::WorkPrecision),
}

fn main() -> ExitCode {
    if let Some(code) = fuzz::compile() {
        return code;
    }
    let done = match Arguments::parse().verb {
        Verb::Combinations(verb) => verb.run(),
        Verb::Costs(verb) => verb.run(),
        Verb::Coverage(verb) => verb.run(),
        Verb::DerivationCosts(verb) => verb.run(),
        Verb::Derive(verb) => verb.run(),
        Verb::HardCases(verb) => verb.run(),
        Verb::Published(verb) => verb.run(),
        Verb::Fuzz(verb) => verb.run(),
        Verb::Gallery(verb) => verb.run(),
        Verb::Instructions(verb) => verb.run(),
        Verb::Manual(verb) => verb.run(),
        Verb::Oh2005(verb) => verb.run(),
        Verb::Peers(verb) => verb.run(),
        Verb::Soak(verb) => verb.run(),
        Verb::Tutorial(verb) => verb.run(),
        Verb::WorkPrecision(verb) => verb.run(),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}
