//! Errors of gearsim as Python exceptions. Their texts are those of the command line.

use pyo3::PyErr;
use pyo3::create_exception;
use pyo3::exceptions::PyException;

create_exception!(gearsim, GearsimError, PyException, "gearsim cannot do what was requested.");
create_exception!(gearsim, SceneError, GearsimError, "A scene has mistakes: the text shows each with its line.");

/// The exception of an error.
pub fn raised(error: gearsim::Error) -> PyErr {
    match error {
        gearsim::Error::Scene(_) => SceneError::new_err(error.to_string()),
        _ => GearsimError::new_err(error.to_string()),
    }
}
