//! Reading single values: text, flags, quantities, lists of names.

use super::dimension::Dimension;
use super::document::{Entry, Node, Place, Value};
use super::error::Report;
use super::keys::choices;
use super::quantity::Quantity;
use super::unit::Unit;

const FREQUENCY: Dimension = Dimension::new(0, 0, -1, 0);
const ANGULAR_SPEED: Dimension = Dimension::new(0, 0, -1, 1);

fn wrong_type(path: &str, node: &Node, expected: &str, help: &str, report: &mut Report) {
    let found = match node.value {
        Value::Text(_) => "text",
        Value::Number(_) => "a number",
        Value::Flag(_) => "true or false",
        Value::Date => "a date",
        Value::Array(_) => "an array",
        Value::Table(_) => "a table",
    };
    report.add(
        &node.place,
        format!("`{path}` must be {expected}, not {found}"),
        found,
        help,
    );
}

pub(super) fn text<'a>(path: &str, node: &'a Node, report: &mut Report) -> Option<&'a str> {
    match &node.value {
        Value::Text(text) => Some(text),
        _ => {
            wrong_type(path, node, "text", "put it in quotes: \"...\"", report);
            None
        }
    }
}

pub(super) fn flag(path: &str, node: &Node, report: &mut Report) -> Option<bool> {
    match node.value {
        Value::Flag(flag) => Some(flag),
        _ => {
            wrong_type(
                path,
                node,
                "true or false",
                "write true or false, without quotes",
                report,
            );
            None
        }
    }
}

pub(super) fn array<'a>(
    path: &str,
    node: &'a Node,
    example: &str,
    report: &mut Report,
) -> Option<&'a [Node]> {
    match &node.value {
        Value::Array(items) => Some(items),
        _ => {
            wrong_type(
                path,
                node,
                "an array",
                &format!("write for example {example}"),
                report,
            );
            None
        }
    }
}

pub(super) fn table<'a>(path: &str, node: &'a Node, report: &mut Report) -> Option<&'a [Entry]> {
    match &node.value {
        Value::Table(entries) => Some(entries),
        _ => {
            wrong_type(
                path,
                node,
                "a table",
                &format!("write [{path}], and its keys on the lines below"),
                report,
            );
            None
        }
    }
}

/// Reads an array of distinct names out of `allowed`, as indices; `noun` is what one of them is.
pub(super) fn names(
    path: &str,
    node: &Node,
    noun: &str,
    allowed: &[&str],
    report: &mut Report,
) -> Option<Vec<usize>> {
    let example = format!("{:?}", &allowed[..allowed.len().min(2)]);
    let items = array(path, node, &example, report)?;
    let mut chosen = Vec::new();
    for item in items {
        let Some(name) = text(path, item, report) else {
            continue;
        };
        match allowed.iter().position(|known| *known == name) {
            None => report.add(
                &item.place,
                format!("there is no {noun} `{name}`"),
                format!("unknown {noun}"),
                choices(name, allowed),
            ),
            Some(index) if chosen.contains(&index) => {
                report.add(
                    &item.place,
                    format!("`{name}` is named twice in `{path}`"),
                    "again",
                    "name it once",
                );
            }
            Some(index) => chosen.push(index),
        }
    }
    Some(chosen)
}

/// Reports a quantity that is understood but not admissible: it `must` something, and is `what`.
pub(super) fn out_of_range(path: &str, node: &Node, must: &str, what: &str, report: &mut Report) {
    let written = report.text(&node.place).trim_matches(['"', '\'']);
    let message = format!("`{path}` {must}, but is {}", written.trim());
    report.add(&node.place, message, "out of range", what);
}

/// Reads a number with a unit that fits `unit`; the result is in SI and finite.
pub(super) fn quantity(path: &str, node: &Node, unit: &str, report: &mut Report) -> Option<f64> {
    let quantity = match &node.value {
        Value::Number(x) => Quantity::bare(*x),
        Value::Text(text) => match Quantity::parse(text) {
            Ok(quantity) => quantity,
            Err(error) => {
                // The error's bytes are bytes of the file unless the text was written with escapes.
                let written = report.text(&node.place);
                let start = node.place.span.start
                    + usize::from(written.get(1..written.len().max(2) - 1) == Some(text));
                let place = match written.contains(text.as_str()) {
                    true => Place {
                        span: start + error.span.start..start + error.span.end,
                        ..node.place
                    },
                    false => node.place.clone(),
                };
                report.add(
                    &place,
                    format!("`{path}` cannot be read: {}", error.message),
                    "not understood",
                    error.help,
                );
                return None;
            }
        },
        _ => {
            let example = if unit == "1" {
                "0.5".to_string()
            } else {
                format!("\"10 {unit}\"")
            };
            wrong_type(
                path,
                node,
                "a quantity",
                &format!("write for example {example}"),
                report,
            );
            return None;
        }
    };
    let Ok(Unit {
        dimension: expected,
        ..
    }) = Unit::parse(unit)
    else {
        report.add(
            &node.place,
            format!("the model gives `{path}` the unit `{unit}`"),
            "unknown unit",
            "mend the model",
        );
        return None;
    };
    if !quantity.value.is_finite() {
        report.add(
            &node.place,
            format!("`{path}` is not a finite number"),
            "not finite",
            "give a finite value",
        );
        return None;
    }
    if quantity.dimension.fits(expected) || quantity.bare && quantity.value == 0.0 {
        return Some(quantity.value);
    }
    let written = report
        .text(&node.place)
        .trim_matches(['"', '\''])
        .to_string();
    if quantity.bare {
        let help = format!("write for example \"{} {unit}\"", written.trim());
        report.add(
            &node.place,
            format!("`{path}` is {}: give a unit", expected.describe()),
            "no unit",
            help,
        );
    } else {
        let help = match (quantity.dimension, expected) {
            (FREQUENCY, ANGULAR_SPEED) => "write rpm, rev/s or rad/s".to_string(),
            (ANGULAR_SPEED, FREQUENCY) => "write Hz, kHz or 1/s".to_string(),
            (_, Dimension::NONE) => "write a number without a unit".to_string(),
            _ => format!("give it in {unit}, with any prefix"),
        };
        let message = format!(
            "`{path}` is {}, but \"{written}\" is {}",
            expected.describe(),
            quantity.dimension.describe()
        );
        report.add(&node.place, message, format!("expected {unit}"), help);
    }
    None
}
