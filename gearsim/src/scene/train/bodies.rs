//! Rotors, shafts, supports, bearings, clutches and end stops.

use super::draft::{DraftPart, Rotor, Term, Terms, named};
use super::item::Item;
use super::read::Reader;
use super::{ELSEWHERE, ROTOR, TWO_ROTORS};
use crate::scene::document::{KeyEntry, Node, Value};
use crate::scene::keys::{Key, Kind, Named, REQUIRED, each, key};
use crate::scene::time_history::HISTORY;

pub(super) const ROTORS: &[Named] = &[each(
    "NAME",
    Kind::Either(&[INERTIA, Kind::Table(&[INERTIA_ALONE])]),
    REQUIRED,
    "a rotor by its moment of inertia, or by a table",
)];
pub(super) const INERTIA: Kind = Kind::Either(&[Kind::Quantity("kg*m^2"), Kind::Quantity("kg")]);
const INERTIA_ALONE: &[Key] = &[key("inertia", INERTIA, ELSEWHERE, "moment of inertia I, or I/r^2"), RADIUS];
/// The radius of a value that is given over the square of a radius.
pub(super) const RADIUS: Key = key(
    "radius",
    Kind::Quantity("m"),
    "base radius of its gear, circle of the planets' centres of a carrier",
    "the radius r of an inertia I/r^2 in kg, a stiffness k/r^2 in N/m and a damping c/r^2 in N*s/m",
);

pub(super) const SHAFTS: &[Named] = &[each("NAME", Kind::Table(&[SHAFT]), "none", "a shaft")];
const SHAFT: &[Key] = &[
    key("between", TWO_ROTORS, REQUIRED, "the rotors that it joins"),
    key("stiffness", STIFFNESS, ELSEWHERE, "torsional stiffness k, or k/r^2"),
    DAMPER,
    RADIUS,
];

pub(super) const SUPPORTS: &[Named] = &[each("NAME", Kind::Table(&[SUPPORT]), "none", "a support")];
const SUPPORT: &[Key] = &[
    key("rotor", ROTOR, REQUIRED, "the rotor that it holds"),
    key("stiffness", STIFFNESS, ELSEWHERE, "torsional stiffness k, or k/r^2"),
    DAMPER,
    RADIUS,
];
/// The damper of a shaft or of a support.
const DAMPER: Key = key("damping", DAMPING, "none", "torsional damping c, or c/r^2, with the effect viscous_friction")
    .with("viscous_friction");
const STIFFNESS: Kind = Kind::Either(&[Kind::Quantity("N*m/rad"), Kind::Quantity("N/m")]);
pub(super) const DAMPING: Kind = Kind::Either(&[Kind::Quantity("N*m*s/rad"), Kind::Quantity("N*s/m")]);

pub(super) const BEARINGS: &[Named] =
    &[each("NAME", Kind::Table(&[BEARING]), "none", "a bearing, a brake or a friction clutch")];
const BEARING: &[Key] = &[
    key("rotor", ROTOR, "required without between", "the rotor that it carries"),
    key(
        "between",
        TWO_ROTORS,
        "none",
        "instead of rotor: the rotors between which it is, for example of a friction clutch",
    ),
    key("viscous", DAMPING, "none", "viscous friction c, or c/r^2, with the effect viscous_friction")
        .with("viscous_friction"),
    RADIUS,
    key("friction", TORQUE, "none", "friction torque while it slides, with the effect dry_friction")
        .with("dry_friction"),
    key("breakaway", Kind::Number, "0", "breakaway torque over this friction torque, less 1"),
];

pub(super) const CLUTCHES: &[Named] = &[each("NAME", Kind::Table(&[CLUTCH]), "none", "an overrunning clutch")];
const CLUTCH: &[Key] = &[
    key("between", TWO_ROTORS, REQUIRED, "the rotors that it joins; the first drives the second"),
    key(
        "capacity",
        TORQUE,
        ELSEWHERE,
        "largest torque that it transmits, with the effect overrunning_clutch; beyond it slips",
    )
    .with("overrunning_clutch"),
    key("drag", TORQUE, "0 N*m", "friction torque while it overruns"),
];

pub(super) const END_STOPS: &[Named] = &[each("NAME", Kind::Table(&[END_STOP]), "none", "two end stops")];
const END_STOP: &[Key] = &[
    key(
        "between",
        TWO_ROTORS,
        REQUIRED,
        "the rotor that is stopped, and the one that carries the stops, or \"ground\"",
    ),
    key(
        "upper",
        ANGLE,
        ELSEWHERE,
        "the stop at the largest rotation of the first rotor relative to the second, with the effect end_stop",
    )
    .with("end_stop"),
    key("lower", ANGLE, ELSEWHERE, "the stop at the smallest rotation").with("end_stop"),
    key("stiffness", Kind::Quantity("N*m/rad"), ELSEWHERE, "torsional stiffness of the stops").with("end_stop"),
    key("damping", Kind::Quantity("N*m*s/rad"), "0 N*m*s/rad", "torsional damping of the stops; it never pulls"),
];
const ANGLE: Kind = Kind::Quantity("rad");
/// A torque, or its values over time.
const TORQUE: Kind = Kind::Either(&[Kind::Quantity("N*m"), HISTORY]);

