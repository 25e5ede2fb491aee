//! The scenes of `cargo xtask peers` with their references in 50 digits, and our own runs of them.
//!
//! `peers scenes` writes all numbers of all scenes as JSON, so that no other tool has a copy of them in its source. `peers run
//! METHOD SCENE` runs one of our methods on one scene, and prints JSON of the same form as the other tools in `tests/peers`.

mod case;
mod reference;
mod solve;

use std::path::PathBuf;

use clap::{Parser, Subcommand};
use serde_json::json;

use case::CASES;

/// Scenes and references for the peers, and our own runs.
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
        /// `gearsim`, `hand-written`, or `hand-written, fast`.
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
