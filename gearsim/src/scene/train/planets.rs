//! Planet sets: a sun, a ring and a carrier, and planets whose centres are fixed to the carrier.

use super::draft::{DraftGear, DraftPart, Geometry, PlanetSet, Rotor, Term, named};
use super::gears::{LAW, is_rigid};
use super::item::Item;
use super::read::Reader;
use super::{ELSEWHERE, ROTOR, axial, bodies};
use crate::model::GearData;
use crate::scene::document::{KeyEntry, Node, Value};
use crate::scene::keys::{self, Key, Kind, Named, REQUIRED, each, key};
use crate::scene::time_history::HISTORY;
use crate::tolerance::scene::PLANETS;

pub(super) const SETS: &[Named] = &[each("NAME", Kind::Table(&[SET]), "none", "a planet set")];
const SET: &[Key] = &[
    key("sun", ROTOR, REQUIRED, "the rotor of the sun"),
    key("ring", ROTOR_OR_GROUND, REQUIRED, "the rotor of the ring"),
    key("carrier", ROTOR_OR_GROUND, REQUIRED, "the rotor of the carrier"),
    key("teeth", Kind::List(&Kind::Number), REQUIRED, "numbers of teeth of sun and ring"),
    key("planet_teeth", Kind::Number, "half the difference", "number of teeth of a planet"),
    key("count", Kind::Number, "required without at", "number of planets, equally spaced"),
    key("at", Kind::List(&Kind::Quantity("rad")), "equally spaced", "places of the planets on the carrier"),
    key("base_radius", Kind::Quantity("m"), "from module", "base radius of the sun"),
    key("module", Kind::Quantity("m"), "none", "normal module, instead of base_radius"),
    key("helix_angle", Kind::Quantity("rad"), "0 deg", "helix angle at the reference cylinder"),
    axial::HAND,
    key("pressure_angle", Kind::Quantity("rad"), "20 deg", "pressure angle"),
    key("mass", Kind::Quantity("kg"), ELSEWHERE, "mass of a planet"),
    key("inertia", bodies::INERTIA, ELSEWHERE, "moment of inertia I of a planet, or I/r^2 with its base radius r"),
    key("sun_stiffness", LAW, "in [laws]", "stiffness of the meshes with the sun; phases follow from teeth and places"),
    key("ring_stiffness", LAW, "in [laws]", "stiffness of the meshes with the ring; likewise"),
    key(
        "sun_error",
        LAW,
        "in [laws]",
        "transmission error of the meshes with the sun, with the effect transmission_error; phases as those of stiffnesses",
    )
    .with("transmission_error"),
    key("ring_error", LAW, "in [laws]", "that of the meshes with the ring; likewise"),
    key("backlash", Kind::Quantity("m"), ELSEWHERE, "play of all meshes, with the effect backlash").with("backlash"),
    key(
        "damping",
        Kind::Quantity("N*s/m"),
        "none",
        "viscous damping of each mesh along the line of action, with the effect viscous_friction",
    )
    .with("viscous_friction"),
    key(
        "friction",
        Kind::Either(&[Kind::Number, HISTORY]),
        ELSEWHERE,
        "coefficient of friction of all flanks, with the effect sliding_friction",
    )
    .with("sliding_friction"),
];
const ROTOR_OR_GROUND: Kind = Kind::Name("a rotor or \"ground\"");

/// What to write in place of a model `planetary_N` that does not exist; `None` for any other name.
pub(crate) fn in_place_of(model: &str) -> Option<String> {
    let planets: u32 = model.strip_prefix("planetary_")?.parse().ok()?;
    let said = || format!("planets in torsion: `model = \"train\"` and `[planets.NAME]` with `count = {planets}`");
    (1.0..=PLANETS).contains(&planets.into()).then(said)
}

/// An arbitrary stiffness in place of a refused one, so that it causes no further mistakes.
fn in_place_of_rigid(node: &Node) -> Node {
    Node { value: Value::Text("1 N/m".into()), place: node.place.clone() }
}

