//! JSON files of the program: the name and version of their format, then their content.
//!
//! What a file contains is in its JSON schema, `schemas/FORMAT.schema.json`. A change that a reader of a file could notice raises its version,
//! there and beside the code. Numbers are in SI units unless a name says otherwise; a number that is not finite is `null`.

use serde::Serialize;
use serde_json::{Map, Value};

use super::OutputError;
use super::table::{Table, Values};

#[derive(Serialize)]
struct Document<'a, T> {
    format: &'a str,
    version: u32,
    #[serde(flatten)]
    content: &'a T,
}

/// The text of a file of the format `gearsim.<format>`.
///
/// # Errors
/// [`OutputError::Format`].
pub fn json(format: &str, version: u32, content: &impl Serialize) -> Result<String, OutputError> {
    text(format, version, content, |document| serde_json::to_string_pretty(document))
}

/// The same text in one line, for several documents one after the other (JSON Lines).
///
/// # Errors
/// [`OutputError::Format`].
pub fn line(format: &str, version: u32, content: &impl Serialize) -> Result<String, OutputError> {
    text(format, version, content, |document| serde_json::to_string(document))
}

fn text<T: Serialize>(
    format: &str,
    version: u32,
    content: &T,
    write: fn(&Document<'_, T>) -> serde_json::Result<String>,
) -> Result<String, OutputError> {
    let document = Document { format: &format!("gearsim.{format}"), version, content };
    Ok(write(&document).map_err(|error| OutputError::format("JSON", error))? + "\n")
}

/// The rows of a table, an object each, by the names of the columns.
pub fn records(table: &Table) -> Vec<Map<String, Value>> {
    let entry = |row: usize| {
        let value = |values: &Values| match values {
            Values::Number(numbers) => Value::from(numbers[row]),
            Values::Text(texts) => Value::from(texts[row].as_ref()),
        };
        table.columns().iter().map(|column| (column.name.clone(), value(&column.values))).collect()
    };
    (0..table.rows()).map(entry).collect()
}

#[test]
fn documents_begin_with_their_format() {
    let mut table = Table::default();
    table.push("speed", "rad/s", Values::Number(vec![0.1, f64::NAN])).unwrap();
    table.push("status", "", Values::Text(vec!["done".into(), "refused".into()])).unwrap();
    #[derive(Serialize)]
    struct Content {
        rows: Vec<Map<String, Value>>,
    }
    let text = json("case", 2, &Content { rows: records(&table) }).unwrap();
    let expected = r#"{
  "format": "gearsim.case",
  "version": 2,
  "rows": [
    {
      "speed": 0.1,
      "status": "done"
    },
    {
      "speed": null,
      "status": "refused"
    }
  ]
}
"#;
    assert_eq!(text, expected);
}
