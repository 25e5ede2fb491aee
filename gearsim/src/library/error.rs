//! The error of everything that a program can ask of the library.

use std::fmt;

use crate::analysis::floquet::FloquetError;
use crate::engine::Refusal;
use crate::output::OutputError;
use crate::plot::PlotError;
use crate::scene::SceneMistakes;
use crate::sweep;

/// Why the library could not do what a program asked for. Its text says what is wrong, where, and what to do.
#[derive(thiserror::Error)]
pub enum Error {
    /// The scene has mistakes. The text shows each with the line in which it is.
    #[error("{}", .0.render(100, false).trim_end())]
    Scene(Box<SceneMistakes>),
    /// The scene is valid, but its numbers do not make a system that can be simulated.
    #[error("scene {scene} cannot be simulated: {refusal}")]
    Refused {
        /// Name of the scene.
        scene: String,
        /// The cause.
        refusal: Refusal,
    },
    /// The request is not possible, or names something that does not exist.
    #[error("{what}\n  help: {help}")]
    Impossible {
        /// What is wrong.
        what: String,
        /// What to do.
        help: String,
    },
    /// A file could not be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// A plot could not be drawn.
    #[error(transparent)]
    Plot(#[from] PlotError),
    /// The scene has no Floquet multipliers.
    #[error("scene {scene} has no Floquet multipliers: {cause}")]
    Floquet {
        /// Name of the scene.
        scene: String,
        /// Why not.
        cause: FloquetError,
    },
}

/// The same text as `Display`, so that a `main` that returns this error prints a readable message.
impl fmt::Debug for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self}")
    }
}

impl From<SceneMistakes> for Error {
    fn from(mistakes: SceneMistakes) -> Error {
        Error::Scene(Box::new(mistakes))
    }
}

impl From<sweep::Error> for Error {
    fn from(error: sweep::Error) -> Error {
        match error {
            sweep::Error::Scene(mistakes) => Error::Scene(mistakes),
            sweep::Error::Output(error) => Error::Output(error),
            sweep::Error::Impossible { what, help } => Error::Impossible { what, help },
        }
    }
}

impl Error {
    /// An [`Error::Impossible`].
    pub(crate) fn impossible(what: impl Into<String>, help: impl Into<String>) -> Error {
        Error::Impossible { what: what.into(), help: help.into() }
    }
}
