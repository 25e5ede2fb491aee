//! Parts of chapters that are generated from the descriptions of models that the program prints, and from JSON schemas.

use std::fs;

use anyhow::{Context, bail, ensure};
use serde_json::Value;

use super::reader::Reader;
use crate::chore;

/// The Markdown for the note `<!-- key: value -->`; `reader` runs the program.
pub fn of(key: &str, value: &str, reader: &Reader) -> anyhow::Result<String> {
    match key {
        "model" => model(&json(&format!("gearsim models {value} --json"), reader)?["models"][0]),
        "models with" => models_with(value, &json("gearsim models --json", reader)?),
        "keys of" => keys(&fs::read_to_string(chore::root()?.join(value))?),
        _ => bail!("there is no part `{key}`"),
    }
}

fn json(command: &str, reader: &Reader) -> anyhow::Result<Value> {
    serde_json::from_str(&reader.output(command)?).with_context(|| format!("`{command}` prints no JSON"))
}

/// What a scene of a model can set, and what its runs record.
fn model(model: &Value) -> anyhow::Result<String> {
    let list = |key: &str| model[key].as_array().with_context(|| format!("a model without `{key}`"));
    let mut text = format!("*{}.* Source: {}.\n", word(&model["title"]), word(&model["source"]));
    let quantity = |q: &Value| vec![code(&q["name"]), word(&q["unit"]), word(&q["doc"])];
    for (key, title) in [("coordinates", "Coordinates"), ("laws", "Laws over one pitch"), ("outputs", "Outputs")] {
        let rows = list(key)?.iter().map(quantity).collect();
        text += &section(title, &["name", "SI unit", "what it is"], rows);
    }
    let parameter = |p: &Value| {
        let default = if p["default"].is_null() { "required".into() } else { p["default"].to_string() };
        let mut row = quantity(p);
        row.extend([default, word(&p["range"]), p["with"].as_str().map_or(String::new(), |with| format!("`{with}`"))]);
        row
    };
    let head = ["name", "SI unit", "what it is", "default", "range", "only with"];
    text += &section("Parameters", &head, list("parameters")?.iter().map(parameter).collect());
    let effects: Vec<_> = list("effects")?.iter().map(|name| format!("[{0}](../effects/{0}.md)", word(name))).collect();
    let effects = if effects.is_empty() { "none".into() } else { effects.join(", ") };
    Ok(format!("{text}\n## Effects\n\n{effects}\n"))
}

/// The models that have an effect.
fn models_with(effect: &str, all: &Value) -> anyhow::Result<String> {
    let has = |model: &&Value| model["effects"].as_array().is_some_and(|effects| effects.iter().any(|e| *e == effect));
    let models = all["models"].as_array().context("no models")?;
    let names: Vec<_> = models.iter().filter(has).map(|model| code(&model["name"])).collect();
    ensure!(!names.is_empty(), "no model has the effect `{effect}`");
    Ok(format!("Models with this effect: {}.\n", names.join(", ")))
}

/// The keys of the documents that a JSON schema describes, those of tables in tables with their paths.
fn keys(schema: &str) -> anyhow::Result<String> {
    let mut rows = vec![];
    collect(&serde_json::from_str(schema)?, "", &mut rows);
    ensure!(!rows.is_empty(), "the schema has no properties");
    Ok(table(&["key", "what it is"], rows))
}

fn collect(schema: &Value, path: &str, rows: &mut Vec<Vec<String>>) {
    for (name, inner) in schema["properties"].as_object().into_iter().flatten() {
        let path = format!("{path}{name}");
        rows.push(vec![format!("`{path}`"), word(&inner["description"])]);
        collect(inner, &format!("{path}."), rows);
        collect(&inner["items"], &format!("{path}[]."), rows);
        collect(&inner["additionalProperties"], &format!("{path}.NAME."), rows);
    }
}

/// A section with a table, or nothing if there are no rows.
fn section(title: &str, head: &[&str], rows: Vec<Vec<String>>) -> String {
    if rows.is_empty() { String::new() } else { format!("\n## {title}\n\n{}", table(head, rows)) }
}

fn table(head: &[&str], rows: Vec<Vec<String>>) -> String {
    let row = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let head = row(head.iter().map(|cell| cell.to_string()).collect()) + &row(vec!["---".into(); head.len()]);
    rows.into_iter().map(row).fold(head, |text, row| text + &row)
}

/// A text in a cell of a table.
fn word(text: &Value) -> String {
    text.as_str().unwrap_or_default().replace('|', "\\|")
}

fn code(text: &Value) -> String {
    format!("`{}`", word(text))
}

#[test]
fn keys_of_tables_have_their_paths() {
    let schema = r#"{"properties": {"a": {"description": "one"}, "b": {"description": "two", "additionalProperties":
        {"properties": {"c": {"description": "three|four"}}}}}}"#;
    let expected = "| key | what it is |\n| --- | --- |\n| `a` | one |\n| `b` | two |\n| `b.NAME.c` | three\\|four |\n";
    assert_eq!(keys(schema).unwrap(), expected);
}
