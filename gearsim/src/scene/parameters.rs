//! `[parameters]`: a value for each parameter of the model.

use super::document::{Entry, Node};
use super::error::Report;
use super::{field, keys, measure};
use crate::model::{Model, Parameter, Range};

/// Reads `[parameters]`, in the order of the model; what to add goes to `absent` if the table is not there.
pub(super) fn read(
    entries: &[Entry],
    model: &Model,
    absent: &mut Vec<(&str, String)>,
    report: &mut Report,
) -> Option<Vec<f64>> {
    let node = keys::get(entries, "parameters");
    let given = node.map_or(Some(&[][..]), |node| field::table("parameters", node, report))?;
    let names: Vec<_> = model.parameters.iter().map(|p| p.name).collect();
    keys::known(given, "[parameters]", &names, report);

    let needed = |p: &&Parameter| p.default.is_none() && keys::get(given, p.name).is_none();
    let lines = model.parameters.iter().filter(needed).map(|p| (p.name, example(p)));
    let lines: Vec<_> = lines.collect();
    match node {
        Some(node) => keys::missing(&lines, "[parameters]", &node.place, report),
        None if lines.is_empty() => {}
        None => {
            let lines: Vec<_> = lines.into_iter().map(|(_, line)| line).collect();
            absent.push(("[parameters]", format!("[parameters]\n{}", lines.join("\n"))));
        }
    }
    let values: Vec<_> = (model.parameters.iter())
        .map(|parameter| match keys::get(given, parameter.name) {
            Some(node) => value(parameter, node, report),
            None => parameter.default,
        })
        .collect();
    values.into_iter().collect()
}

/// What to write for a parameter.
fn example(parameter: &Parameter) -> String {
    match parameter.unit {
        "1" => format!("{} = ...  # {}", parameter.name, parameter.doc),
        unit => format!("{} = \"... {unit}\"  # {}", parameter.name, parameter.doc),
    }
}

fn value(parameter: &Parameter, node: &Node, report: &mut Report) -> Option<f64> {
    let path = format!("parameters.{}", parameter.name);
    let x = measure::quantity(&path, node, parameter.unit, report)?;
    if parameter.range.contains(x) {
        return Some(x);
    }
    let must = describe(&parameter.range, parameter.unit);
    let what = format!("`{}` is the {}", parameter.name, parameter.doc);
    measure::out_of_range(&path, node, &must, &what, report);
    None
}

/// What a value in the range must do.
fn describe(range: &Range, unit: &str) -> String {
    let unit = if unit == "1" { String::new() } else { format!(" {unit}") };
    let low = match (range.low, range.low_included) {
        (f64::NEG_INFINITY, _) => None,
        (0.0, true) => Some("not be negative".to_string()),
        (0.0, false) => Some("be positive".to_string()),
        (low, true) => Some(format!("be at least {low}{unit}")),
        (low, false) => Some(format!("be more than {low}{unit}")),
    };
    let high = match (range.high, range.high_included) {
        (f64::INFINITY, _) => None,
        (high, true) => Some(format!("be at most {high}{unit}")),
        (high, false) => Some(format!("be less than {high}{unit}")),
    };
    let bounds: Vec<_> = [low, high].into_iter().flatten().collect();
    format!("must {}", bounds.join(" and "))
}
