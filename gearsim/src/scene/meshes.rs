//! The mesh to which a law belongs, as the rest of the scene states it: in the tables of a train, or by the names of a derived model.
//!
//! The name of a law of a derived model states its mesh: `k12` of gears 1 and 2, `k_s1` of sun and planet, `k_r1` of planet and ring, `k` of
//! a model with two gears.

use super::document::{KeyEntry, Node, Value};
use super::gear_data::{of_mesh, part_of, teeth};
use super::keys;
use super::train::Meshes;
use crate::model::{GearData, Model};

/// The mesh of a law.
pub(super) struct Mesh {
    /// Title of the table of the mesh in a train, e.g. `[meshes.12]`; `None` in other models.
    pub title: Option<String>,
    /// The driving gear, and the driven one.
    pub gears: [Gear; 2],
    /// The parameter that is its pressure angle; `None`: the first angle of the model.
    pub angle: Option<String>,
    /// Tangent of the base helix angle, if the mesh states a helix angle.
    pub tangent: Option<f64>,
    /// Whether the second gear is a ring; `None` if that is not known.
    pub internal: Option<bool>,
}

impl Mesh {
    /// Numbers of teeth of both gears.
    pub fn teeth(&self) -> Option<[f64; 2]> {
        let [a, b] = self.gears.each_ref().map(|gear| gear.teeth.as_ref().map(|teeth| teeth.0));
        Some([a?, b?])
    }
}

/// A gear of a mesh.
pub(super) struct Gear {
    /// Number of teeth, and where it comes from.
    pub teeth: Option<(f64, String)>,
    /// The parameter that states its base radius, and the base radius [m].
    pub radius: Option<(String, f64)>,
}

/// The mesh to which a law belongs. In a train it is found in the tables, `train`. In another model it is found by the names of its parameters.
/// `value` gives the value of a parameter.
pub(super) fn of_law(
    law: &str,
    model: &Model,
    train: Option<&Meshes>,
    value: &dyn Fn(&str) -> Option<f64>,
) -> Option<Mesh> {
    if let Some(train) = train {
        return train.of_law(law, value);
    }
    let radius = |gear: &str| {
        let is_radius =
            |name: &str| model.parameters.iter().any(|p| p.name == name && p.gear_data == Some(GearData::BaseRadius));
        let name = format!("r{gear}");
        Some((name.clone(), value(&name).filter(|_| is_radius(&name))?))
    };
    let gears = of_mesh(law).map(|gear| Gear { teeth: teeth(&gear, value), radius: radius(&gear) });
    let own = format!("alpha{}", part_of(law));
    let angle = model.parameters.iter().any(|p| p.name == own).then_some(own);
    Some(Mesh { title: None, gears, angle, tangent: None, internal: internal(law, None) })
}

/// Whether the second gear of the mesh of a law is a ring; `None` if that is not known.
fn internal(law: &str, train: Option<&Meshes>) -> Option<bool> {
    if let Some(train) = train {
        return train.internal(law);
    }
    match of_mesh(law).each_ref().map(String::as_str) {
        [_, "_r"] => Some(true),
        ["_s", _] => Some(false),
        _ => None,
    }
}

/// Adds `internal = true` to the laws from teeth that do not state `internal`, if their mesh is that of a ring.
pub(super) fn infer_rings(entries: &mut [KeyEntry], model: &Model, train: Option<&Meshes>) {
    let laws = entries.iter_mut().find(|entry| entry.key == "laws").map(|entry| &mut entry.node.value);
    let Some(Value::Table(laws)) = laws else { return };
    for KeyEntry { key, node: Node { value, place }, .. } in laws {
        let Value::Table(law) = value else { continue };
        let given = |key: &str| keys::get(law, key).is_some();
        let known = model.laws.iter().any(|law| law.name == key);
        if known && given("teeth") && !given("internal") && internal(key, train) == Some(true) {
            let node = Node { value: Value::Flag(true), place: place.clone() };
            law.push(KeyEntry { key: "internal".into(), place: place.clone(), node });
        }
    }
}
