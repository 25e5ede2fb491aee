//! The program.

use std::process::ExitCode;

fn main() -> ExitCode {
    gearsim::cli::main()
}
