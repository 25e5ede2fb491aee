//! What `cargo xtask peers` needs of Rust: the scenes with their reference in 50 and more digits, and our own times.
//!
//! `peers scenes` writes every number of every scene as JSON, so that no peer types one; `peers run METHOD SCENE` runs
//! one method on one of them and prints what the peers in `tests/peers` print too.

mod case;
mod reference;
mod solve;

use std::path::PathBuf;

use clap::{Parser, Subcommand};
use serde_json::json;

use case::CASES;

/// Scenes and references for the peers, and our own runs of them.
#[derive(Parser)]
struct Arguments {
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Subcommand)]
enum Verb {
    /// Write the scenes and their references.
    Scenes {
        /// A tenth of the events.
        #[arg(long)]
        quick: bool,
        /// File to write.
        #[arg(long)]
        out: PathBuf,
    },
    /// Run one method on one scene.
    Run {
        /// A tenth of the events.
        #[arg(long)]
        quick: bool,
        /// `gearsim`, `hand-written` or `hand-written, fast`.
        method: String,
        /// Name of the scene.
        scene: String,
    },
}

fn main() -> anyhow::Result<()> {
    match Arguments::parse().verb {
        Verb::Scenes { quick, out } => {
            let scenes = CASES.iter().map(|case| reference::of(case, quick)).collect::<anyhow::Result<Vec<_>>>()?;
            std::fs::write(&out, format!("{:#}\n", json!(scenes)))?;
        }
        Verb::Run { quick, method, scene } => println!("{}", solve::run(&method, case::named(&scene)?, quick)?),
    }
    Ok(())
}
