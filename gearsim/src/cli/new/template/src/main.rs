//! The command line of gearsim with the models of this crate.

fn main() -> std::process::ExitCode {
    gearsim::cli::run(my_axle::generated::MODELS)
}