impl Reader<'_> {
    /// Adds the planets of a set, and their meshes.
    pub(super) fn planets(&mut self, item: &Item<'_>) {
        self.known(item, SET);
        let ends = ["sun", "ring", "carrier"].map(|key| {
            let node = self.needed(item, key, "\"...\"")?;
            self.end(&format!("planets.{}.{key}", item.name), node, key != "sun")
        });
        let (Some(teeth), Some(places)) = (self.tooth_numbers(item), self.places(item)) else { return };
        let [Some(Some(sun)), Some(ring), Some(carrier)] = ends else { return };
        for (a, b) in [(Some(sun), ring), (Some(sun), carrier), (ring, carrier)] {
            if a == b {
                let message = format!("{} has one rotor in two places", item.title());
                self.report.add(item.place, message, "twice the same", "sun, ring and carrier are different rotors");
                return;
            }
            self.join(item, [a, b], false);
        }
        let set = item.name;
        let names = ["Zs", "Zr", "Zp", "rs"].map(|quantity| named(quantity, set));
        let [z_s, z_r, z_p, r_s] = &names;
        self.draft.rings.push((item.place.clone(), item.title(), [z_p.clone(), z_r.clone()]));
        self.fit(item, &teeth, &places);
        for (name, key) in [(z_s, "teeth.0"), (z_r, "teeth.1"), (z_p, "planet_teeth"), (&named("np", set), "count")] {
            self.fixed(name, item.path(key));
        }
        for ((name, what), number) in [(z_s, "sun"), (z_r, "ring"), (z_p, "planets")].into_iter().zip(&teeth) {
            let doc = format!("number of teeth of the {what} of {set}");
            self.draft.geometry.push(Geometry { name: name.clone(), unit: "1", gear_data: Some(GearData::Teeth), doc });
            self.value(name.clone(), Some(number));
        }
        let of_rack = self.transverse_angle(item);
        let alpha = named("alpha", set);
        // The meshes of the set have the angles of their teeth, or the same angle, if it states one.
        let angles = [("s", "sun_stiffness"), ("r", "ring_stiffness")].map(|(with, key)| {
            let of_teeth = self.working_angle(item.get(key), with == "r");
            let own = named("alpha", &format!("{set}_{with}"));
            self.value(own.clone(), of_teeth.as_ref());
            of_teeth.map(|_| own).or(of_rack.as_ref().map(|_| alpha.clone()))
        });
        let mut planets = vec![];
        for (i, place) in places.iter().enumerate() {
            let planet = self.planet(item, i + 1);
            planets.push(planet);
            let gear = |rotor, teeth: &String, sense| DraftGear { rotor, carrier, teeth: teeth.clone(), sense };
            let of_planet = gear(Some(planet), z_p, -1.0);
            let pairs = [
                ("s", ["sun_stiffness", "sun_error"], [gear(Some(sun), z_s, 1.0), of_planet.clone()]),
                ("r", ["ring_stiffness", "ring_error"], [of_planet, gear(ring, z_r, -1.0)]),
            ];
            for ((with, keys, gears), angle) in pairs.into_iter().zip(&angles) {
                if i == 0 {
                    self.not_rigid(item, keys[0]);
                }
                let name = format!("{set}_{with}{}", i + 1);
                let law = |key| {
                    let stated = item.get(key)?;
                    let stated =
                        if key == keys[0] && is_rigid(stated) { in_place_of_rigid(stated) } else { stated.clone() };
                    Some(shifted(&stated, with, place, &self.draft.values, &names))
                };
                let [stiffness, error] = keys.map(law);
                self.friction(item, &name, keys[0], stiffness.as_ref());
                self.laws(item, &name, [("k", keys[0], stiffness), ("e", keys[1], error)]);
                self.stated(named("b", &name), item, "backlash");
                self.stated(named("c", &name), item, "damping");
                let doc = format!("base radius of the sun of {set}");
                let radius = Geometry { name: r_s.clone(), unit: "m", gear_data: Some(GearData::BaseRadius), doc };
                self.geared(name, item, gears, radius, with == "r", angle.clone());
                // The planets have the opposite hand of the sun, and the same hand as the ring.
                self.helix(item, if with == "s" { 1.0 } else { -1.0 }, with == "r");
            }
        }
        self.draft.planet_sets.push(PlanetSet { name: set.to_owned(), sun, ring, carrier, planets });
        self.radius_of_sun(item, z_s, r_s);
        let Some(carrier) = carrier else { return };
        self.stated(named("mp", set), item, "mass");
        self.value(
            named("np", set),
            Some(&Node { value: Value::Number(places.len() as f64), place: item.place.clone() }),
        );
        let angle = self.angle_of_centres(item, &teeth).or(of_rack);
        self.value(alpha.clone(), angle.as_ref());
        let mut renamed = vec![("Zs_x", z_s.clone()), ("Zr_x", z_r.clone()), ("rs_x", r_s.clone())];
        renamed.push(("alpha_x", alpha));
        let rows = vec![vec![Term::new(carrier, 1.0, &[])]];
        let (name, place, called) = (set.to_string(), item.place.clone(), String::new());
        self.draft.parts.push(DraftPart {
            element: "element_planets",
            name,
            place,
            renamed,
            rows,
            driving: vec![],
            called,
            without: None,
        });
    }

    /// The angle at which the centres of the planets have the distance of the teeth of the sun's meshes from its axis:
    /// cos(alpha) = r_s (Z_r/Z_s + 1)/(2 a).
    fn angle_of_centres(&self, item: &Item<'_>, [sun, ring, _]: &[Node; 3]) -> Option<Node> {
        let node = item.get("sun_stiffness")?;
        let contact = self.contact(Some(node), false)?;
        let [Value::Number(sun), Value::Number(ring)] = [&sun.value, &ring.value] else { return None };
        let cosine = contact.base[0] * (ring / sun + 1.0) / (2.0 * contact.centre_distance);
        let angle = cosine.acos();
        (angle > 0.0).then(|| Node { value: Value::Text(format!("{angle} rad")), place: node.place.clone() })
    }

    /// Refuses a mesh of the set that is stated to be rigid.
    fn not_rigid(&mut self, item: &Item<'_>, key: &str) {
        if let Some(node) = item.get(key).filter(|node| is_rigid(node)) {
            let message = format!("`{key}` of {} is \"rigid\"", item.title());
            let help = "give a stiffness, e.g. \"500 MN/m\", or its law: { steps = [...] }, { teeth = {...} }; only the gears of [meshes] \
                        may be \"rigid\"";
            self.report.add(&node.place, message, "planets are not rigid", help);
        }
    }

    /// Adds planet `i` as a rotor, and returns its index.
    fn planet(&mut self, item: &Item<'_>, i: usize) -> usize {
        let (rotor, name) = (self.draft.rotors.len(), format!("{}_{i}", item.name));
        let inertia = named("Ip", item.name);
        if i == 1 {
            self.stated(inertia.clone(), item, "inertia");
        }
        let (rows, place) = (vec![vec![Term::new(rotor, 1.0, &[])]], item.place.clone());
        self.draft.rotors.push(Rotor { name: name.clone(), of: None, along: None });
        let renamed = vec![("I_x", inertia)];
        self.draft.parts.push(DraftPart {
            driving: vec![],
            element: "element_rotor",
            name,
            place,
            renamed,
            rows,
            called: String::new(),
            without: None,
        });
        rotor
    }

    fn radius_of_sun(&mut self, item: &Item<'_>, z_s: &str, r_s: &str) {
        if let Some(node) = item.get("base_radius") {
            if item.get("module").is_some() {
                self.stated_twice(item, node);
            }
            return self.value(r_s.into(), Some(node));
        }
        let Some(node) = item.get("module") else {
            return self.lacking(format!("parameters.{r_s}"), item, "base_radius");
        };
        if let Some(radius) = self.radius_by_module(item, node, z_s) {
            let value = Value::Text(format!("{radius} m"));
            self.value(r_s.into(), Some(&Node { value, place: node.place.clone() }));
        }
    }
}

/// The law of one planet: that of the set, with the phase that follows from tooth numbers and the place of the planet.
fn shifted(node: &Node, with: &str, at: &Node, values: &[(String, Node)], names: &[String; 4]) -> Node {
    let Value::Table(entries) = &node.value else { return node.clone() };
    if keys::get(entries, "phase").is_some() {
        return node.clone();
    }
    let entry = |key: &str, node: Node| KeyEntry { key: key.into(), place: at.place.clone(), node };
    let of = |name: &String| values.iter().rfind(|value| value.0 == *name).map(|value| value.1.clone());
    let [z_s, z_r, z_p, _] = names;
    let teeth = match with {
        "s" => vec![("sun", of(z_s))],
        _ => vec![("ring", of(z_r)), ("planet", of(z_p))],
    };
    let mut phase: Vec<KeyEntry> = teeth.into_iter().filter_map(|(key, node)| Some(entry(key, node?))).collect();
    phase.push(entry("at", at.clone()));
    let phase = Node { value: Value::Table(phase), place: at.place.clone() };
    let all = entries.iter().cloned().chain([entry("phase", phase)]).collect();
    Node { value: Value::Table(all), place: node.place.clone() }
}
