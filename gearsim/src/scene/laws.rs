//! Mesh stiffness laws: the levels of one pitch.

use super::document::Node;
use super::error::Report;
use super::{Step, Stiffness, field};
use crate::model::{Law, Model};

/// Widths that are all given may miss the pitch by this much, relative to it: they are often rounded.
const PITCH_TOLERANCE: f64 = 1e-9;

impl Stiffness {
    /// Half-way between the greatest and the least level [unit of the law].
    pub fn mid(&self) -> f64 {
        let levels = || self.steps.iter().map(|step| step.value);
        (levels().fold(f64::NEG_INFINITY, f64::max) + levels().fold(f64::INFINITY, f64::min)) / 2.0
    }

    /// Average over one pitch [unit of the law].
    pub fn mean(&self) -> f64 {
        let width: f64 = self.steps.iter().map(|step| step.width).sum();
        self.steps
            .iter()
            .map(|step| step.value * step.width)
            .sum::<f64>()
            / width
    }
}

/// Reads `[laws]`, in the order of the model.
pub(super) fn read(node: &Node, model: &Model, report: &mut Report) -> Option<Vec<Stiffness>> {
    let entries = field::table("laws", node, report)?;
    let names: Vec<_> = model.laws.iter().map(|law| law.name).collect();
    field::known_keys(entries, "[laws]", &names, report);
    let lacking: Vec<_> = model
        .laws
        .iter()
        .filter(|law| field::get(entries, law.name).is_none())
        .collect();
    let lines: Vec<_> = lacking.iter().map(|law| (law.name, example(law))).collect();
    field::missing(&lines, "[laws]", &node.place, report);
    let laws: Vec<_> = model
        .laws
        .iter()
        .map(|law| {
            steps(
                law,
                field::get(entries, law.name)?,
                phase_unit(law, model),
                report,
            )
        })
        .collect();
    laws.into_iter().collect()
}

/// What to write for a law.
pub(super) fn example(law: &Law) -> String {
    format!(
        "[laws.{}]\nsteps = [{{ value = \"... {}\" }}]  # {}",
        law.name, law.unit, law.doc
    )
}

fn phase_unit(law: &Law, model: &Model) -> &'static str {
    model
        .coordinates
        .iter()
        .find(|coordinate| coordinate.name == law.phase)
        .map_or("rad", |coordinate| coordinate.unit)
}

fn steps(law: &Law, node: &Node, phase_unit: &str, report: &mut Report) -> Option<Stiffness> {
    let path = format!("laws.{}", law.name);
    let entries = field::table(&path, node, report)?;
    field::known_keys(entries, &format!("[{path}]"), &["steps"], report);
    let example = format!(
        "[{{ value = \"... {}\", width = \"... {phase_unit}\" }}, {{ value = \"... {0}\" }}]",
        law.unit
    );
    let Some(steps) = field::get(entries, "steps") else {
        field::missing(
            &[("steps", format!("steps = {example}"))],
            &format!("[{path}]"),
            &node.place,
            report,
        );
        return None;
    };
    let path = format!("{path}.steps");
    let items = field::array(&path, steps, &example, report)?;
    if items.is_empty() {
        report.add(
            &steps.place,
            format!("`{path}` is empty"),
            "no level",
            format!("write for example {example}"),
        );
        return None;
    }
    let read: Vec<_> = items
        .iter()
        .enumerate()
        .map(|(i, item)| {
            step(
                &format!("{path}.{i}"),
                item,
                i + 1 == items.len(),
                law,
                phase_unit,
                report,
            )
        })
        .collect();
    let read: Vec<_> = read.into_iter().collect::<Option<_>>()?;
    fill(&path, steps, read, law.period, phase_unit, report)
}

/// One level and its width, which only the last may leave out.
fn step(
    path: &str,
    node: &Node,
    last: bool,
    law: &Law,
    phase_unit: &str,
    report: &mut Report,
) -> Option<(f64, Option<f64>)> {
    let entries = field::table(path, node, report)?;
    field::known_keys(entries, &format!("`{path}`"), &["value", "width"], report);
    let mut lacking = Vec::new();
    if field::get(entries, "value").is_none() {
        lacking.push(("value", format!("value = \"... {}\"", law.unit)));
    }
    if field::get(entries, "width").is_none() && !last {
        lacking.push((
            "width",
            format!("width = \"... {phase_unit}\"  # only the last step may leave it out"),
        ));
    }
    field::missing(&lacking, &format!("`{path}`"), &node.place, report);
    let mut read = |key: &str, unit: &str, zero: bool| {
        let node = field::get(entries, key)?;
        let x = field::quantity(&format!("{path}.{key}"), node, unit, report)?;
        if x > 0.0 || (zero && x == 0.0) {
            return Some(x);
        }
        let must = if zero {
            "must not be negative"
        } else {
            "must be positive"
        };
        report.add(
            &node.place,
            format!("`{path}.{key}` is out of range"),
            must,
            format!("give {unit}, {must}"),
        );
        None
    };
    let value = read("value", law.unit, true);
    let width = read("width", phase_unit, false);
    let width_ok = width.is_some() || (last && field::get(entries, "width").is_none());
    (lacking.is_empty() && width_ok).then_some((value?, width))
}

/// Gives the last level the rest of the pitch, or checks that nothing is left of it.
fn fill(
    path: &str,
    node: &Node,
    levels: Vec<(f64, Option<f64>)>,
    pitch: f64,
    unit: &str,
    report: &mut Report,
) -> Option<Stiffness> {
    let given: f64 = levels.iter().filter_map(|(_, width)| *width).sum();
    let rest = pitch - given;
    let open = levels.iter().any(|(_, width)| width.is_none());
    if open && rest <= 0.0 {
        let message = format!("`{path}` leaves nothing of the pitch to its last step");
        let help = format!(
            "the widths before it add up to {given} {unit}; they must stay below one pitch, {pitch} {unit}"
        );
        report.add(&node.place, message, "too wide", help);
        return None;
    }
    if !open && (rest / pitch).abs() > PITCH_TOLERANCE {
        let message = format!("the widths of `{path}` do not add up to one pitch");
        let help = format!(
            "they add up to {given} {unit}, one pitch is {pitch} {unit}\nleave out the last width: it is then the rest"
        );
        report.add(
            &node.place,
            message,
            if rest > 0.0 { "too narrow" } else { "too wide" },
            help,
        );
        return None;
    }
    let steps = levels
        .into_iter()
        .map(|(value, width)| Step {
            value,
            width: width.unwrap_or(rest),
        })
        .collect();
    Some(Stiffness { steps })
}
