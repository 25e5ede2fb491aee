//! Python values as values of a scene.

use gearsim::{Scene, Value};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyBytes, PyDict, PyMapping, PyString};

use crate::argument::Mapping;

/// The values of a nested dictionary, each with its dotted key: `{"run": {"t_end": 1.0}}` has `run.t_end`.
pub fn flat(table: &Bound<'_, PyDict>, before: &str) -> PyResult<Vec<(String, Value)>> {
    let mut values = vec![];
    for (key, value) in table.iter() {
        let key = format!("{before}{}", path(&key, before)?);
        match value.extract::<Mapping<'_>>() {
            // An empty nested dict is kept as an empty table: the message about it then names the keys that it lacks.
            Ok(Mapping(table)) if !table.is_empty() || before.is_empty() => {
                values.extend(flat(&table, &format!("{key}."))?);
            }
            _ => {
                let value = of(&value).map_err(|error| at(&key, error, value.py()))?;
                values.push((key, value));
            }
        }
    }
    Ok(values)
}

/// A key of a table, or several keys joined by dots. It must not contain `=`, because values are set by a text `KEY=VALUE`.
fn path(key: &Bound<'_, PyAny>, before: &str) -> PyResult<String> {
    let path = name(key, before)?;
    if path.contains('=') || path.split('.').any(|part| part.trim().is_empty()) {
        return Err(PyValueError::new_err(format!(
            "the keys of {} are names, or names joined by dots, not {path:?}: a name has letters, digits and `_`",
            of_table(before)
        )));
    }
    Ok(path)
}

/// The table with the dotted path `before`, as messages name it.
fn of_table(before: &str) -> String {
    let table = before.trim_end_matches('.');
    if table.is_empty() { "a scene".into() } else { format!("`{table}`") }
}

/// A key of a table.
fn name(key: &Bound<'_, PyAny>, before: &str) -> PyResult<String> {
    key.extract().map_err(|_| {
        PyTypeError::new_err(format!("the keys of {} are texts, not {key}: write \"{key}\"", of_table(before)))
    })
}

/// The error of a value with its key.
fn at(key: &str, error: PyErr, py: Python<'_>) -> PyErr {
    match error.is_instance_of::<PyTypeError>(py) {
        true => PyTypeError::new_err(format!("`{key}` cannot be set: {}", error.value(py))),
        false => error,
    }
}

