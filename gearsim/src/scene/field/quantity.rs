//! Reads quantities and checks their dimension.

use super::wrong_type;
use crate::scene::dimension::Dimension;
use crate::scene::document::{Node, Place, Value};
use crate::scene::mistake::Report;
use crate::scene::quantity::Quantity;
use crate::scene::unit::{Unit, UnitError};

const FREQUENCY: Dimension = Dimension::new(0, 0, -1, 0);
const ANGULAR_SPEED: Dimension = Dimension::new(0, 0, -1, 1);

/// Reads a number with a unit of the same dimension as `unit`. The result is finite, in SI.
///
/// A number without a unit is accepted only for plain numbers (`unit` is 1) and for zero, which is the same in every unit. No unit is
/// ever assumed.
pub(in crate::scene) fn quantity(path: &str, node: &Node, unit: &str, report: &mut Report) -> Option<f64> {
    let quantity = match &node.value {
        Value::Number(x) => Quantity::bare(*x),
        Value::Text(text) => match Quantity::parse(text) {
            Ok(quantity) => quantity,
            Err(error) => {
                unreadable(path, node, text, error, report);
                return None;
            }
        },
        _ => {
            let example = if unit == "1" { "0.5".to_string() } else { format!("\"10 {unit}\"") };
            wrong_type(path, node, "a quantity", &format!("write for example {example}"), report);
            return None;
        }
    };
    let Ok(expected) = Unit::parse(unit) else {
        let message = format!("the model measures `{path}` in `{unit}`, which is no unit");
        report.add(&node.place, message, "cannot be read", "correct the unit in the model, or use another model");
        return None;
    };
    if !quantity.value.is_finite() {
        let message = format!("`{path}` is not a finite number");
        report.add(&node.place, message, "not finite", "give a finite value");
        return None;
    }
    if quantity.dimension.fits(expected.dimension) || (quantity.bare && quantity.value == 0.0) {
        return Some(quantity.value);
    }
    misfit(path, node, quantity, unit, expected.dimension, report);
    None
}

/// Reports a quantity outside its range: `must` says what is required, e.g. "must be positive"; `what` is the help.
pub(in crate::scene) fn out_of_range(path: &str, node: &Node, must: &str, what: &str, report: &mut Report) {
    let written = report.text(&node.place).trim_matches(['"', '\'']);
    let message = format!("`{path}` {must}, but is {}", written.trim());
    report.add(&node.place, message, "out of range", what);
}

fn unreadable(path: &str, node: &Node, text: &str, error: UnitError, report: &mut Report) {
    // The byte range of the error is moved to the file. If the string contains escapes, `find` fails, and the whole value is marked.
    let place = match report.text(&node.place).find(text) {
        Some(offset) => {
            let start = node.place.span.start + offset;
            Place { span: start + error.span.start..start + error.span.end, ..node.place }
        }
        None => node.place.clone(),
    };
    let message = format!("`{path}` cannot be read: {}", error.message);
    report.add(&place, message, "not understood", error.help);
}

fn misfit(path: &str, node: &Node, quantity: Quantity, unit: &str, expected: Dimension, report: &mut Report) {
    let what = expected.describe();
    let written = report.text(&node.place).trim_matches(['"', '\'']).trim();
    if quantity.bare {
        let help = format!("write for example \"{written} {unit}\"");
        return report.add(&node.place, format!("`{path}` is {what}: give a unit"), "no unit", help);
    }
    let help = match (quantity.dimension, expected) {
        (FREQUENCY, ANGULAR_SPEED) => "write rpm, rev/s or rad/s".to_string(),
        (ANGULAR_SPEED, FREQUENCY) => "write Hz, kHz or 1/s".to_string(),
        (_, Dimension::NONE) => "write a number without a unit".to_string(),
        _ => format!("write it in {unit}, with or without prefixes"),
    };
    let message = format!("`{path}` is {what}, but \"{written}\" is {}", quantity.dimension.describe());
    report.add(&node.place, message, format!("expected {unit}"), help);
}
