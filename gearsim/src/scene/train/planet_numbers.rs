//! The numbers of a planet set: teeth of sun, ring and planets, and the places of the planets.

use super::item::Item;
use super::read::Reader;
use crate::scene::document::{Node, Value};
use crate::scene::field;
use crate::tolerance::scene::{PLANETS, USUAL_ANGLES};

impl Reader<'_> {
    /// The numbers of teeth of sun, ring and planets.
    pub(super) fn tooth_numbers(&mut self, item: &Item<'_>) -> Option<[Node; 3]> {
        let node = self.needed(item, "teeth", "[27, 99]  # of sun and ring")?;
        let path = format!("planets.{}.teeth", item.name);
        let [sun, ring] = field::array(&path, node, "[27, 99]", self.report)? else {
            let help = "those of sun and ring: teeth = [27, 99]; those of the planets are planet_teeth";
            self.report.add(&node.place, format!("`{path}` must have two numbers"), "two numbers", help);
            return None;
        };
        let numbers = [sun, ring].map(|node| field::quantity(&path, node, "1", self.report));
        let [Some(s), Some(r)] = numbers else { return None };
        if r <= s {
            let help = "the ring has more teeth than the sun: teeth = [27, 99]";
            self.report.add(
                &ring.place,
                format!("`{path}` has a ring of {r} teeth round a sun of {s}"),
                "too few",
                help,
            );
            return None;
        }
        let half = (r - s) / 2.0;
        let planet = match item.get("planet_teeth") {
            Some(planet) => {
                let p = field::quantity(&item.path("planet_teeth"), planet, "1", self.report)?;
                self.between_gears(item, [s, r, p], planet).then(|| planet.clone())
            }
            None if half.fract() != 0.0 && s.fract() == 0.0 && r.fract() == 0.0 => {
                let message = format!(
                    "{} lacks `planet_teeth`: half the difference of {r} and {s} teeth is {half}",
                    item.title()
                );
                let help = format!(
                    "give the planets a whole number of teeth, planet_teeth = {} or {}; profile shift makes them fit",
                    half.floor(),
                    half.ceil()
                );
                self.report.add(&node.place, message, "no whole number of planet teeth", help);
                None
            }
            None => Some(Node { value: Value::Number(half), place: node.place.clone() }),
        };
        Some([sun.clone(), ring.clone(), planet?])
    }

    /// Refuses planets that do not mesh with sun and ring at one centre distance, cos(alpha_s)/cos(alpha_r) = (Z_s + Z_p)/(Z_r - Z_p) with the
    /// working pressure angles alpha, whatever the profile shift.
    fn between_gears(&mut self, item: &Item<'_>, [sun, ring, planet]: [f64; 3], node: &Node) -> bool {
        let [low, high] = [USUAL_ANGLES.start(), USUAL_ANGLES.end()].map(|angle| angle.to_radians().cos());
        let ratio = (sun + planet) / (ring - planet);
        let fits = planet < ring && (high / low..=low / high).contains(&ratio);
        if !fits {
            let message = format!(
                "`{}` is {planet}, but planets of {planet} teeth do not mesh with a sun of {sun} and a ring of {ring} teeth at one \
                 centre distance",
                item.path("planet_teeth")
            );
            let half = (ring - sun) / 2.0;
            let help = format!(
                "without profile shift they have {half} teeth, half the difference; with it a few more or less"
            );
            self.report.add(&node.place, message, "impossible planets", help);
        }
        fits
    }

    /// The angles of the planets.
    pub(super) fn places(&mut self, item: &Item<'_>) -> Option<Vec<Node>> {
        if let Some(node) = item.get("at") {
            if item.get("count").is_some() {
                let message = format!("{} has `count` and `at`", item.title());
                self.report.add(&node.place, message, "twice", "leave out `count`: it is the number of angles");
            }
            let path = format!("planets.{}.at", item.name);
            let angles = field::array(&path, node, "[\"0 deg\", \"120 deg\", \"240 deg\"]", self.report)?;
            let read = angles.iter().map(|angle| field::quantity(&path, angle, "rad", self.report));
            let read: Option<Vec<_>> = read.collect();
            return read.filter(|angles| self.is_number_of_planets(angles.len() as f64, node)).map(|_| angles.to_vec());
        }
        let node = self.needed(item, "count", "3")?;
        let count = field::quantity(&format!("planets.{}.count", item.name), node, "1", self.report)?;
        if !self.is_number_of_planets(count, node) {
            return None;
        }
        let angle = |i: usize| format!("{} rad", std::f64::consts::TAU * i as f64 / count);
        Some((0..count as usize).map(|i| Node { value: Value::Text(angle(i)), place: node.place.clone() }).collect())
    }

    fn is_number_of_planets(&mut self, count: f64, node: &Node) -> bool {
        let fits = (1.0..=PLANETS).contains(&count) && count.fract() == 0.0;
        if !fits {
            let message = format!("a set has 1 to {PLANETS} planets, not {count}");
            self.report.add(&node.place, message, "number of planets", "for example count = 3");
        }
        fits
    }
}
