//! The command-line program `gearsim`.

use std::process::ExitCode;

fn main() -> ExitCode {
    gearsim::cli::run(&[])
}
