//! The controls of a scene: a slider for each number that it states or may state, a check box for each effect, the solver.

use std::collections::HashMap;

use serde::Serialize;

use super::choice::si;
use super::text::Leaf;
use crate::library::usual_value;
use crate::model::{Parameter, Range, Varies};
use crate::scene::quantity::split;
use crate::scene::solver::Method;
use crate::scene::text::Text;
use crate::scene::{Effects, Scene};

/// A slider and a field for a number.
#[derive(Debug, Serialize)]
pub(super) struct Control {
    /// Key in the scene: `parameters.T0`.
    key: String,
    /// Title of the group of controls that it belongs to.
    group: String,
    /// Name in its group.
    label: String,
    /// Its description; may be empty.
    doc: String,
    /// The unit of its numbers, as the scene writes it; empty for a plain number.
    unit: String,
    /// The number.
    value: f64,
    /// Ends of the slider. The field takes numbers beyond them.
    low: f64,
    high: f64,
    /// Whether the scale of the slider is logarithmic.
    log: bool,
    /// Whether the slider has whole numbers only.
    whole: bool,
}

/// A check box.
#[derive(Debug, Serialize)]
pub(super) struct EffectBox {
    name: &'static str,
    doc: &'static str,
    on: bool,
}

/// The solver keys of the scene.
#[derive(Debug, Serialize)]
pub(super) struct SolverFields {
    methods: Vec<&'static str>,
    method: Option<String>,
    tolerance: Option<f64>,
    step: Option<f64>,
}

/// The numbers that a scene may state but does not, each with its unit and default value.
pub(super) fn offered(scene: &Scene, text: &Text) -> Vec<Leaf> {
    let names = text.names("effects");
    let effects = Effects::from_names(names.iter().map(String::as_str), scene.model);
    let active =
        |with: Option<&str>| with.is_none_or(|e| effects.as_ref().is_some_and(|effects| effects.has(e, scene.model)));
    let leaf = |table: &str, name: &str, number: f64, unit: &str| Leaf {
        path: vec![table.into(), name.into()],
        number,
        unit: if unit == "1" { String::new() } else { unit.into() },
        whole: false,
    };
    // The parameters of a train are in the tables of its parts; a train has no table `parameters`.
    let parameters = scene.model.parameters.iter().filter(|p| scene.train.is_none() && active(p.with));
    let parameters = parameters.filter_map(|p| Some(leaf("parameters", p.name, p.default?, p.unit)));
    let motions = scene
        .model
        .motions
        .iter()
        .map(|motion| leaf("start", motion.name, 0.0, if motion.unit == "rad/s" { "rpm" } else { motion.unit }));
    let all = parameters.chain(motions);
    all.filter(|leaf| text.at(&leaf.path.iter().map(String::as_str).collect::<Vec<_>>()).is_none()).collect()
}

/// The sliders of a text; `first` has the numbers, by key, that determine their ranges.
pub(super) fn controls(scene: &Scene, text: &Text, first: &HashMap<String, f64>) -> Vec<Control> {
    let stated = text.leaves().into_iter().filter(|leaf| match leaf.path[0].as_str() {
        // The solver has its own fields, and keys of `[output]` are no parameters.
        "output" => false,
        "run" => leaf.path[1..] == ["t_end"],
        _ => leaf.path.len() > 1,
    });
    let all = stated.chain(offered(scene, text));
    let mut controls: Vec<_> = all.map(|leaf| control(scene, leaf, first)).collect();
    let order = |control: &Control| match control.key.split('.').next() {
        Some("parameters") => 0,
        Some("start") => 1,
        Some("run") => 3,
        _ => 2,
    };
    controls.sort_by_key(order);
    controls
}

fn control(scene: &Scene, leaf: Leaf, first: &HashMap<String, f64>) -> Control {
    let key = leaf.key();
    let parameter = scene.model.parameters.iter().find(|p| leaf.path[..] == ["parameters", p.name]);
    let (group, label) = named(&leaf.path);
    let from = first.get(&key).copied().unwrap_or(leaf.number);
    let (low, high) = range(scene, &leaf, from, parameter);
    Control {
        group,
        label,
        doc: doc(scene, &leaf.path).into(),
        log: low > 0.0 && !leaf.whole,
        low,
        high,
        whole: leaf.whole && from.abs() >= 2.0,
        value: leaf.number,
        unit: leaf.unit,
        key,
    }
}

