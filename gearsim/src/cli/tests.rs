//! Tests of the commands, called directly without a built program.

mod advise;
mod faults;
mod manual;
mod page;
mod refusals;
mod remarks;
mod runs;
mod starters;
mod sweeps;
mod texts;

use std::path::{Path, PathBuf};

use clap::Parser;

use super::Verb;
use super::failure::Failure;

/// The scene that most tests run.
fn scene() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes/oh2005/energy_300rpm.toml")
}

/// Runs the command `V` on the scene with `--out out` and further arguments.
fn go<V: Verb + Parser>(out: &Path, arguments: &[&str]) -> Result<(), Failure> {
    let (scene, out) = (scene().display().to_string(), out.display().to_string());
    let all = ["gearsim", &scene, "--out", &out].into_iter().chain(arguments.iter().copied());
    V::try_parse_from(all).map_err(Failure::Usage).and_then(V::run)
}
