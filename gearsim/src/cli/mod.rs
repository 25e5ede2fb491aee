//! The command line, for programs with models of their own: [`run`] is the whole of `gearsim`.

mod advise;
mod check;
mod compare;
mod completions;
mod evaluate;
mod explore;
mod failure;
mod floquet;
mod man;
mod merge;
mod models;
mod modes;
mod new;
mod page;
mod printing;
mod progress;
mod report;
mod response;
mod run;
mod scene;
mod simulate;
mod sweep;
mod terminal;
#[cfg(test)]
mod tests;
mod work_precision;

use std::ffi::OsString;
use std::process::ExitCode;

use clap::{ArgMatches, Parser};

use crate::known;
use crate::library::{files, provenance};
use crate::output::number;
use crate::run::Entry;
use failure::Failure;

/// All commands, in the order in which they are listed.
const COMMANDS: &[Command] = &[
    Command::of::<run::Run>(), //
    Command::of::<compare::Compare>(),
    Command::of::<explore::Explore>(),
    Command::of::<advise::Advise>(),
    Command::of::<sweep::SweepCommand>(),
    Command::of::<merge::Merge>(),
    Command::of::<response::ResponseCommand>(),
    Command::of::<modes::Modes>(),
    Command::of::<floquet::FloquetCommand>(),
    Command::of::<work_precision::WorkPrecision>(),
    Command::of::<check::Check>(),
    Command::of::<scene::SceneCommand>(),
    Command::of::<models::Models>(),
    Command::of::<new::New>(),
    Command::of::<completions::Completions>(),
    Command::of::<man::ManCommand>(),
];

/// A command: its description for clap, and the function that runs it.
struct Command {
    describe: fn() -> clap::Command,
    run: fn(&ArgMatches) -> Result<(), Failure>,
}

/// Implemented by the arguments of each command. The name, the help and the arguments come from clap's derive.
trait Verb: Parser {
    /// Runs the command.
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
/// gearsim reads a scene: a small TOML file with the model of a gear system, its effects, its numbers
/// and its start. Between two steps of the mesh stiffness the motion is solved exactly. No step is
/// missed; the speeds after it follow from a jump rule that conserves energy. Every run ends with its
/// energy account.
#[derive(Parser)]
#[command(name = "gearsim", version, subcommand_required = true, arg_required_else_help = true)]
#[command(
    verbatim_doc_comment,
    after_help = "\
Examples:
  gearsim scene gear_pair > pair.toml
      a scene of a model, ready to run
  gearsim run pair.toml
      run it; results and plots go to out/pair
  gearsim compare pair.toml
      the same scene under the exact equations and two common approximations
  gearsim models gear_pair
      what a scene of this model can set, and its equations

Exit codes:
  0  done
  1  results could not be written
  2  refused: the command line, the scene or its numbers are not valid; nothing was run
  3  a run stopped before its end, or its energy account does not close; its results are written"
)]
struct Program {
    #[command(flatten)]
    #[allow(dead_code, reason = "each command reads it among its own arguments")]
    quiet: printing::Quiet,
}

/// The whole command line.
fn program() -> clap::Command {
    let program = <Program as clap::CommandFactory>::command();
    COMMANDS.iter().fold(program, |program, command| program.subcommand((command.describe)()))
}

/// Runs the program with the arguments of the process, and returns its exit code. The program knows the models `own` besides those of
/// gearsim. The command line of a crate with its own models is
///
/// ```ignore
/// fn main() -> std::process::ExitCode {
///     gearsim::cli::run(&[Entry::new::<my_train::MyTrain>()])
/// }
/// ```
pub fn run(own: &[Entry]) -> ExitCode {
    run_with(own, std::env::args_os())
}

/// As [`run()`], with the given arguments; the first is the name of the program.
pub fn run_with(own: &[Entry], arguments: impl IntoIterator<Item = impl Into<OsString> + Clone>) -> ExitCode {
    ExitCode::from(status(own, arguments))
}

/// As [`run_with`]; returns the exit code as a number.
pub fn status(own: &[Entry], arguments: impl IntoIterator<Item = impl Into<OsString> + Clone>) -> u8 {
    known::add(own);
    let result = program().try_get_matches_from(arguments).map_err(Failure::Usage).and_then(|matches| {
        let given = |command: &&Command| matches.subcommand_name() == Some((command.describe)().get_name());
        let command = COMMANDS.iter().find(given).zip(matches.subcommand());
        command.map_or(Ok(()), |(command, (_, matches))| (command.run)(matches))
    });
    match result {
        Ok(()) => failure::done(),
        Err(failure) => failure.report(),
    }
}
