//! Meshes of two gears: their teeth, and gears that are rigid.

use super::draft::{Draft, DraftGear, Geometry, Rotor, Term, named};
use super::item::Item;
use super::read::{GROUND, Reader};
use super::{ELSEWHERE, TWO_ROTORS, axial};
use crate::model::GearData;
use crate::scene::document::{KeyEntry, Node, Value};
use crate::scene::keys::{Key, Kind, Named, REQUIRED, each, key};
use crate::scene::mistake::Report;
use crate::scene::time_history::HISTORY;
use crate::scene::{field, friction, keys, laws};

pub(super) const MESHES: &[Named] = &[each("NAME", Kind::Table(&[MESH]), "none", "a pair of gears")];
const MESH: &[Key] = &[
    key("between", TWO_ROTORS, REQUIRED, "the rotors of the gears; the first drives"),
    key("internal", Kind::Flag, "false", "whether the second gear is a ring gear"),
    key("teeth", Kind::List(&Kind::Number), "of another mesh, or in [parameters]", "numbers of teeth of both gears"),
    key("base_radius", Kind::Quantity("m"), "from module", "base radius of the first gear"),
    key("module", Kind::Quantity("m"), "none", "normal module, instead of base_radius"),
    key("helix_angle", Kind::Quantity("rad"), "0 deg", "helix angle at the reference cylinder"),
    axial::HAND,
    key(
        "pressure_angle",
        Kind::Quantity("rad"),
        "20 deg",
        "pressure angle of the basic rack; teeth of `stiffness` have their own",
    ),
    key(
        "stiffness",
        Kind::Either(&[Kind::Choice(&["rigid"]), LAW]),
        "in [laws]",
        "mesh stiffness: a constant, or a law",
    ),
    key("error", LAW, "in [laws]", "transmission error, with the effect transmission_error: a constant, or a law")
        .with("transmission_error"),
    key("backlash", Kind::Quantity("m"), ELSEWHERE, "play along the line of action, with the effect backlash")
        .with("backlash"),
    key(
        "damping",
        Kind::Quantity("N*s/m"),
        "none",
        "viscous damping along the line of action, in contact and out of it, with the effect viscous_friction",
    )
    .with("viscous_friction"),
    key(
        "friction",
        Kind::Either(&[Kind::Number, HISTORY]),
        ELSEWHERE,
        "coefficient of friction of the flanks, with the effect sliding_friction",
    )
    .with("sliding_friction"),
];
/// A law of a mesh, or its constant value.
pub(super) const LAW: Kind = Kind::Either(&[laws::VALUE, Kind::Table(laws::STIFFNESS)]);

/// Whether a stiffness is stated to be rigid.
pub(super) fn is_rigid(stiffness: &Node) -> bool {
    matches!(&stiffness.value, Value::Text(text) if text == "rigid")
}

