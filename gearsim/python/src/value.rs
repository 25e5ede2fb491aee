//! Python values as values of a scene.

use gearsim::Value;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyString};

/// The values of a nested dictionary, each with its dotted key: `{"run": {"t_end": 1.0}}` has `run.t_end`.
pub fn flat(table: &Bound<'_, PyDict>, before: &str) -> PyResult<Vec<(String, Value)>> {
    let mut values = vec![];
    for (key, value) in table.iter() {
        let key = format!("{before}{}", key.extract::<String>()?);
        match value.cast::<PyDict>() {
            Ok(table) => values.extend(flat(table, &format!("{key}."))?),
            Err(_) => values.push((key, of(&value)?)),
        }
    }
    Ok(values)
}

/// A value: a number [SI], a text with a unit, a bool, or a list.
pub fn of(value: &Bound<'_, PyAny>) -> PyResult<Value> {
    if value.is_instance_of::<PyBool>() || !(value.is_instance_of::<PyFloat>() || value.is_instance_of::<PyInt>()) {
        return match value.extract::<String>() {
            Ok(text) => Ok(Value::Text(text)),
            Err(_) => toml(value).map(Value::Text),
        };
    }
    Ok(Value::Number(value.extract()?))
}

/// A value in TOML.
fn toml(value: &Bound<'_, PyAny>) -> PyResult<String> {
    if let Ok(flag) = value.cast::<PyBool>() {
        return Ok(flag.is_true().to_string());
    }
    if value.is_instance_of::<PyString>() {
        // TOML's basic strings have the escapes of JSON.
        return Ok(serde_json::Value::String(value.extract()?).to_string());
    }
    if value.is_instance_of::<PyInt>() {
        return Ok(value.extract::<i64>()?.to_string());
    }
    if let Ok(table) = value.cast::<PyDict>() {
        let entry =
            |(key, value): (Bound<'_, PyAny>, _)| Ok(format!("{} = {}", key.extract::<String>()?, toml(&value)?));
        let entries = table.iter().map(entry).collect::<PyResult<Vec<_>>>()?;
        return Ok(format!("{{ {} }}", entries.join(", ")));
    }
    // NumPy's numbers are no instances of Python's classes, but can be converted.
    if let Ok(number) = value.extract::<f64>() {
        return Ok(format!("{number:?}"));
    }
    if let Ok(items) = value.try_iter() {
        let items = items.map(|item| toml(&item?)).collect::<PyResult<Vec<_>>>()?;
        return Ok(format!("[{}]", items.join(", ")));
    }
    let kind = value.get_type().name()?;
    Err(PyTypeError::new_err(format!("a scene has numbers, texts, bools, lists and dicts; not {kind}")))
}
