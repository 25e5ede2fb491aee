//! Checks JSON against its schema, for tests.

use serde_json::Value;

/// Checks `value` against `schema`. Only the keywords of JSON Schema that our schemas use are known. `path` is the place of `value` in
/// messages.
///
/// # Errors
/// The first part of `value` that does not conform, with its path.
pub fn conforms(value: &Value, schema: &Value, path: &str) -> Result<(), String> {
    let of = |name: &str| match (name, value) {
        ("object", Value::Object(_)) | ("array", Value::Array(_)) | ("string", Value::String(_)) => true,
        ("null", Value::Null) | ("boolean", Value::Bool(_)) | ("number", Value::Number(_)) => true,
        ("integer", Value::Number(x)) => x.is_u64(),
        _ => false,
    };
    let types = match &schema["type"] {
        Value::Array(names) => names.iter().any(|name| of(name.as_str().unwrap())),
        name => of(name.as_str().ok_or(format!("{path}: no type in the schema"))?),
    };
    let constant = schema.get("const").is_none_or(|constant| constant == value);
    if !types || !constant {
        return Err(format!("{path}: {value} is not as in the schema"));
    }
    if let (Some(items), Some(of)) = (value.as_array(), schema.get("items")) {
        return items.iter().try_for_each(|item| conforms(item, of, path));
    }
    let Some(map) = value.as_object() else { return Ok(()) };
    for key in schema["required"].as_array().into_iter().flatten() {
        if !map.contains_key(key.as_str().unwrap()) {
            return Err(format!("{path}.{key}: missing"));
        }
    }
    for (key, value) in map {
        let path = format!("{path}.{key}");
        match schema["properties"].get(key).or(schema.get("additionalProperties")) {
            Some(of) if of.is_object() => conforms(value, of, path.trim_start_matches('.'))?,
            Some(Value::Bool(true)) => {}
            _ => return Err(format!("{path}: not in the schema")),
        }
    }
    Ok(())
}