impl Reader<'_> {
    pub(super) fn mesh(&mut self, item: &Item<'_>) {
        self.known(item, MESH);
        let Some(ends) = self.between(item, true) else { return };
        let internal = match item.get("internal") {
            Some(node) => field::flag(&item.path("internal"), node, self.report) == Some(true),
            None => false,
        };
        self.join(item, ends, !internal);
        let Some(teeth) = self.teeth(item, ends) else { return };
        if internal {
            self.draft.rings.push((item.place.clone(), item.title(), teeth.clone()));
        }
        if item.get("stiffness").is_some_and(is_rigid) {
            return self.rigid(item, ends, teeth);
        }
        let law = |name, key| (name, key, item.get(key).cloned());
        self.laws(item, item.name, [law("k", "stiffness"), law("e", "error")]);
        self.stated(named("b", item.name), item, "backlash");
        self.friction(item, item.name, "stiffness", item.get("stiffness"));
        let gears = [0, 1].map(|i| DraftGear { rotor: ends[i], carrier: None, teeth: teeth[i].clone(), sense: 1.0 });
        let first = ends[0].map_or(GROUND, |i| &self.draft.rotors[i].name);
        let radius = named("r", if teeth[0] == named("N", first) { first } else { item.name });
        let doc = format!("base radius of gear {first}");
        let radius = Geometry { name: radius, unit: "m", gear_data: Some(GearData::BaseRadius), doc };
        // Shifted teeth work at another angle than that of their rack.
        let of_rack = self.transverse_angle(item);
        let angle = self.working_angle(item.get("stiffness"), internal).or(of_rack);
        let alpha = named("alpha", item.name);
        self.value(alpha.clone(), angle.as_ref());
        self.geared(item.name.to_string(), item, gears, radius, internal, angle.map(|_| alpha));
        self.stated(named("c", item.name), item, "damping");
        self.helix(item, 1.0, internal);
        self.radius(item, &teeth[0]);
    }

    /// The friction of the flanks of the mesh `name`. Its laws are those of the teeth of the stiffness, if that has teeth.
    pub(super) fn friction(&mut self, item: &Item<'_>, name: &str, key: &'static str, stiffness: Option<&Node>) {
        self.stated(named("mu", name), item, "friction");
        if item.get("friction").is_none() {
            return;
        }
        let teeth =
            stiffness.filter(|node| matches!(&node.value, Value::Table(law) if keys::get(law, "teeth").is_some()));
        let Some(Node { place, .. }) = teeth else {
            for quantity in ["side", "arm"] {
                self.lacking(format!("laws.{}", named(quantity, name)), item, key);
            }
            return;
        };
        let table = || {
            let of = Node { value: Value::Text(named("k", name)), place: place.clone() };
            let entry = KeyEntry { key: friction::OF.into(), place: place.clone(), node: of };
            Node { value: Value::Table(vec![entry]), place: place.clone() }
        };
        self.draft.usual_laws.extend(["side", "arm"].map(|quantity| (named(quantity, name), table())));
    }

    /// The names of the numbers of teeth of the gears of a mesh.
    pub(super) fn teeth(&mut self, item: &Item<'_>, ends: [Option<usize>; 2]) -> Option<[String; 2]> {
        let given = match item.get("teeth") {
            None => None,
            Some(node) => {
                let items = field::array(&item.path("teeth"), node, "[20, 40]", self.report)?;
                let [a, b] = items else {
                    let message = format!("`{}` must have two numbers, not {}", item.path("teeth"), items.len());
                    self.report.add(&node.place, message, "two numbers", "one for each gear: teeth = [20, 40]");
                    return None;
                };
                Some([a, b])
            }
        };
        let names = [0, 1].map(|i| {
            let rotor =
                ends[i].map_or_else(|| format!("{}_{GROUND}", item.name), |i| self.draft.rotors[i].name.clone());
            let own = named("N", &rotor);
            let (Some(given), Some(before)) = (given, self.draft.values.iter().find(|value| value.0 == own)) else {
                return own;
            };
            // The number of teeth of a second gear on the rotor has another name, if it differs.
            if same(&before.1, given[i]) { own } else { named("N", &format!("{rotor}_{}", item.name)) }
        });
        for (i, name) in names.iter().enumerate() {
            if !self.draft.geometry.iter().any(|known| known.name == *name) {
                let gear = name.trim_start_matches('N').trim_start_matches('_');
                let doc = format!("number of teeth of gear {gear}");
                self.draft.geometry.push(Geometry {
                    name: name.clone(),
                    unit: "1",
                    gear_data: Some(GearData::Teeth),
                    doc,
                });
            }
            if !self.draft.values.iter().any(|value| value.0 == *name) {
                match given {
                    Some(given) => self.value(name.clone(), Some(given[i])),
                    None => self.lacking(format!("parameters.{name}"), item, "teeth"),
                }
            }
        }
        Some(names)
    }

    /// The rotor of one gear turns with that of the other.
    pub(super) fn rigid(&mut self, item: &Item<'_>, ends: [Option<usize>; 2], teeth: [String; 2]) {
        let keys = ["base_radius", "module", "error", "backlash", "damping", "friction"];
        for key in keys.into_iter().filter(|key| item.get(key).is_some()) {
            let message = format!("{} has `stiffness = \"rigid\"` and `{key}`", item.title());
            let help = "leave it out, or give a stiffness";
            self.report.add(item.place, message, "rigid gears do not have it", help);
        }
        let [Some(a), Some(b)] = ends else {
            let message = format!("{} gears a rotor rigidly to the ground", item.title());
            self.report.add(item.place, message, "it could not turn", "give the mesh a stiffness");
            return;
        };
        let root = |mut i: usize, rotors: &[Rotor]| {
            while let Some(of) = &rotors[i].of {
                i = of.rotor;
            }
            i
        };
        let (of_a, of_b) = (root(a, &self.draft.rotors), root(b, &self.draft.rotors));
        if of_a == of_b {
            let message = format!("{} closes a loop of rigid gears", item.title());
            self.report.add(item.place, message, "a second ratio", "give one mesh of the loop a stiffness");
            return;
        }
        // theta_b = N_a/N_b theta_a: so the root of b turns with a.
        let [na, nb] = &teeth;
        let mut powers = vec![(na.clone(), 1), (nb.clone(), -1)];
        let mut at = b;
        while let Some(of) = &self.draft.rotors[at].of {
            powers.extend(of.powers.iter().map(|(name, power)| (name.clone(), -power)));
            at = of.rotor;
        }
        self.draft.rotors[of_b].of = Some(Term { rotor: a, number: 1.0, powers });
    }
}

/// Checks that each ring has more teeth than the gear in it; `value` has the values of the parameters.
pub(super) fn check_rings(draft: &Draft, value: &dyn Fn(&str) -> Option<f64>, report: &mut Report) {
    for (place, title, teeth) in &draft.rings {
        let [Some(gear), Some(ring)] = teeth.each_ref().map(|name| value(name)) else { continue };
        if ring <= gear {
            let message = format!("{title} has a ring of {ring} teeth around a gear of {gear}");
            let help =
                "the second gear of an internal mesh is the ring: list it second, with the larger number of teeth";
            report.add(place, message, "too few teeth", help);
        }
    }
}

/// Whether two values are written with the same number.
fn same(a: &Node, b: &Node) -> bool {
    match (&a.value, &b.value) {
        (Value::Number(a), Value::Number(b)) => a == b,
        (Value::Text(a), Value::Text(b)) => a == b,
        _ => false,
    }
}
