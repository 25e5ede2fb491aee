//! `[parameters]`: for each parameter of the model a value, or a function of time.

use super::document::{KeyEntry, Node, Value};
use super::keys::{Kind, Named, each};
use super::mistake::Report;
use super::per_radius::{self, PerRadius, Radii};
use super::{Effects, TimeHistory, field, keys, time_history};
use crate::model::{Model, Parameter, Range};

/// Parameters that a scene may have.
pub(super) const NAMED: &[Named] = &[each(
    "PARAMETER",
    Kind::Either(&[Kind::ValueIn("unit of the parameter"), Kind::Table(&[per_radius::KEYS]), time_history::HISTORY]),
    "that of the model",
    "a value; an inertia, torsional stiffness or damping also over the square of a radius; a function of time where the model allows it",
)];

/// Values of the parameters.
pub(super) struct Given {
    /// Values at t = 0 [SI], in the order of the model.
    pub values: Vec<f64>,
    /// The parameters that vary in time, with their indices.
    pub varying: Vec<(usize, TimeHistory)>,
    /// One sentence for each value that was given over the square of a radius.
    pub conversions: Vec<String>,
}

/// Reads `[parameters]`, in the order of the model. If the table is missing, the lines to add go to `absent`. A parameter without a
/// default whose effect is not among `effects` may be left out; its value is then NaN. `radii` has the radii to which values per squared
/// radius refer.
pub(super) fn read(
    entries: &[KeyEntry],
    (model, radii): (&Model, &dyn Radii),
    effects: Option<&Effects>,
    absent: &mut Vec<(&str, String)>,
    report: &mut Report,
) -> Option<Given> {
    let node = keys::get(entries, "parameters");
    let given = node.map_or(Some(&[][..]), |node| field::table("parameters", node, report))?;
    let known: Vec<_> = model.parameters.iter().map(|p| p.name).collect();
    keys::names_known(given, "[parameters]", &known, report);

    let idle = |p: &Parameter| {
        p.default.is_none() && p.with.is_some_and(|effect| !effects.is_some_and(|effects| effects.has(effect, model)))
    };
    let needed = |p: &&Parameter| p.default.is_none() && !idle(p) && keys::get(given, p.name).is_none();
    let home = |p: &Parameter| report.stated.home(&format!("parameters.{}", p.name)).cloned();
    let (of_parts, others): (Vec<_>, Vec<_>) =
        model.parameters.iter().filter(needed).map(|p| (p, home(p))).partition(|(_, home)| home.is_some());
    let lines: Vec<_> = others.into_iter().map(|(p, _)| (p.name, example(p.name, p))).collect();
    let of_parts = of_parts.into_iter().filter_map(|(p, home)| Some((example(home.as_ref()?.key, p), home?)));
    keys::missing_in_parts(of_parts.map(|(line, home)| (home, line)).collect(), report);
    match node {
        Some(node) => keys::missing(&lines, "[parameters]", &node.place, report),
        None if lines.is_empty() => {}
        None => {
            let lines: Vec<_> = lines.into_iter().map(|(_, line)| line).collect();
            absent.push(("[parameters]", format!("[parameters]\n{}", lines.join("\n"))));
        }
    }
    let (mut varying, mut per_radius) = (vec![], vec![]);
    let values: Vec<_> = (model.parameters.iter().enumerate())
        .map(|(i, parameter)| match keys::get(given, parameter.name) {
            Some(node) if let Some(read) = PerRadius::read(parameter, node, report) => {
                per_radius.push((i, read?));
                Some(f64::NAN)
            }
            Some(node) if matches!(node.value, Value::Table(_)) => {
                let history = history(parameter, node, model, report)?;
                let value = history.at_start();
                varying.push((i, history));
                Some(value)
            }
            Some(node) => value(parameter, node, report),
            None if idle(parameter) => Some(f64::NAN),
            None => parameter.default,
        })
        .collect();
    let mut values: Vec<f64> = values.into_iter().collect::<Option<_>>()?;
    let known = values.clone();
    let value = |name: &str| model.parameters.iter().position(|p| p.name == name).map(|i| known[i]);
    let mut conversions = vec![];
    for (i, given) in per_radius {
        let (x, says) = given.convert(model, radii, &value, report)?;
        in_range(&model.parameters[i], given.node(), x, report)?;
        values[i] = x;
        conversions.push(says);
    }
    let before = report.len();
    ordered(given, model, &values, report);
    (report.len() == before).then_some(Given { values, varying, conversions })
}

/// Checks the parameters that must exceed others.
fn ordered(given: &[KeyEntry], model: &Model, values: &[f64], report: &mut Report) {
    for (parameter, greater) in model.parameters.iter().zip(values) {
        let lesser = parameter.above.and_then(|name| model.parameters.iter().position(|p| p.name == name));
        let Some(i) = lesser.filter(|&i| *greater <= values[i]) else { continue };
        let (of, lesser) = (&model.parameters[i], values[i]);
        let Some(node) = keys::get(given, parameter.name) else { continue };
        let path = format!("parameters.{}", parameter.name);
        let must = format!("must exceed `{}`, which is {lesser} {}", of.name, of.unit);
        let what = format!("`{}` is the {}, `{}` the {}", parameter.name, parameter.doc, of.name, of.doc);
        field::out_of_range(&path, node, &must, &what, report);
    }
}

/// Reads a function of time and checks that its bounds are in the range of the parameter.
fn history(parameter: &Parameter, node: &Node, model: &Model, report: &mut Report) -> Option<TimeHistory> {
    let history = time_history::read(parameter, node, model, report)?;
    let (low, high) = history.bounds();
    if parameter.range.contains(low) && parameter.range.contains(high) {
        return Some(history);
    }
    let must = describe(&parameter.range, parameter.unit);
    let message = format!("`parameters.{}` {must}, but goes from {low} to {high}", parameter.name);
    report.add(&node.place, message, "out of range", format!("`{}` is the {}", parameter.name, parameter.doc));
    None
}

/// Example line for a missing parameter, which is written at `key`.
fn example(key: &str, parameter: &Parameter) -> String {
    match parameter.unit {
        "1" if key == "teeth" => "teeth = [..., ...]  # numbers of teeth of both gears".into(),
        "1" => format!("{key} = ...  # {}", parameter.doc),
        unit => format!("{key} = \"... {unit}\"  # {}", parameter.doc),
    }
}

fn value(parameter: &Parameter, node: &Node, report: &mut Report) -> Option<f64> {
    let x = field::quantity(&format!("parameters.{}", parameter.name), node, parameter.unit, report)?;
    in_range(parameter, node, x, report)
}

fn in_range(parameter: &Parameter, node: &Node, x: f64, report: &mut Report) -> Option<f64> {
    let path = format!("parameters.{}", parameter.name);
    if parameter.range.contains(x) {
        return Some(x);
    }
    let must = describe(&parameter.range, parameter.unit);
    let what = format!("`{}` is the {}", parameter.name, parameter.doc);
    field::out_of_range(&path, node, &must, &what, report);
    None
}

/// The range in words: "must be positive", "must be at least 1 and be less than 2".
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
