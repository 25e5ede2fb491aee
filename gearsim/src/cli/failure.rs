//! Why a command could not do what it was asked, and the exit code that says so.

use std::path::PathBuf;
use std::process::ExitCode;

use super::terminal;
use crate::engine::{Refusal, Stop};
use crate::output::OutputError;
use crate::scene::SceneErrors;

/// Why a command failed.
#[derive(Debug, thiserror::Error)]
pub(super) enum Failure {
    /// The command line makes no sense, or asks for help.
    #[error(transparent)]
    Usage(clap::Error),
    /// The scene makes no sense.
    #[error(transparent)]
    Scene(Box<SceneErrors>),
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
    /// The exit code.
    pub(super) fn code(&self) -> u8 {
        match self {
            Failure::Usage(error) => u8::try_from(error.exit_code()).unwrap_or(2),
            Failure::Scene(_) | Failure::Refused { .. } | Failure::Impossible { .. } => 2,
            Failure::Output(_) => 1,
            Failure::Stopped { .. } => 3,
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
