//! The full description of a model as text.

use crate::cli::terminal;
use crate::model::{Model, Parameter, Start};

/// A row of a list: its cells, and the description after them.
type Row = (Vec<String>, String);

/// Minimum width of descriptions [columns], even on a narrow terminal.
const NARROWEST: usize = 30;

/// The description of `model`, `width` columns wide if possible.
pub(in crate::cli) fn of(model: &Model, width: usize) -> String {
    let mut text = format!("{}  {}\nsource: {}\n", model.name, model.title, model.source);
    let mut add = |title: &str, rows: Vec<Row>| {
        if !rows.is_empty() {
            text += &format!("\n{title}\n{}", table(&rows, width));
        }
    };
    add("Coordinates ([start]; their speeds end in _dot)", coordinates(model));
    add("Parameters ([parameters])", model.parameters.iter().map(parameter).collect());
    add("Laws ([laws.NAME]): stiffnesses, transmission errors, friction", laws(model));
    add("Motions ([start]: gives every speed at once)", motions(model));
    add("Effects (effects = [...])", effects(model));
    let torques = model.torques.iter().map(|t| (vec![t.name.into()], t.doc.into()));
    add("Torques whose work is recorded", torques.collect());
    add("Outputs ([output] record = [...]; all of them if the scene does not say)", outputs(model));
    if !model.nonlinear.is_empty() {
        text += &format!("\nNonlinear terms: {}\n", model.nonlinear);
    }
    for (effects, term) in model.nonlinear_with {
        text += &format!("\nNonlinear with {}: {term}\n", effects.join(" and "));
    }
    text += "\nEquations\n";
    for line in model.equations.lines() {
        text += format!("  {line}").trim_end();
        text += "\n";
    }
    text
}

fn coordinates(model: &Model) -> Vec<Row> {
    let row = |c: &crate::model::Coordinate| {
        let start = match c.start {
            Start::At(x) => format!("starts at {x}"),
            Start::Static => "starts in static equilibrium".into(),
            Start::Near(x) => format!("starts in the static equilibrium near {x}"),
        };
        (vec![c.name.into(), unit(c.unit), start], c.doc.into())
    };
    model.coordinates.iter().map(row).collect()
}

fn parameter(p: &Parameter) -> Row {
    let default = match (p.default, p.with) {
        (Some(x), Some(effect)) => format!("default {x}, used with {effect}"),
        (Some(x), None) => format!("default {x}"),
        (None, Some(effect)) => format!("required with {effect}"),
        (None, None) => "required".into(),
    };
    let varies = if p.varies.may() { ", may vary in time" } else { "" };
    (vec![p.name.into(), unit(p.unit), default, format!("in {}{varies}", p.allowed())], p.doc.into())
}

fn laws(model: &Model) -> Vec<Row> {
    let row = |l: &crate::model::Law| {
        let with = l.with.map_or(String::new(), |effect| format!(", required with {effect}"));
        let period = format!("steps in {}, one pitch is {:.6}{with}", l.phase, l.period);
        (vec![l.name.into(), unit(l.unit), period], l.doc.into())
    };
    model.laws.iter().map(row).collect()
}

fn motions(model: &Model) -> Vec<Row> {
    model.motions.iter().map(|m| (vec![m.name.into(), unit(m.unit)], m.doc.into())).collect()
}

fn outputs(model: &Model) -> Vec<Row> {
    let with = |output: &crate::model::Output| output.with.map_or(String::new(), |effect| format!("with {effect}"));
    model.outputs.iter().map(|o| (vec![o.name.into(), unit(o.unit), with(o)], o.doc.into())).collect()
}

fn effects(model: &Model) -> Vec<Row> {
    let row = |e: &crate::model::Effect| {
        let mut words = e.doc.to_owned();
        if let Some(of) = e.of {
            words += &format!("\nthe effect `{of}` at one part; `{of}` is that of all parts");
        }
        for (verb, others) in [("needs", e.requires), ("excludes", e.excludes)] {
            if !others.is_empty() {
                words += &format!("\n{verb} {}", others.join(", "));
            }
        }
        (vec![e.name.into()], words)
    };
    model.effects.iter().map(row).collect()
}

fn unit(unit: &str) -> String {
    if unit == "1" { "-".into() } else { unit.into() }
}

/// Rows with aligned cells, followed by their descriptions, which are wrapped and indented.
fn table(rows: &[Row], width: usize) -> String {
    let columns = rows.iter().map(|(cells, _)| cells.len()).max().unwrap_or(0);
    let length = |text: &String| text.chars().count();
    let widths: Vec<_> = (0..columns)
        .map(|i| rows.iter().filter_map(|(cells, _)| cells.get(i)).map(length).max().unwrap_or(0))
        .collect();
    let mut text = String::new();
    for (cells, words) in rows {
        let cells: String = cells.iter().zip(&widths).map(|(cell, width)| format!("{cell:width$}  ")).collect();
        let indent = format!("  {}", " ".repeat(length(&cells)));
        let words = terminal::wrap(words, width.saturating_sub(indent.len()).max(NARROWEST));
        text += &format!("  {cells}{}\n", words.trim_end().replace('\n', &format!("\n{indent}")));
    }
    text
}
