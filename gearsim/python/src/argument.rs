//! Arguments of functions: what each is, with an example. A value of another type is refused with the text of this table, because
//! the messages of PyO3 name Rust types.
//!
//! Each function reads its arguments with `#[pyo3(from_py_with = argument::NAME)]`. `tests/test_arguments.py` finds arguments that are read in
//! another way.

use pyo3::exceptions::{PyOverflowError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping};

/// Makes a function for each argument, which reads its value and raises an error with the texts of the table.
macro_rules! arguments {
    ($($function:ident $($name:literal)?: $allowed:literal, $example:literal;)*) => {$(
        pub fn $function<'a, 'py, T: FromPyObject<'a, 'py>>(value: &'a Bound<'py, PyAny>) -> PyResult<T> {
            read(value, arguments!(@ $function $($name)?), $allowed, $example)
        }
    )*};
    (@ $function:ident) => { stringify!($function) };
    (@ $function:ident $name:literal) => { $name };
}

// The name of an argument (in quotes if several functions have one of this name), what it is, and an example.
arguments! {
    arguments: "a list of texts", r#"["gearsim", "models"]"#;
    axis_start "start": "a time in s", "0.5";
    column "name": "a text", r#""t""#;
    design: "a text", r#""sobol""#;
    end: "a whole number from 0 on", "100";
    first: "a whole number from 0 on", "0";
    folder: "a path", r#""out""#;
    gathering: "what `job.gather` returns", "job.gather(folder)";
    hold: "the name of a parameter, or \"nothing\"", r#""T0""#;
    html: "True or False", "True";
    laws: "a list of numbers in SI units", "[1e8]";
    levels: "a list of numbers in SI units", "[1e8, 2e8]";
    model: "the name of a model", r#""gear_pair""#;
    most: "a whole number from 0 on", "10_000";
    out: "a path", r#""out""#;
    overrides: "a list of texts", r#"["run.t_end=1 s"]"#;
    path: "a path", r#""scene.toml""#;
    plot "name": "the name of a plot", r#""outputs""#;
    points: "a whole number from 0 on", "4000";
    points_per_task: "a whole number from 1 on", "10_000";
    progress: "a function of one number", "print";
    q: "a list of numbers in SI units", "[0.0, 0.0]";
    q_dot: "a list of numbers in SI units", "[1.0, 1.0]";
    rows: "the bytes that `job.run` returns", "job.run(0, 100)";
    samples: "a whole number from 0 on", "1000";
    scene: "a gearsim.Scene", r#"gearsim.load("scene.toml")"#;
    scene_name "name": "a text", r#""scene""#;
    scenes: "a list of names and scenes", r#"[("a", gearsim.load("a.toml")), ("b", gearsim.load("b.toml"))]"#;
    seed: "a whole number from 0 to 2**64 - 1", "1";
    table: "a gearsim.Table", r#"gearsim.sweep(scene, "run.t_end=1 s,2 s")"#;
    text: "the text of a scene in TOML", r#"pathlib.Path("scene.toml").read_text()"#;
    threads: "a whole number from 1 on", "4";
    threads_per_task: "a whole number from 1 on", "1";
    values: "a dict of keys and values", r#"{"parameters.T0": 20.0}"#;
}

/// Longest representation of a value in a message [characters].
const SHOWN: usize = 60;

fn read<'a, 'py, T: FromPyObject<'a, 'py>>(
    value: &'a Bound<'py, PyAny>,
    name: &str,
    allowed: &str,
    example: &str,
) -> PyResult<T> {
    let py = value.py();
    value.extract().map_err(|error: T::Error| {
        let error: PyErr = error.into();
        let out_of_range = error.is_instance_of::<PyOverflowError>(py) || error.is_instance_of::<PyValueError>(py);
        // Other errors, such as KeyboardInterrupt, come from the code of the caller and are returned unchanged.
        if !out_of_range && !error.is_instance_of::<PyTypeError>(py) {
            return error;
        }
        let message = format!("`{name}` is {allowed}, not {}: {name}={example}", shown(value));
        if out_of_range { PyValueError::new_err(message) } else { PyTypeError::new_err(message) }
    })
}

/// A value and its type.
fn shown(value: &Bound<'_, PyAny>) -> String {
    let kind = value.get_type().name().map_or_else(|_| "object".into(), |name| name.to_string());
    match value.repr().map(|text| text.to_string()) {
        Ok(text) if text.chars().count() <= SHOWN => format!("{text} ({kind})"),
        _ => format!("this {kind}"),
    }
}

/// A Python callable.
pub struct Function(pub Py<PyAny>);

impl<'a, 'py> FromPyObject<'a, 'py> for Function {
    type Error = PyErr;

    fn extract(value: Borrowed<'a, 'py, PyAny>) -> PyResult<Function> {
        if value.is_callable() {
            Ok(Function(value.to_owned().unbind()))
        } else {
            Err(PyTypeError::new_err("no function"))
        }
    }
}

/// A dictionary. Any other mapping is copied into a dictionary.
pub struct Mapping<'py>(pub Bound<'py, PyDict>);

impl<'a, 'py> FromPyObject<'a, 'py> for Mapping<'py> {
    type Error = PyErr;

    fn extract(value: Borrowed<'a, 'py, PyAny>) -> PyResult<Mapping<'py>> {
        if let Ok(dict) = value.cast::<PyDict>() {
            return Ok(Mapping(dict.to_owned()));
        }
        let dict = PyDict::new(value.py());
        dict.update(&*value.cast::<PyMapping>()?)?;
        Ok(Mapping(dict))
    }
}