impl Reader<'_> {
    pub(super) fn rotor(&mut self, entry: &KeyEntry) {
        let name = entry.key.clone();
        match &entry.node.value {
            Value::Table(entries) => {
                let item = Item { table: "rotors", name: &name, entries, place: &entry.place };
                self.known(&item, INERTIA_ALONE);
                self.per_radius(named("I", &name), &item, "inertia");
            }
            _ => self.value(named("I", &name), Some(&entry.node)),
        }
        let rotor = self.draft.rotors.len();
        let place = entry.place.clone();
        let (rows, called) = (vec![vec![Term::new(rotor, 1.0, &[])]], String::new());
        self.draft.rotors.push(Rotor { name: name.clone(), of: None, along: None });
        let (element, renamed, driving) = ("element_rotor", vec![], vec![]);
        self.draft.parts.push(DraftPart { element, name, place, renamed, rows, driving, called, without: None });
    }

    pub(super) fn shaft(&mut self, item: &Item<'_>) {
        self.known_but_rigid(item, SHAFT);
        let Some(ends) = self.between(item, true) else { return };
        self.join(item, ends, false);
        self.spring(item, "element_shaft", ends);
    }

    pub(super) fn support(&mut self, item: &Item<'_>) {
        self.known_but_rigid(item, SUPPORT);
        let Some(rotor) = self.rotor_of(item) else { return };
        self.spring(item, "element_support", [Some(rotor), None]);
    }

    pub(super) fn spring(&mut self, item: &Item<'_>, element: &'static str, ends: [Option<usize>; 2]) {
        if self.not_elastic(item, ends) {
            // A valid value in place of the refused one, so that further mistakes in the part are found.
            let value = Value::Text("1 N*m/rad".into());
            self.value(named("k", item.name), Some(&Node { value, place: item.place.clone() }));
        } else {
            self.per_radius(named("k", item.name), item, "stiffness");
        }
        self.part(item, element, named("psi", item.name), vec![difference(ends)]);
        if let Some(part) = self.draft.parts.last_mut() {
            part.driving.extend(ends[0].map(|rotor| Term::new(rotor, 1.0, &[])));
            part.without = item.undamped();
        }
        self.per_radius(named("c", item.name), item, "damping");
    }

    /// A value that may be one over the square of the `radius` of an item.
    pub(super) fn per_radius(&mut self, parameter: String, item: &Item<'_>, key: &'static str) {
        let Some(node) = item.get(key) else { return self.lacking(format!("parameters.{parameter}"), item, key) };
        let Some(radius) = item.get("radius") else { return self.value(parameter, Some(node)) };
        let entry =
            |key: &str, node: &Node| KeyEntry { key: key.into(), place: node.place.clone(), node: node.clone() };
        let value = Value::Table(vec![entry("value", node), entry("radius", radius)]);
        self.value(parameter, Some(&Node { value, place: node.place.clone() }));
    }

    pub(super) fn bearing(&mut self, item: &Item<'_>) {
        self.known(item, BEARING);
        let Some(ends) = self.carried(item) else { return };
        let row = difference(ends);
        let [viscous, friction] = ["viscous", "friction"].map(|key| item.get(key));
        if viscous.is_none() && friction.is_none() {
            let help = "add viscous = \"... N*m*s/rad\", or friction = \"... N*m\", or both";
            self.report.add(item.place, format!("{} has no friction", item.title()), "nothing given", help);
        }
        if viscous.is_some() {
            self.per_radius(named("c", item.name), item, "viscous");
            self.part(item, "element_viscous", String::new(), vec![row.clone()]);
        }
        if friction.is_some() {
            self.value(named("Tc", item.name), friction);
            self.stated(named("rise", item.name), item, "breakaway");
            self.part(item, "element_dry_friction", String::new(), vec![row]);
        }
    }

    /// The rotor of a bearing, against the ground; or the rotors between which it is.
    fn carried(&mut self, item: &Item<'_>) -> Option<[Option<usize>; 2]> {
        let Some(node) = item.get("between") else { return Some([Some(self.rotor_of(item)?), None]) };
        if item.get("rotor").is_some() {
            let message = format!("{} has `rotor` and `between`", item.title());
            let help = "`rotor` is for friction against the ground, `between` for friction of two rotors: leave out one of them";
            self.report.add(&node.place, message, "twice", help);
            return None;
        }
        let ends = self.between(item, false)?;
        self.join(item, ends, false);
        Some(ends)
    }

    pub(super) fn clutch(&mut self, item: &Item<'_>) {
        self.known(item, CLUTCH);
        let Some(ends) = self.between(item, true) else { return };
        self.join(item, ends, false);
        self.stated(named("Tmax", item.name), item, "capacity");
        self.stated(named("Tdrag", item.name), item, "drag");
        self.part(item, "element_clutch", String::new(), vec![difference(ends)]);
    }

    pub(super) fn end_stop(&mut self, item: &Item<'_>) {
        self.known(item, END_STOP);
        let Some(ends) = self.between(item, true) else { return };
        self.join(item, ends, false);
        for (parameter, key) in [("hi", "upper"), ("lo", "lower"), ("ks", "stiffness"), ("cs", "damping")] {
            self.stated(named(parameter, item.name), item, key);
        }
        self.part(item, "element_end_stop", String::new(), vec![difference(ends)]);
    }
}

/// The rotation of the first rotor relative to the second.
fn difference([a, b]: [Option<usize>; 2]) -> Terms {
    [(a, 1.0), (b, -1.0)].into_iter().filter_map(|(end, sign)| end.map(|rotor| Term::new(rotor, sign, &[]))).collect()
}
