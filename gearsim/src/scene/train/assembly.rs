//! Whether the planets of a set can be assembled.
//!
//! The phases that follow from teeth and places hold for planets that fit, counted from a planet at 0 deg: others are refused. Where no
//! phase follows, they give a warning: papers take planets that do not fit, with constant stiffnesses.

use super::item::Item;
use super::read::Reader;
use crate::scene::assembly::misfit;
use crate::scene::document::{Node, Value};
use crate::scene::{field, keys};
use crate::tolerance::scene::ONE_PLACE;

impl Reader<'_> {
    /// Checks that the planets of a set fit at their `places`. The three nodes are the numbers of teeth of the set, first those of sun and ring.
    pub(super) fn fit(&mut self, item: &Item<'_>, [sun, ring, _]: &[Node; 3], places: &[Node]) {
        let path = item.path("teeth");
        let teeth = [sun, ring].map(|node| field::quantity(&path, node, "1", self.report));
        let angles = places.iter().map(|node| field::quantity(&item.path("at"), node, "rad", self.report));
        let ([Some(sun), Some(ring)], Some(angles)) = (teeth, angles.collect::<Option<Vec<f64>>>()) else { return };
        let phased = ["sun_stiffness", "ring_stiffness"].into_iter().filter_map(|key| item.get(key)).any(follows);
        let Some(&first) = angles.first() else { return };
        if let Some((planet, distance)) = nearest([sun, ring], &angles) {
            self.clear_of_neighbour(item, [sun, ring], (&places[planet], distance));
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

impl Reader<'_> {
    /// Refuses planets in one place, and warns of planets whose tips would meet. `distance` is that of the centres of two neighbours, over the module.
    fn clear_of_neighbour(&mut self, item: &Item<'_>, [sun, ring]: [f64; 2], (place, distance): (&Node, f64)) {
        let teeth = (ring - sun) / 2.0;
        let said =
            format!("{}: the centres of two planets with {teeth} teeth are {distance:.1} modules apart", item.title());
        let standard = teeth + 2.0 * ADDENDUM;
        if distance < ONE_PLACE * teeth {
            let message = format!("{} has two planets in one place", item.title());
            self.report.add(&place.place, message, "no place for a planet", "give each planet its own angle in `at`");
        } else if distance < standard {
            let diameter = format!("standard teeth have a tip diameter of {standard} modules");
            self.report
                .warn(format!("{said}, but {diameter}: the planets collide unless they lie in different planes"));
        }
    }
}

/// Addendum of standard teeth [modules].
const ADDENDUM: f64 = 1.0;

/// The planet that is nearest to another one, and the distance of their centres [modules]; `None` for one planet.
fn nearest([sun, ring]: [f64; 2], angles: &[f64]) -> Option<(usize, f64)> {
    let centre = (sun + ring) / 4.0;
    let pairs = (0..angles.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    let apart = pairs.map(|(i, j)| (i, 2.0 * centre * (0.5 * (angles[i] - angles[j])).sin().abs()));
    apart.min_by(|a, b| a.1.total_cmp(&b.1))
}

/// Whether the phase of the law of a set follows from teeth and places.
fn follows(law: &Node) -> bool {
    matches!(&law.value, Value::Table(entries) if keys::get(entries, "phase").is_none())
}
