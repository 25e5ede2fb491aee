//! The derivation program behind `cargo xtask derive`, the only program of this repository that runs the computer algebra system.

use std::path::Path;
use std::process::ExitCode;

use gearsim_derive::{Home, program};
use gearsim_models::{ELEMENTS, MODELS};

fn main() -> ExitCode {
    let models = [MODELS, ELEMENTS].concat();
    program(&models, &Path::new(env!("CARGO_MANIFEST_DIR")).join("../gearsim/generated/src"), Home::default())
}
