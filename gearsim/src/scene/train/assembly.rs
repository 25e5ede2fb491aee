//! Whether the planets of a set can be assembled, and whether there is room for each of them.
//!
//! The phases that are computed from teeth and places hold only for planets that fit, with angles counted from a planet at 0 deg. Other
//! planets are refused if phases are computed. Otherwise they give a warning, because papers use planets that do not fit, with constant
//! stiffnesses.

use super::item::Item;
use super::read::Reader;
use crate::scene::assembly::{Narrow, misfit, narrow};
use crate::scene::document::{Node, Value};
use crate::scene::{field, keys};

impl Reader<'_> {
    /// Checks that the planets of a set fit at their `places`. The three nodes are the numbers of teeth of sun, ring and planets.
    pub(super) fn fit(&mut self, item: &Item<'_>, teeth: &[Node; 3], places: &[Node]) {
        let path = item.path("teeth");
        let teeth = teeth.each_ref().map(|node| field::quantity(&path, node, "1", self.report));
        let angles = places.iter().map(|node| field::quantity(&item.path("at"), node, "rad", self.report));
        let ([Some(sun), Some(ring), Some(planet)], Some(angles)) = (teeth, angles.collect::<Option<Vec<f64>>>())
        else {
            return;
        };
        let phased = ["sun_stiffness", "ring_stiffness"].into_iter().filter_map(|key| item.get(key)).any(follows);
        let Some(&first) = angles.first() else { return };
        match narrow([sun, ring, planet], &angles, &item.title()) {
            Some(Narrow::OnePlace(planet)) => {
                let message = format!("{} has two planets in one place", item.title());
                let help = "give each planet its own angle in `at`";
                self.report.add(&places[planet].place, message, "no place for a planet", help);
            }
            Some(Narrow::Tips(said)) => self.report.warn(said),
            None => {}
        }
        let from = if phased { 0.0 } else { first };
        let Some(mut found) = misfit([sun, ring], &angles, from, &item.title()) else { return };
        if item.get("at").is_none() {
            found.help += &format!("\nequally spaced planets fit if their number divides {}", sun + ring);
        }
        if phased {
            found.help += "\nthe phases of the meshes follow from teeth and places, counted from a planet at 0 deg";
            return self.report.add(&places[found.planet].place, found.message, "no place for a planet", found.help);
        }
        self.report.warn(format!("{}: {}", found.message, found.help.replace('\n', "; ")));
    }
}

/// Whether the phase of a law of a set is computed from teeth and places.
fn follows(law: &Node) -> bool {
    matches!(&law.value, Value::Table(entries) if keys::get(entries, "phase").is_none())
}
