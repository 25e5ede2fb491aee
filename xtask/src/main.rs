//! The project's chores: `cargo xtask VERB`. One verb, one file.

mod derive;

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
}

fn main() -> anyhow::Result<()> {
    match Arguments::parse().verb {
        Verb::Derive(verb) => verb.run(),
    }
}
