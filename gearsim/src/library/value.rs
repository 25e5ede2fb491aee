//! Values that a program sets in a scene.

use crate::model::Model;
use crate::scene::unit_of;

/// A value of a scene: a number, a switch, a text as in a scene file, or a list or a table of such values.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A number [SI unit of its key].
    Number(f64),
    /// `true` or `false`.
    Flag(bool),
    /// A text with a unit, `20 N*m`, or anything else in TOML, `[{ value = "1 kN*m" }]`. In a list or a table it is a text.
    Text(String),
    /// A list.
    List(Vec<Value>),
    /// Keys and their values.
    Table(Vec<(String, Value)>),
}

impl Value {
    /// The override of `key`, as for the option `--set`.
    pub(super) fn set(&self, key: &str, model: Option<&Model>) -> String {
        format!("{key}={}", self.written(key, model))
    }

    /// Whether the value may have numbers, but the model does not know the unit of `key`.
    pub(super) fn is_strange(&self, key: &str, model: &Model) -> bool {
        !matches!(self, Value::Flag(_) | Value::Text(_)) && unit_of(key, model).is_none()
    }

    /// The value of `key`, written as in a scene file. No digit of a number is lost.
    fn written(&self, key: &str, model: Option<&Model>) -> String {
        match self {
            Value::Text(text) => text.clone(),
            // A number that is not finite has no unit here, so that the error message says that it is not finite.
            Value::Number(number) if !number.is_finite() => number.to_string().to_lowercase(),
            Value::Number(number) => match model.and_then(|model| unit_of(key, model)) {
                Some(unit) if !["", "1"].contains(&unit.as_str()) => format!("{number:?} {unit}"),
                _ => number.to_string(),
            },
            Value::Flag(flag) => flag.to_string(),
            Value::List(items) => {
                let items = items.iter().enumerate().map(|(i, item)| item.within(&format!("{key}.{i}"), model));
                format!("[{}]", items.collect::<Vec<_>>().join(", "))
            }
            Value::Table(entries) => {
                let entry = |(name, value): &(String, Value)| {
                    format!("{} = {}", quoted(name), value.within(&format!("{key}.{name}"), model))
                };
                format!("{{ {} }}", entries.iter().map(entry).collect::<Vec<_>>().join(", "))
            }
        }
    }

    /// The value of `key` in a list or a table: texts, and numbers with units, are in quotes.
    fn within(&self, key: &str, model: Option<&Model>) -> String {
        let text = self.written(key, model);
        match self {
            Value::Text(_) => quoted(&text),
            Value::Number(_) if text.contains(' ') => quoted(&text),
            _ => text,
        }
    }

    /// The value as an entry of the list of an axis. A text with commas or colons is put in quotes.
    pub(super) fn listed(&self, key: &str, model: &Model) -> String {
        let text = self.written(key, Some(model));
        let is_bare = !text.trim_start().starts_with(['[', '{', '"', '\'']);
        if is_bare && text.contains([',', ':']) { format!("{text:?}") } else { text }
    }
}

/// A text in the quotes of TOML, whose basic strings have the escapes of JSON.
fn quoted(text: &str) -> String {
    serde_json::Value::String(text.into()).to_string()
}

impl From<f64> for Value {
    fn from(number: f64) -> Value {
        Value::Number(number)
    }
}

impl From<i32> for Value {
    fn from(number: i32) -> Value {
        Value::Number(f64::from(number))
    }
}

impl From<bool> for Value {
    fn from(value: bool) -> Value {
        Value::Flag(value)
    }
}

impl From<&str> for Value {
    fn from(text: &str) -> Value {
        Value::Text(text.into())
    }
}

impl From<String> for Value {
    fn from(text: String) -> Value {
        Value::Text(text)
    }
}

/// A list, for example of effects.
impl From<&[&str]> for Value {
    fn from(texts: &[&str]) -> Value {
        Value::Text(format!("{texts:?}"))
    }
}
