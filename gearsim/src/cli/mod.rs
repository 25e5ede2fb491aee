//! The command line: one file and one line of [`COMMANDS`] a command.

mod advise;
mod compare;
mod failure;
mod files;
mod floquet;
mod merge;
mod models;
mod modes;
mod number;
mod progress;
mod provenance;
mod report;
mod run;
mod simulate;
mod sweep;
mod terminal;
#[cfg(test)]
mod tests;
mod work_precision;

use std::process::ExitCode;

use clap::{ArgMatches, Parser};

use failure::Failure;

/// All commands, in the order in which they are listed.
const COMMANDS: &[Command] = &[
    Command::of::<run::Run>(), //
    Command::of::<compare::Compare>(),
    Command::of::<advise::Advise>(),
    Command::of::<sweep::SweepCommand>(),
    Command::of::<merge::Merge>(),
    Command::of::<modes::Modes>(),
    Command::of::<floquet::Floquets>(),
    Command::of::<work_precision::WorkPrecision>(),
    Command::of::<models::Models>(),
];

/// A command as the program knows it.
struct Command {
    describe: fn() -> clap::Command,
    run: fn(&ArgMatches) -> Result<(), Failure>,
}

/// What a command's arguments can do. Its name, its help and its arguments come from the derive of clap.
trait Verb: Parser {
    /// Does it.
    fn run(self) -> Result<(), Failure>;
}

impl Command {
    const fn of<V: Verb>() -> Command {
        Command {
            describe: V::command,
            run: |matches| V::from_arg_matches(matches).map_err(Failure::Usage).and_then(V::run),
        }
    }
}

/// Simulates gear systems without creating or losing energy
///
/// gearsim reads a scene, a small TOML file: which model of a gear system, which effects it has, its
/// numbers, its start. Between two steps of the mesh stiffness the motion is solved exactly; every
/// step is found for certain, and passed by a jump rule that conserves energy. Every run ends with
/// the account of its energy.
#[derive(Parser)]
#[command(name = "gearsim", version, subcommand_required = true, arg_required_else_help = true)]
#[command(
    verbatim_doc_comment,
    after_help = "\
Examples, from the root of the repository:
  cargo run --release -- run models/scenes/oh2005/energy_300rpm.toml
      run a scene; results and plots go to out/energy_300rpm
  cargo run --release -- compare models/scenes/oh2005/energy_300rpm.toml
      the same under the exact equations and two usual approximations
  cargo run --release -- models gear_pair
      what a scene of this model can set

Exit codes:
  0  done
  1  results could not be written
  2  refused: the command line, the scene or its numbers make no sense; nothing was run
  3  a run stopped before its end; what it computed until then is written"
)]
struct Program;

/// The whole command line.
fn program() -> clap::Command {
    let program = <Program as clap::CommandFactory>::command();
    COMMANDS.iter().fold(program, |program, command| program.subcommand((command.describe)()))
}

/// Runs the program on the arguments it was given.
pub fn main() -> ExitCode {
    let result = program().try_get_matches().map_err(Failure::Usage).and_then(|matches| {
        let given = |command: &&Command| matches.subcommand_name() == Some((command.describe)().get_name());
        let command = COMMANDS.iter().find(given).zip(matches.subcommand());
        command.map_or(Ok(()), |(command, (_, matches))| (command.run)(matches))
    });
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}
