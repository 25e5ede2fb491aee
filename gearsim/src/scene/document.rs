//! The text of a scene as a tree in which every key and value knows where it was written.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue, Error};

use super::error::Report;

/// Where something is written.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Place {
    /// Number of the text: the file, or an override.
    pub source: usize,
    /// Bytes of the text.
    pub span: Range<usize>,
}

/// A value and its place.
#[derive(Debug, Clone)]
pub(super) struct Node {
    pub value: Value,
    pub place: Place,
}

/// A value; numbers are all `f64`, since no key of a scene asks for a whole one.
#[derive(Debug, Clone)]
pub(super) enum Value {
    Text(String),
    Number(f64),
    Flag(bool),
    Date,
    Array(Vec<Node>),
    Table(Vec<Entry>),
}

/// A key, its place, and its value.
#[derive(Debug, Clone)]
pub(super) struct Entry {
    pub key: String,
    pub place: Place,
    pub node: Node,
}

/// A text being read: its number, and how far what is parsed lies from its beginning.
#[derive(Clone, Copy)]
pub(crate) struct Origin {
    pub source: usize,
    pub offset: usize,
}

impl Origin {
    pub(crate) fn place(self, span: Range<usize>) -> Place {
        Place { source: self.source, span: span.start + self.offset..span.end + self.offset }
    }

    fn node(self, spanned: &Spanned<DeValue>) -> Node {
        let value = match spanned.get_ref() {
            DeValue::String(text) => Value::Text(text.to_string()),
            // The parser has checked the digits; what still does not fit is refused as not finite.
            DeValue::Integer(x) => {
                Value::Number(i128::from_str_radix(x.as_str(), x.radix()).map_or(f64::NAN, |x| x as f64))
            }
            DeValue::Float(x) => Value::Number(x.as_str().parse().unwrap_or(f64::NAN)),
            DeValue::Boolean(flag) => Value::Flag(*flag),
            DeValue::Datetime(_) => Value::Date,
            DeValue::Array(items) => Value::Array(items.iter().map(|item| self.node(item)).collect()),
            DeValue::Table(table) => Value::Table(self.entries(table)),
        };
        Node { value, place: self.place(spanned.span()) }
    }

    fn entries(self, table: &DeTable) -> Vec<Entry> {
        let entry = |(key, value): (&Spanned<DeString>, &Spanned<DeValue>)| Entry {
            key: key.get_ref().to_string(),
            place: self.place(key.span()),
            node: self.node(value),
        };
        table.iter().map(entry).collect()
    }

    fn error(self, error: &Error, length: usize, report: &mut Report) {
        let span = error.span().unwrap_or(length..length);
        // What the parser expected is about tokens; the help below is about scenes.
        let message = error.message().split(", expected ").next().unwrap_or_default();
        let says = |words: &[&str]| words.iter().any(|word| message.contains(word));
        let help = if says(&[UNQUOTED]) {
            "put it in quotes: quantities with units are text, as in \"10 N*m\""
        } else if says(&[DUPLICATE]) {
            "each key and each table may be there once"
        } else if says(&["missing comma", "unclosed", "string"]) {
            "is a comma missing here, or a closing bracket or quote in this line or above?"
        } else {
            "lines are KEY = VALUE or [TABLE]; all of the format is at https://toml.io"
        };
        report.add(&self.place(span), format!("not valid TOML: {message}"), "here", help);
    }
}

/// Messages of the parser about slips after which it is not lost.
const UNQUOTED: &str = "must be quoted";
const DUPLICATE: &str = "duplicate key";

/// Reads a file's text.
pub(super) fn read(text: &str, origin: Origin, report: &mut Report) -> Option<Node> {
    let (table, errors) = DeTable::parse_recoverable(text);
    for error in &errors {
        origin.error(error, text.len(), report);
        // What follows any other error is mostly its echo.
        if ![UNQUOTED, DUPLICATE].iter().any(|slip| error.message().contains(slip)) {
            break;
        }
    }
    // Keys that are missing at the top have to be written there, before the first table.
    let root = Node { value: Value::Table(origin.entries(table.get_ref())), place: origin.place(0..0) };
    errors.is_empty().then_some(root)
}

/// Reads a single value.
pub(super) fn read_value(text: &str, origin: Origin) -> Result<Node, Error> {
    DeValue::parse(text).map(|value| origin.node(&value))
}

/// Reports why a single value could not be read.
pub(super) fn report_value(error: &Error, text: &str, origin: Origin, report: &mut Report) {
    origin.error(error, text.len(), report);
}
