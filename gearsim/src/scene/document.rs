//! The text of a scene as a tree. Every key and value carries its place in the text.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue, Error};

use super::mistake::Report;

/// A place in a text.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Place {
    /// Index of the text in [`Report`]: the file, or an override.
    pub source: usize,
    /// Byte range in the text.
    pub span: Range<usize>,
}

/// A value and its place.
#[derive(Debug, Clone)]
pub(super) struct Node {
    pub value: Value,
    pub place: Place,
}

/// A value. All numbers are `f64`; keys that need a whole number check for it.
#[derive(Debug, Clone)]
pub(super) enum Value {
    Text(String),
    Number(f64),
    Flag(bool),
    Date,
    Array(Vec<Node>),
    Table(Vec<KeyEntry>),
}

/// A key, its place, and its value.
#[derive(Debug, Clone)]
pub(super) struct KeyEntry {
    pub key: String,
    pub place: Place,
    pub node: Node,
}

impl Node {
    /// Whether two nodes have the same values, whatever their places in their texts and the order of their keys.
    pub fn is_same(&self, other: &Node) -> bool {
        match (&self.value, &other.value) {
            (Value::Text(a), Value::Text(b)) => a == b,
            (Value::Number(a), Value::Number(b)) => a.to_bits() == b.to_bits(),
            (Value::Flag(a), Value::Flag(b)) => a == b,
            (Value::Date, Value::Date) => true,
            (Value::Array(a), Value::Array(b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.is_same(b)),
            (Value::Table(a), Value::Table(b)) => {
                let find = |key: &str| b.iter().find(|entry| entry.key == key);
                a.len() == b.len() && a.iter().all(|own| find(&own.key).is_some_and(|its| own.node.is_same(&its.node)))
            }
            _ => false,
        }
    }

    /// The keys of each table in this one, in the order of the text.
    pub fn in_order(&self) -> Vec<(&str, Vec<&str>)> {
        let Value::Table(tables) = &self.value else { return vec![] };
        fn keys(entry: &KeyEntry) -> Option<Vec<&str>> {
            let Value::Table(entries) = &entry.node.value else { return None };
            let mut entries: Vec<&KeyEntry> = entries.iter().collect();
            entries.sort_by_key(|entry| (entry.place.source, entry.place.span.start));
            Some(entries.into_iter().map(|entry| entry.key.as_str()).collect())
        }
        let mut all: Vec<_> = tables.iter().filter_map(|entry| Some((entry.key.as_str(), keys(entry)?))).collect();
        all.sort_unstable();
        all
    }
}

/// Converts positions of the parser to places: the index of the text, and the byte offset of the parsed part within it.
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
            // The parser has checked the digits. A number too large for i128 becomes NaN, which is refused later as not finite.
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

    fn entries(self, table: &DeTable) -> Vec<KeyEntry> {
        let entry = |(key, value): (&Spanned<DeString>, &Spanned<DeValue>)| KeyEntry {
            key: key.get_ref().to_string(),
            place: self.place(key.span()),
            node: self.node(value),
        };
        table.iter().map(entry).collect()
    }

    fn error(self, error: &Error, length: usize, report: &mut Report) {
        let span = error.span().unwrap_or(length..length);
        // The rest of the parser's message lists tokens. The help below is more useful.
        let message = error.message().split(", expected ").next().unwrap_or_default();
        let says = |words: &[&str]| words.iter().any(|word| message.contains(word));
        let help = if says(&[UNQUOTED]) {
            "put it in quotes: quantities with units are text, as in \"10 N*m\""
        } else if says(&[DUPLICATE]) {
            "each key and each table may occur only once"
        } else if says(&["missing comma", "unclosed", "string"]) {
            "is a comma missing here, or a closing bracket or quote in this line or above?"
        } else {
            "a line is KEY = VALUE or [TABLE]; the format is described at https://toml.io"
        };
        report.add(&self.place(span), format!("not valid TOML: {message}"), "here", help);
    }
}

/// Parts of parser messages for errors after which the parser continues correctly.
const UNQUOTED: &str = "must be quoted";
const DUPLICATE: &str = "duplicate key";

/// Reads the text of a scene file.
pub(super) fn read(text: &str, origin: Origin, report: &mut Report) -> Option<Node> {
    let (table, errors) = DeTable::parse_recoverable(text);
    for error in &errors {
        origin.error(error, text.len(), report);
        // Errors after any other error are mostly consequences of it.
        if ![UNQUOTED, DUPLICATE].iter().any(|slip| error.message().contains(slip)) {
            break;
        }
    }
    // The root has its place at the start of the text: missing top-level keys must be added there, before the first table.
    let root = Node { value: Value::Table(origin.entries(table.get_ref())), place: origin.place(0..0) };
    errors.is_empty().then_some(root)
}

/// Reads a single TOML value.
pub(super) fn read_value(text: &str, origin: Origin) -> Result<Node, Error> {
    DeValue::parse(text).map(|value| origin.node(&value))
}

/// Reports why a single value could not be read.
pub(super) fn report_value(error: &Error, text: &str, origin: Origin, report: &mut Report) {
    origin.error(error, text.len(), report);
}
