//! `[start]`: the initial coordinates and speeds.

use super::document::{KeyEntry, Node, Value};
use super::keys::{Kind, Named, each};
use super::mistake::{Report, list};
use super::{InitialState, field, keys};
use crate::model::{Model, Start};

/// Keys that a scene may have.
pub(super) const NAMED: &[Named] = &[
    each("COORDINATE", Kind::ValueIn(STATIC), "set by the model", "initial value of a coordinate"),
    each("COORDINATE_dot", UNIT, "that of the rigid motions", "initial speed of a coordinate"),
    each("MOTION", UNIT, "0", "speed of a rigid motion of the model"),
];
const UNIT: Kind = Kind::ValueIn("unit of the speed");
const STATIC: &str = "unit of the coordinate; \"static\": the static equilibrium; \"static near 0.1 rad\": of several, the one found from there";

/// Reads `[start]`. The table and all its keys may be left out.
pub(super) fn read(entries: &[KeyEntry], model: &Model, report: &mut Report) -> Option<InitialState> {
    let node = keys::get(entries, "start");
    let given = node.map_or(Some(&[][..]), |node| field::table("start", node, report))?;
    let places: Vec<_> = model.coordinates.iter().map(|c| c.name).collect();
    let speeds: Vec<_> = places.iter().map(|name| format!("{name}_dot")).collect();
    let motions = model.motions.iter().map(|motion| motion.name);
    let allowed: Vec<_> = places.iter().copied().chain(speeds.iter().map(String::as_str)).chain(motions).collect();
    let is_motion = |entry: &KeyEntry| model.motions.is_empty() && entry.key.starts_with("speed");
    let (motions, others): (Vec<KeyEntry>, Vec<KeyEntry>) = given.iter().cloned().partition(is_motion);
    for entry in motions {
        let message = format!("[start] has no `{}`: nothing in the model turns freely", entry.key);
        let why = "springs to the ground, or loops of parts with different ratios, hold each rotor";
        let help = format!("{why}; give speeds of coordinates\nallowed: {}", list(&allowed));
        report.add(&entry.place, message, "a rigid motion", help);
    }
    keys::names_known(&others, "[start]", &allowed, report);

    // `Some(None)` for a key that is not given, `None` for a mistake.
    let mut speed = |name: &str, unit: &str| match keys::get(given, name) {
        None => Some(None),
        Some(node) if is_static(node) => {
            let message = format!("`start.{name}` cannot be \"static\"");
            let help = format!("write a speed, e.g. \"1 {unit}\"; \"static\" is allowed for {}", list(&places));
            report.add(&node.place, message, "a speed", help);
            None
        }
        Some(node) => field::quantity(&format!("start.{name}"), node, unit, report).map(Some),
    };
    let q_dot: Vec<_> = (model.coordinates.iter().zip(&speeds))
        .map(|(coordinate, name)| speed(name, &format!("{}/s", coordinate.unit)))
        .collect();
    let motions: Vec<_> =
        (model.motions.iter()).map(|motion| speed(motion.name, motion.unit).map(Option::unwrap_or_default)).collect();
    let q: Vec<_> = (model.coordinates.iter())
        .map(|coordinate| match keys::get(given, coordinate.name) {
            None => Some(coordinate.start),
            Some(node) if is_static(node) => Some(Start::Static),
            Some(node @ Node { value: Value::Text(text), .. }) if text.starts_with("static near ") => {
                // The rest of the text is a quantity. Mistakes in it are reported as for any quantity.
                let rest = Node { value: Value::Text(text["static near ".len()..].to_owned()), ..node.clone() };
                let path = format!("start.{}", coordinate.name);
                field::quantity(&path, &rest, coordinate.unit, report).map(Start::Near)
            }
            Some(Node { value: Value::Text(text), place }) if text.trim_start().starts_with(char::is_alphabetic) => {
                let message = format!("`start.{}` cannot be \"{text}\"", coordinate.name);
                let help =
                    format!("write \"static\", a quantity, \"0.1 {0}\", or \"static near 0.1 {0}\"", coordinate.unit);
                report.add(place, message, "neither static nor a quantity", help);
                None
            }
            Some(node) => {
                let path = format!("start.{}", coordinate.name);
                field::quantity(&path, node, coordinate.unit, report).map(Start::At)
            }
        })
        .collect();
    Some(InitialState {
        q: q.into_iter().collect::<Option<_>>()?,
        q_dot: q_dot.into_iter().collect::<Option<_>>()?,
        motions: motions.into_iter().collect::<Option<_>>()?,
    })
}

fn is_static(node: &Node) -> bool {
    matches!(&node.value, Value::Text(text) if text == "static")
}
