//! The meshes of a train as its tables state them. The laws of meshes are checked against them, whatever the parts are called.

use std::collections::HashMap;

use super::draft::{Draft, named};
use crate::scene::meshes::{Gear, Mesh};

/// Quantities of a mesh that are laws of its teeth.
const LAWS: [&str; 3] = ["k", "side", "arm"];

/// A mesh, by the names of its parameters.
struct NamedMesh {
    /// Title of its table.
    title: String,
    /// Numbers of teeth of its gears.
    teeth: [String; 2],
    /// Base radius and number of teeth of the first gear of its group of gears that mesh with one another.
    radius: [String; 2],
    angle: String,
    /// Tangent of the base helix angle, if the mesh states a helix angle.
    tangent: Option<String>,
    internal: bool,
}

/// The meshes of a train, by the names of their laws.
pub(in crate::scene) struct Meshes(HashMap<String, NamedMesh>);

/// The meshes in the tables.
pub(super) fn of(draft: &Draft) -> Meshes {
    let mut meshes = HashMap::new();
    for group in &draft.groups {
        for ((&part, gears), (title, internal)) in group.parts.iter().zip(&group.meshes).zip(&group.stated) {
            let part = &draft.parts[part];
            let angle = part.renamed.iter().find(|renamed| renamed.0 == "alpha");
            let tangent = draft.axial_forces.iter().find(|(mesh, _)| *mesh == part.name);
            for law in LAWS {
                let mesh = NamedMesh {
                    title: title.clone(),
                    teeth: gears.map(|i| group.gears[i].teeth.clone()),
                    radius: [group.radius.clone(), group.gears[0].teeth.clone()],
                    angle: angle.map_or_else(|| "alpha".into(), |renamed| renamed.1.clone()),
                    tangent: tangent.map(|(_, tangent)| tangent.clone()),
                    internal: *internal,
                };
                meshes.insert(named(law, &part.name), mesh);
            }
        }
    }
    Meshes(meshes)
}

impl Meshes {
    /// Whether the second gear of the mesh of a law is a ring.
    pub fn internal(&self, law: &str) -> Option<bool> {
        self.0.get(law).map(|mesh| mesh.internal)
    }

    /// The mesh of a law; `value` has the values of the parameters.
    pub fn of_law(&self, law: &str, value: &dyn Fn(&str) -> Option<f64>) -> Option<Mesh> {
        let mesh = self.0.get(law)?;
        let [radius, first] = &mesh.radius;
        let gear = |name: &String| {
            let teeth = value(name).filter(|z| z.is_finite());
            let r = || Some(value(radius)? * teeth? / value(first)?);
            Gear { teeth: teeth.map(|z| (z, format!("{name} = {z}"))), radius: r().map(|r| (radius.clone(), r)) }
        };
        Some(Mesh {
            title: Some(mesh.title.clone()),
            gears: mesh.teeth.each_ref().map(gear),
            angle: Some(mesh.angle.clone()),
            tangent: mesh.tangent.as_ref().and_then(|name| value(name)),
            internal: Some(mesh.internal),
        })
    }
}