/// The group and the label of a path.
fn named(path: &[String]) -> (String, String) {
    let (head, tail) = match path[0].as_str() {
        "parameters" => ("Parameters".into(), &path[1..]),
        "start" => ("Start".into(), &path[1..]),
        "run" => ("Run".into(), &path[1..]),
        "laws" => (format!("Law {}", path[1]), &path[2..]),
        table => (table.to_owned(), &path[1..]),
    };
    (head, tail.join("."))
}

/// The model's description of the value at a path.
fn doc(scene: &Scene, path: &[String]) -> &'static str {
    let model = scene.model;
    let found = match (path[0].as_str(), path.get(1).map_or("", String::as_str)) {
        ("parameters", name) => model.parameters.iter().find(|p| p.name == name).map(|p| p.doc),
        ("laws", name) => model.laws.iter().find(|law| law.name == name).map(|law| law.doc),
        ("start", name) => {
            let coordinate = model.coordinates.iter().find(|c| c.name == name).map(|c| c.doc);
            coordinate.or_else(|| model.motions.iter().find(|m| m.name == name).map(|m| m.doc))
        }
        ("run", "t_end") => Some("end of the run"),
        _ => None,
    };
    found.unwrap_or_default()
}

/// The ends of a slider whose number is `from` at first: a quarter of it and four times it; if it is negative, four times it to both sides;
/// if it is 0, a usual size to both sides. They are limited to the range of the parameter.
fn range(scene: &Scene, leaf: &Leaf, from: f64, parameter: Option<&Parameter>) -> (f64, f64) {
    let (low, high) = match from {
        0.0 => {
            let size = usual(scene, leaf, parameter);
            (-size, size)
        }
        x if x < 0.0 => (4.0 * x, -4.0 * x),
        x if leaf.whole => ((x / 4.0).ceil(), 4.0 * x),
        x => (x / 4.0, 4.0 * x),
    };
    let Some(Range { low: least, high: most, .. }) = parameter.map(|p| p.range) else { return (low, high) };
    let factor = si(1.0, &leaf.unit);
    (low.max(least / factor), high.min(most / factor))
}

/// The usual size of a number that is 0, in its unit.
fn usual(scene: &Scene, leaf: &Leaf, parameter: Option<&Parameter>) -> f64 {
    let coordinate = scene.model.coordinates.iter().find(|c| leaf.path[..] == ["start", c.name]);
    let motion = scene.model.motions.iter().find(|m| leaf.path[..] == ["start", m.name]);
    let unit = parameter.map(|p| p.unit).or(coordinate.map(|c| c.unit)).or(motion.map(|m| m.unit)).unwrap_or("1");
    let all = Range { low: f64::NEG_INFINITY, high: f64::INFINITY, low_included: false, high_included: false };
    let doc = parameter.map_or("", |p| p.doc);
    let like = Parameter {
        name: "",
        unit,
        default: None,
        with: None,
        gear_data: None,
        varies: Varies::Never,
        range: all,
        above: None,
        doc,
    };
    let text = usual_value(&like);
    let size = split(text.trim_matches('"')).map_or(1.0, |(number, unit)| si(number, unit));
    size / si(1.0, &leaf.unit)
}

/// The check boxes of a text.
pub(super) fn effects(scene: &Scene, text: &Text) -> Vec<EffectBox> {
    let names = text.names("effects");
    let set = Effects::from_names(names.iter().map(String::as_str), scene.model).unwrap_or(Effects::none(scene.model));
    let effects = scene.model.effects.iter().enumerate();
    effects.map(|(i, effect)| EffectBox { name: effect.name, doc: effect.doc, on: set.contains(i) }).collect()
}

/// The fields of the solver of a text.
pub(super) fn solver(text: &Text) -> SolverFields {
    let number = |key: &str| text.leaves().into_iter().find(|leaf| leaf.path == ["run", key]);
    SolverFields {
        methods: Method::ALL.iter().map(|(_, name)| *name).collect(),
        method: text.at(&["run", "method"]).and_then(|item| Some(item.as_str()?.to_owned())),
        tolerance: number("tolerance").map(|leaf| leaf.number),
        step: number("step").map(|leaf| si(leaf.number, &leaf.unit)),
    }
}
