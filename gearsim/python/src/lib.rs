//! gearsim for Python: the extension module `gearsim._gearsim`. The package around it, `gearsim`, re-exports it and adds
//! methods that are simpler in Python.

mod error;
mod interrupt;
mod job;
mod results;
mod scene;
mod table;
mod value;

use std::ffi::OsString;

use pyo3::prelude::*;

/// Runs the command line with the arguments of the process, and returns its exit code.
#[pyfunction]
fn command_line(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| gearsim::cli::status(&[], arguments))
}

/// Names and titles of all models.
#[pyfunction]
fn models() -> Vec<(&'static str, &'static str)> {
    gearsim::models().iter().map(|entry| (entry.model.name, entry.model.title)).collect()
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
    module.add_function(wrap_pyfunction!(models, module)?)
}
