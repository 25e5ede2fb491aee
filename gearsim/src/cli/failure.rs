//! Why a command could not do what it was asked, and the exit code that says so.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use super::terminal;
use crate::engine::{Refusal, Stop};
use crate::output::OutputError;
use crate::run::{Account, Outcome};
use crate::scene::SceneMistakes;

/// Why a command failed.
#[derive(Debug, thiserror::Error)]
pub(super) enum Failure {
    /// The command line makes no sense, or asks for help.
    #[error(transparent)]
    Usage(clap::Error),
    /// The scene makes no sense.
    #[error(transparent)]
    Scene(Box<SceneMistakes>),
    /// The scene's numbers make no system that can be simulated.
    #[error("scene {scene} cannot be simulated: {refusal}")]
    Refused { scene: String, refusal: Refusal },
    /// What is asked for is not there or not possible.
    #[error("{what}\n  help: {help}")]
    Impossible { what: String, help: String },
    /// A result could not be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// A run stopped before its end.
    #[error("{run} stopped early: {stop}\n  what was computed until then is in {folder}", folder = folder.display())]
    Stopped { run: String, stop: Box<Stop>, folder: PathBuf },
    /// A run came to its end, and its energy account does not close.
    #[error("the result of {run} is wrong: {account}\n  what was computed is in {folder}", folder = folder.display())]
    Refuted { run: String, account: Account, folder: PathBuf },
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
    /// Whether a run whose results are in `folder` failed.
    pub(super) fn of(run: &str, outcome: &Outcome, folder: &Path) -> Result<(), Failure> {
        let (run, folder) = (run.to_owned(), folder.to_owned());
        match (&outcome.stopped_by, outcome.refuted) {
            (Some(stop), _) => Err(Failure::Stopped { run, stop: Box::new(stop.clone()), folder }),
            (None, Some(account)) => Err(Failure::Refuted { run, account, folder }),
            (None, None) => Ok(()),
        }
    }

    /// The exit code.
    pub(super) fn code(&self) -> u8 {
        match self {
            Failure::Usage(error) => u8::try_from(error.exit_code()).unwrap_or(2),
            Failure::Scene(_) | Failure::Refused { .. } | Failure::Impossible { .. } => 2,
            Failure::Output(_) => 1,
            Failure::Stopped { .. } | Failure::Refuted { .. } => 3,
        }
    }

    /// Says what is wrong, and gives the exit code.
    pub(super) fn report(&self) -> ExitCode {
        match self {
            // A reader that has gone away needs no help.
            Failure::Usage(error) => drop(error.print()),
            Failure::Scene(errors) => terminal::complain(&errors.render(terminal::width(), terminal::colours())),
            other => terminal::complain(&terminal::wrap(&format!("error: {other}"), terminal::width())),
        }
        ExitCode::from(self.code())
    }
}
