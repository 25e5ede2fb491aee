//! The errors of commands, and their exit codes.

use std::path::{Path, PathBuf};

use super::terminal;
use crate::engine::{Refusal, Stop};
use crate::output::OutputError;
use crate::run::{Account, Outcome};
use crate::scene::SceneMistakes;
use crate::sweep::folder::Rows;
use crate::sweep::row::Status;

/// Why a command failed.
#[derive(Debug, thiserror::Error)]
pub(super) enum Failure {
    /// The command line is not valid, or asks for help.
    #[error(transparent)]
    Usage(clap::Error),
    /// The scene is not valid.
    #[error(transparent)]
    Scene(Box<SceneMistakes>),
    /// The scene is valid, but its numbers do not make a system that can be simulated.
    #[error("scene {scene} cannot be simulated: {refusal}")]
    Refused { scene: String, refusal: Refusal },
    /// The request is not possible, or names something that does not exist.
    #[error("{what}\n  help: {help}")]
    Impossible { what: String, help: String },
    /// A result could not be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// A run stopped before its end.
    #[error("{run} stopped early: {stop}\n  the results until then are in {folder}", folder = folder.display())]
    Stopped { run: String, stop: Box<Stop>, folder: PathBuf },
    /// Advice is based on a run whose energy account does not close.
    #[error("the advice is not valid, because the result of scene {scene} is wrong: {account}")]
    RefutedAdvice { scene: String, account: Account },
    /// Advice is based on a run that stopped before its end.
    #[error("the advice is that of the beginning only, because the run of scene {scene} stopped early: {stop}")]
    StoppedAdvice { scene: String, stop: String },
    /// Runs of some points of a sweep reached their ends, but their energy accounts do not close.
    #[error(
        "the results of {count} points are wrong: their energy accounts do not close\n  the rows with the status `refuted` in {folder}",
        folder = folder.display()
    )]
    RefutedPoints { count: usize, folder: PathBuf },
    /// Points of a response have no result.
    #[error("{what}\n  the other points are in {folder}", folder = folder.display())]
    Points { what: String, folder: PathBuf },
    /// A run reached its end, but its energy account does not close.
    #[error("the result of {run} is wrong: {account}\n  the results are in {folder}", folder = folder.display())]
    Refuted { run: String, account: Account, folder: PathBuf },
}

impl From<crate::library::Error> for Failure {
    fn from(error: crate::library::Error) -> Failure {
        use crate::library::Error;
        match error {
            Error::Scene(mistakes) => Failure::Scene(mistakes),
            Error::Refused { scene, refusal } => Failure::Refused { scene, refusal },
            Error::Impossible { what, help } => Failure::Impossible { what, help },
            Error::Output(error) => Failure::Output(error),
            Error::Plot(error) => Failure::Output(OutputError::format("plot", error)),
            Error::Floquet { scene, cause } => Failure::Impossible {
                what: format!("scene {scene} has no Floquet multipliers"),
                help: cause.to_string(),
            },
        }
    }
}

impl From<crate::sweep::Error> for Failure {
    fn from(error: crate::sweep::Error) -> Failure {
        match error {
            crate::sweep::Error::Scene(errors) => Failure::Scene(errors),
            crate::sweep::Error::Output(error) => Failure::Output(error),
            crate::sweep::Error::Impossible { what, help } => Failure::Impossible { what, help },
        }
    }
}

impl Failure {
    /// The error of a run whose results are in `folder`, if it stopped early or its energy account does not close.
    pub(super) fn of(run: &str, outcome: &Outcome, folder: &Path) -> Result<(), Failure> {
        let (run, folder) = (run.to_owned(), folder.to_owned());
        match (&outcome.stopped_by, outcome.refuted) {
            (Some(stop), _) => Err(Failure::Stopped { run, stop: Box::new(stop.clone()), folder }),
            (None, Some(account)) => Err(Failure::Refuted { run, account, folder }),
            (None, None) => Ok(()),
        }
    }

    /// The error of a sweep in `folder`, if the energy account of a point does not close.
    pub(super) fn of_points(rows: &Rows, folder: &Path) -> Result<(), Failure> {
        match rows.values().filter(|row| row.status == Status::Refuted).count() {
            0 => Ok(()),
            count => Err(Failure::RefutedPoints { count, folder: folder.to_owned() }),
        }
    }

    /// The exit code.
    pub(super) fn code(&self) -> u8 {
        match self {
            Failure::Usage(error) => u8::try_from(error.exit_code()).unwrap_or(2),
            Failure::Scene(_) | Failure::Refused { .. } | Failure::Impossible { .. } => 2,
            Failure::Output(_) => 1,
            Failure::Stopped { .. }
            | Failure::Refuted { .. }
            | Failure::RefutedPoints { .. }
            | Failure::Points { .. }
            | Failure::StoppedAdvice { .. }
            | Failure::RefutedAdvice { .. } => 3,
        }
    }

    /// Prints the message, and returns the exit code.
    pub(super) fn report(&self) -> u8 {
        match self {
            // If the help cannot be printed because the pipe is closed, that is no further error.
            Failure::Usage(error) => terminal::note(error.print()),
            Failure::Scene(errors) => terminal::print_err(&errors.render(terminal::width(), terminal::colours())),
            other => terminal::error(&other.to_string()),
        }
        if self.code() == 0 {
            return done();
        }
        self.code()
    }
}

/// The exit code of a command that is done: 1 if its output could not be written.
pub(super) fn done() -> u8 {
    match terminal::failed() {
        None => 0,
        Some(why) => {
            terminal::error(&format!("cannot write to stdout: {why}"));
            1
        }
    }
}