/// A value: a number [SI], a text with a unit, a bool, or a list or a dict of values.
pub fn of(value: &Bound<'_, PyAny>) -> PyResult<Value> {
    let value = &scalar(value)?;
    if let Ok(flag) = value.cast::<PyBool>() {
        return Ok(Value::Flag(flag.is_true()));
    }
    if value.is_instance_of::<PyString>() {
        return Ok(Value::Text(value.extract()?));
    }
    if let Ok(Mapping(table)) = value.extract() {
        let entry = |(key, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| Ok((name(&key, "a table")?, of(&value)?));
        return Ok(Value::Table(table.iter().map(entry).collect::<PyResult<_>>()?));
    }
    if is_number(value)? {
        return Ok(Value::Number(value.extract()?));
    }
    if let (false, Ok(items)) = (value.is_instance_of::<PyBytes>(), value.try_iter()) {
        return Ok(Value::List(items.map(|item| of(&item?)).collect::<PyResult<_>>()?));
    }
    let kind = value.get_type().name()?;
    Err(PyTypeError::new_err(format!("a scene has numbers, texts, bools, lists and dicts; not {kind}")))
}

/// Axes as texts for `--vary`. They are texts already, or dicts of keys with their values: lists and arrays of numbers [SI] and of texts
/// with units, a single value, or a range as for `--vary`. `axes` is one of these, or a list of them.
pub fn axes(axes: &Bound<'_, PyAny>, scene: &Scene) -> PyResult<Vec<String>> {
    if axes.is_instance_of::<PyString>() {
        return Ok(vec![axes.extract()?]);
    }
    if let Ok(table) = axes.cast::<PyMapping>() {
        return axes_of(table, "", scene);
    }
    let mut texts = vec![];
    for axis in axes.try_iter().map_err(|_| not_axes(axes))? {
        let axis = axis?;
        match axis.cast::<PyMapping>() {
            Ok(table) => texts.extend(axes_of(table, "", scene)?),
            Err(_) => texts.push(axis.extract().map_err(|_| not_axes(&axis))?),
        }
    }
    Ok(texts)
}

/// The axes of a dict. Keys of nested dicts are joined by dots, as in [`flat`].
fn axes_of(table: &Bound<'_, PyMapping>, before: &str, scene: &Scene) -> PyResult<Vec<String>> {
    let mut axes = vec![];
    for pair in table.items()? {
        let (key, values): (Bound<'_, PyAny>, Bound<'_, PyAny>) = pair.extract()?;
        let key = format!("{before}{}", path(&key, before)?);
        let values = scalar(&values)?;
        if let Ok(table) = values.cast::<PyMapping>() {
            axes.extend(axes_of(table, &format!("{key}."), scene)?);
        } else if values.is_instance_of::<PyString>() {
            axes.push(format!("{key}={}", values.extract::<String>()?));
        } else if values.hasattr("__iter__")? {
            let list = values.try_iter()?.map(|value| of(&value?)).collect::<PyResult<Vec<_>>>()?;
            if list.is_empty() {
                return Err(PyValueError::new_err(format!("the axis `{key}` has no values: give at least one")));
            }
            axes.push(scene.axis(&key, &list));
        } else {
            axes.push(scene.axis(&key, &[of(&values)?]));
        }
    }
    Ok(axes)
}

fn not_axes(found: &Bound<'_, PyAny>) -> PyErr {
    let kind = found.get_type().name().map_or_else(|_| "object".into(), |name| name.to_string());
    PyTypeError::new_err(format!(
        "an axis is a text, \"parameters.T0=1 N*m:9 N*m:5\", or a dict of keys and values, {{\"parameters.T0\": [1.0, 2.0]}}; not {kind}"
    ))
}

/// A text, or the texts of a list.
pub fn one_or_more(list: &Bound<'_, PyAny>, what: &str) -> PyResult<Vec<String>> {
    if list.is_instance_of::<PyString>() { Ok(vec![list.extract()?]) } else { names(list, what) }
}

/// The texts of a list such as `effects`. A single text would be taken as a list of letters.
pub fn names(list: &Bound<'_, PyAny>, what: &str) -> PyResult<Vec<String>> {
    let refused = |found: &Bound<'_, PyAny>| {
        let found = found.str().map_or_else(|_| "...".into(), |text| text.to_string());
        PyTypeError::new_err(format!("`{what}` is a list of texts: {what}=[\"{found}\"]"))
    };
    if list.is_instance_of::<PyString>() {
        return Err(refused(list));
    }
    let items = list.try_iter().map_err(|_| refused(list))?;
    items.map(|item| item.and_then(|item| item.extract().map_err(|_| refused(&item)))).collect()
}

/// A scalar or an array without dimensions of NumPy as Python's int, float, bool or str; other values as they are.
fn scalar<'py>(value: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let dimensions = value.getattr_opt("ndim")?.map(|dimensions| dimensions.extract::<usize>());
    match dimensions {
        Some(Ok(0)) if value.hasattr("item")? => value.call_method0("item"),
        _ => Ok(value.clone()),
    }
}

/// Whether a value is a number: it converts to one, and is no bool, no text and no list.
fn is_number(value: &Bound<'_, PyAny>) -> PyResult<bool> {
    if value.is_instance_of::<PyBool>() || value.is_instance_of::<PyString>() || value.hasattr("__iter__")? {
        return Ok(false);
    }
    Ok(value.hasattr("__float__")? || value.hasattr("__index__")?)
}
