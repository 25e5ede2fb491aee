//! gearsim for Python: the extension module `gearsim._gearsim`. The package around it, `gearsim`, re-exports it and adds
//! methods that are simpler in Python.

mod argument;
mod error;
mod interrupt;
mod job;
mod results;
mod scene;
mod table;
mod value;

use std::ffi::OsString;
use std::num::NonZeroUsize;
use std::path::PathBuf;

use pyo3::prelude::*;

use argument::Function;

/// Runs the command line with the arguments of the process, and returns its exit code.
#[pyfunction]
fn command_line(py: Python<'_>, #[pyo3(from_py_with = argument::arguments)] arguments: Vec<OsString>) -> u8 {
    py.detach(|| gearsim::cli::status(&[], arguments))
}

/// Names and titles of all models.
#[pyfunction]
fn models() -> Vec<(&'static str, &'static str)> {
    gearsim::models().iter().map(|entry| (entry.model.name, entry.model.title)).collect()
}

/// Checks arguments of functions that are written in Python.
#[pyfunction]
#[pyo3(signature = (scene, out=None, points_per_task=None, threads_per_task=None, progress=None))]
fn _check_arguments(
    #[pyo3(from_py_with = argument::scene)] scene: Bound<'_, scene::Scene>,
    #[pyo3(from_py_with = argument::out)] out: Option<PathBuf>,
    #[pyo3(from_py_with = argument::points_per_task)] points_per_task: Option<NonZeroUsize>,
    #[pyo3(from_py_with = argument::threads_per_task)] threads_per_task: Option<NonZeroUsize>,
    #[pyo3(from_py_with = argument::progress)] progress: Option<Function>,
) {
    // PyO3 has already checked the arguments: it read each with its function in `argument`.
    let _ = (scene, out, points_per_task, threads_per_task, progress);
}

/// The texts of an argument of a function that is written in Python: a list, or also a single text if `one` is true.
#[pyfunction]
fn _texts(value: &Bound<'_, PyAny>, name: &str, one: bool) -> PyResult<Vec<String>> {
    if one { value::one_or_more(value, name) } else { value::names(value, name) }
}

#[pymodule]
fn _gearsim(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("GearsimError", module.py().get_type::<error::GearsimError>())?;
    module.add("SceneError", module.py().get_type::<error::SceneError>())?;
    module.add_class::<scene::Scene>()?;
    module.add_class::<results::Results>()?;
    module.add_class::<results::Comparison>()?;
    module.add_class::<results::Figure>()?;
    module.add_class::<table::Table>()?;
    module.add_class::<job::Job>()?;
    module.add_class::<job::Gathering>()?;
    module.add_function(wrap_pyfunction!(command_line, module)?)?;
    module.add_function(wrap_pyfunction!(_check_arguments, module)?)?;
    module.add_function(wrap_pyfunction!(_texts, module)?)?;
    module.add_function(wrap_pyfunction!(models, module)?)
}
