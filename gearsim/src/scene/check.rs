//! From the tree of a scene to a scene, with everything that is wrong reported in one go.

use super::document::{Entry, Node, Place, Value};
use super::error::{Report, did_you_mean, list};
use super::{Beginning, Output, PLOTS, Scene, Stiffness, effects, field, laws};
use crate::model::{Model, Parameter, Range, Start};

const KEYS: [&str; 8] = [
    "about",
    "model",
    "effects",
    "parameters",
    "laws",
    "start",
    "run",
    "output",
];

/// Samples that a run may record: some gigabytes.
const MAX_SAMPLES: f64 = 1e8;

/// Samples of a run that states no rate.
const DEFAULT_SAMPLES: f64 = 1e4;

/// Reads a scene without name and hash; `end` is where tables would be added. `None` only if something is reported.
pub(super) fn scene(
    root: &Node,
    end: &Place,
    models: &[&'static Model],
    report: &mut Report,
) -> Option<Scene> {
    let Value::Table(entries) = &root.value else {
        return None;
    };
    field::known_keys(entries, "a scene", &KEYS, report);
    let mut lacking = Vec::new();
    for (key, line) in [
        ("model", "model = \"...\""),
        ("effects", "effects = []  # or the names of some"),
    ] {
        if field::get(entries, key).is_none() {
            lacking.push((key, line.to_string()));
        }
    }
    field::missing(&lacking, "the scene", &root.place, report);

    let about = field::get(entries, "about")
        .and_then(|node| field::text("about", node, report))
        .unwrap_or_default();
    let t_end = run(entries, end, report);
    let output = output(entries, t_end, report);
    let model = field::get(entries, "model").and_then(|node| model(node, models, report))?;
    let effects =
        field::get(entries, "effects").and_then(|node| effects::read(node, model, report));
    let parameters = parameters(entries, end, model, report);
    let laws = stiffnesses(entries, end, model, report);
    let start = start(entries, model, report);
    Some(Scene {
        name: String::new(),
        about: about.to_string(),
        model,
        effects: effects?,
        parameters: parameters?,
        laws: laws?,
        start: start?,
        t_end: t_end?,
        output: output?,
        hash: String::new(),
    })
}

fn model(node: &Node, models: &[&'static Model], report: &mut Report) -> Option<&'static Model> {
    let name = field::text("model", node, report)?;
    let found = models.iter().copied().find(|model| model.name == name);
    if found.is_none() {
        let names: Vec<_> = models.iter().map(|model| model.name).collect();
        let hint = did_you_mean(name, names.iter().copied())
            .map(|near| format!("did you mean `{near}`?\n"));
        let lines: Vec<_> = models
            .iter()
            .map(|model| format!("{}: {}", model.name, model.title))
            .collect();
        let help = format!(
            "{}the models are\n{}",
            hint.unwrap_or_default(),
            lines.join("\n")
        );
        report.add(
            &node.place,
            format!("there is no model `{name}`"),
            "unknown model",
            help,
        );
    }
    found
}

fn parameters(
    entries: &[Entry],
    end: &Place,
    model: &Model,
    report: &mut Report,
) -> Option<Vec<f64>> {
    let node = field::get(entries, "parameters");
    let given = node.map_or(Some(&[][..]), |node| {
        field::table("parameters", node, report)
    })?;
    let names: Vec<_> = model
        .parameters
        .iter()
        .map(|parameter| parameter.name)
        .collect();
    field::known_keys(given, "[parameters]", &names, report);
    let lacking: Vec<_> = model
        .parameters
        .iter()
        .filter(|p| p.default.is_none() && field::get(given, p.name).is_none())
        .collect();
    let mut lines: Vec<_> = lacking.iter().map(|p| (p.name, example(p))).collect();
    if let (None, Some((_, first))) = (node, lines.first_mut()) {
        first.insert_str(0, "[parameters]\n");
    }
    field::missing(
        &lines,
        "[parameters]",
        node.map_or(end, |node| &node.place),
        report,
    );
    let values: Vec<_> = model
        .parameters
        .iter()
        .map(|parameter| match field::get(given, parameter.name) {
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
    let x = field::quantity(&path, node, parameter.unit, report)?;
    if parameter.range.contains(x) {
        return Some(x);
    }
    let must = describe(&parameter.range, parameter.unit);
    report.add(
        &node.place,
        format!("`{path}` is out of range"),
        &must,
        format!("{}: {must}", parameter.doc),
    );
    None
}

fn describe(range: &Range, unit: &str) -> String {
    let unit = if unit == "1" {
        String::new()
    } else {
        format!(" {unit}")
    };
    let low = match (range.low, range.low_included) {
        (f64::NEG_INFINITY, _) => None,
        (0.0, true) => Some("must not be negative".to_string()),
        (0.0, false) => Some("must be positive".to_string()),
        (low, true) => Some(format!("must be at least {low}{unit}")),
        (low, false) => Some(format!("must be more than {low}{unit}")),
    };
    let high = match (range.high, range.high_included) {
        (f64::INFINITY, _) => None,
        (high, true) => Some(format!("must be at most {high}{unit}")),
        (high, false) => Some(format!("must be less than {high}{unit}")),
    };
    [low, high]
        .into_iter()
        .flatten()
        .collect::<Vec<_>>()
        .join(" and ")
}

fn stiffnesses(
    entries: &[Entry],
    end: &Place,
    model: &Model,
    report: &mut Report,
) -> Option<Vec<Stiffness>> {
    match field::get(entries, "laws") {
        Some(node) => laws::read(node, model, report),
        None => {
            let lines: Vec<_> = model
                .laws
                .iter()
                .map(|law| (law.name, laws::example(law)))
                .collect();
            field::missing(&lines, "[laws]", end, report);
            model.laws.is_empty().then(Vec::new)
        }
    }
}

fn start(entries: &[Entry], model: &Model, report: &mut Report) -> Option<Beginning> {
    let node = field::get(entries, "start");
    let given = node.map_or(Some(&[][..]), |node| field::table("start", node, report))?;
    let speeds: Vec<_> = model
        .coordinates
        .iter()
        .map(|c| (format!("{}_dot", c.name), format!("{}/s", c.unit)))
        .collect();
    let allowed: Vec<_> = (model.coordinates.iter().map(|coordinate| coordinate.name))
        .chain(speeds.iter().map(|(name, _)| name.as_str()))
        .chain(model.motions.iter().map(|motion| motion.name))
        .collect();
    field::known_keys(given, "[start]", &allowed, report);

    let is_static = |node: &Node| matches!(&node.value, Value::Text(text) if text == "static");
    // A key that is not there is `Some(None)`; one that is there and wrong is `None`.
    let mut speed = |name: &str, unit: &str| match field::get(given, name) {
        None => Some(None),
        Some(node) if is_static(node) => {
            let help = format!(
                "write a speed, e.g. \"10 {unit}\"; {} can be \"static\"",
                list(&allowed[..model.coordinates.len()])
            );
            report.add(
                &node.place,
                format!("`start.{name}` cannot be \"static\""),
                "a speed",
                help,
            );
            None
        }
        Some(node) => field::quantity(&format!("start.{name}"), node, unit, report).map(Some),
    };
    let q_dot: Vec<_> = speeds
        .iter()
        .map(|(name, unit)| speed(name, unit))
        .collect();
    let motions: Vec<_> = model
        .motions
        .iter()
        .map(|m| speed(m.name, m.unit).map(Option::unwrap_or_default))
        .collect();
    let q: Vec<_> = (model.coordinates.iter())
        .map(|coordinate| match field::get(given, coordinate.name) {
            None => Some(coordinate.start),
            Some(node) if is_static(node) => Some(Start::Static),
            Some(node) => field::quantity(
                &format!("start.{}", coordinate.name),
                node,
                coordinate.unit,
                report,
            )
            .map(Start::At),
        })
        .collect();
    Some(Beginning {
        q: q.into_iter().collect::<Option<_>>()?,
        q_dot: q_dot.into_iter().collect::<Option<_>>()?,
        motions: motions.into_iter().collect::<Option<_>>()?,
    })
}

fn run(entries: &[Entry], end: &Place, report: &mut Report) -> Option<f64> {
    let Some(node) = field::get(entries, "run") else {
        field::missing(
            &[("t_end", "[run]\nt_end = \"... s\"".to_string())],
            "[run]",
            end,
            report,
        );
        return None;
    };
    let given = field::table("run", node, report)?;
    field::known_keys(given, "[run]", &["t_end"], report);
    let Some(node) = field::get(given, "t_end") else {
        field::missing(
            &[("t_end", "t_end = \"... s\"".to_string())],
            "[run]",
            &node.place,
            report,
        );
        return None;
    };
    let t_end = field::quantity("run.t_end", node, "s", report)?;
    // Also refuses ends so early that no sampling rate is finite.
    if t_end > 0.0 && (DEFAULT_SAMPLES / t_end).is_finite() {
        return Some(t_end);
    }
    report.add(
        &node.place,
        "`run.t_end` is out of range",
        "must be positive",
        "a run starts at 0 s: give a later end",
    );
    None
}

fn output(entries: &[Entry], t_end: Option<f64>, report: &mut Report) -> Option<Output> {
    let node = field::get(entries, "output");
    let given = node.map_or(Some(&[][..]), |node| field::table("output", node, report))?;
    field::known_keys(
        given,
        "[output]",
        &["rate", "events", "plots", "csv"],
        report,
    );
    let mut flag = |key: &str, default| match field::get(given, key) {
        Some(node) => field::flag(&format!("output.{key}"), node, report),
        None => Some(default),
    };
    let (events, csv) = (flag("events", true), flag("csv", false));
    let plots = match field::get(given, "plots") {
        Some(node) => field::names("output.plots", node, PLOTS, report),
        None => Some((0..PLOTS.len()).collect()),
    };
    let rate = match field::get(given, "rate") {
        Some(node) => rate(node, t_end, report),
        None => t_end.map(|t_end| DEFAULT_SAMPLES / t_end),
    };
    let plots = plots?.into_iter().map(|i| PLOTS[i].to_string()).collect();
    Some(Output {
        rate: rate?,
        events: events?,
        plots,
        csv: csv?,
    })
}

fn rate(node: &Node, t_end: Option<f64>, report: &mut Report) -> Option<f64> {
    let rate = field::quantity("output.rate", node, "Hz", report)?;
    if rate <= 0.0 {
        report.add(
            &node.place,
            "`output.rate` is out of range",
            "must be positive",
            "give the samples a second, e.g. \"20 kHz\"",
        );
        return None;
    }
    let samples = rate * t_end?;
    if samples > MAX_SAMPLES {
        let help = format!(
            "at most {MAX_SAMPLES:e} are kept: record at {:e} Hz or less, or end the run earlier",
            MAX_SAMPLES / t_end?
        );
        report.add(
            &node.place,
            format!("`output.rate` asks for {samples:.1e} samples"),
            "too many",
            help,
        );
        return None;
    }
    Some(rate)
}
