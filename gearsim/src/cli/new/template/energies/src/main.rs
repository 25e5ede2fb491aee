//! `cargo derive`: derives the models and writes their files to `src/generated`.

use std::path::Path;

fn main() -> std::process::ExitCode {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../src/generated");
    gearsim_derive::program(energies::MODELS, &folder, energies::HOME)
}
