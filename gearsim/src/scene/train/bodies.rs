//! Rotors, shafts, supports, bearings and clutches.

use super::draft::{DraftPart, Rotor, Term, Terms, named};
use super::read::{Item, Reader};
use super::{ELSEWHERE, ROTOR, TWO_ROTORS};
use crate::scene::document::{Entry, Value};
use crate::scene::keys::{Key, Kind, Named, REQUIRED, each, key};

pub(super) const ROTORS: &[Named] = &[each(
    "NAME",
    Kind::Either(&[INERTIA, Kind::Table(&[INERTIA_ALONE])]),
    REQUIRED,
    "a rotor by its moment of inertia, or by a table",
)];
const INERTIA: Kind = Kind::Quantity("kg*m^2");
const INERTIA_ALONE: &[Key] = &[key("inertia", INERTIA, ELSEWHERE, "moment of inertia")];

pub(super) const SHAFTS: &[Named] = &[each("NAME", Kind::Table(&[SHAFT]), "none", "a shaft")];
const SHAFT: &[Key] = &[
    key("between", TWO_ROTORS, REQUIRED, "the rotors that it joins"),
    key("stiffness", STIFFNESS, ELSEWHERE, "torsional stiffness"),
    key("damping", DAMPING, "none", "torsional damping, with the effect viscous_friction"),
];

pub(super) const SUPPORTS: &[Named] = &[each("NAME", Kind::Table(&[SUPPORT]), "none", "a support")];
const SUPPORT: &[Key] = &[
    key("rotor", ROTOR, REQUIRED, "the rotor that it holds"),
    key("stiffness", STIFFNESS, ELSEWHERE, "torsional stiffness"),
    key("damping", DAMPING, "none", "torsional damping, with the effect viscous_friction"),
];
const STIFFNESS: Kind = Kind::Quantity("N*m/rad");
const DAMPING: Kind = Kind::Quantity("N*m*s/rad");

pub(super) const BEARINGS: &[Named] = &[each("NAME", Kind::Table(&[BEARING]), "none", "a bearing or a brake")];
const BEARING: &[Key] = &[
    key("rotor", ROTOR, REQUIRED, "the rotor that it carries"),
    key("viscous", DAMPING, "none", "viscous friction, with the effect viscous_friction"),
    key("friction", Kind::Quantity("N*m"), "none", "friction torque while it slides, with the effect dry_friction"),
    key("breakaway", Kind::Number, "0", "breakaway torque over this friction torque, less 1"),
];

pub(super) const CLUTCHES: &[Named] = &[each("NAME", Kind::Table(&[CLUTCH]), "none", "an overrunning clutch")];
const CLUTCH: &[Key] = &[
    key("between", TWO_ROTORS, REQUIRED, "the rotors that it joins; the first drives the second"),
    key("capacity", Kind::Quantity("N*m"), ELSEWHERE, "largest torque that it transmits; beyond it slips"),
    key("drag", Kind::Quantity("N*m"), "0 N*m", "friction torque while it overruns"),
];

impl Reader<'_> {
    pub(super) fn rotor(&mut self, entry: &Entry) {
        let name = entry.key.clone();
        let inertia = match &entry.node.value {
            Value::Table(entries) => {
                let item = Item { table: "rotors", name: &name, entries, place: &entry.place };
                self.known(&item, INERTIA_ALONE);
                item.get("inertia").cloned()
            }
            _ => Some(entry.node.clone()),
        };
        self.value(named("I", &name), inertia.as_ref());
        let rotor = self.draft.rotors.len();
        let place = entry.place.clone();
        let (rows, called) = (vec![vec![Term::new(rotor, 1.0, &[])]], String::new());
        self.draft.rotors.push(Rotor { name: name.clone(), of: None });
        let (element, renamed, driving) = ("element_rotor", vec![], vec![]);
        self.draft.parts.push(DraftPart { element, name, place, renamed, rows, driving, called });
    }

    pub(super) fn shaft(&mut self, item: &Item<'_>) {
        self.known(item, SHAFT);
        let Some(ends) = self.between(item, true) else { return };
        self.join(item, ends, false);
        self.spring(item, "element_shaft", ends);
    }

    pub(super) fn support(&mut self, item: &Item<'_>) {
        self.known(item, SUPPORT);
        let Some(rotor) = self.rotor_of(item) else { return };
        self.spring(item, "element_support", [Some(rotor), None]);
    }

    pub(super) fn spring(&mut self, item: &Item<'_>, element: &'static str, ends: [Option<usize>; 2]) {
        self.value(named("k", item.name), item.get("stiffness"));
        let row = difference(ends);
        self.part(item, element, named("psi", item.name), vec![row.clone()]);
        let first = ends[0].map(|rotor| Term::new(rotor, 1.0, &[]));
        self.draft.parts.iter_mut().rev().take(1).for_each(|part| part.driving.extend(first.clone()));
        if let Some(node) = item.get("damping") {
            self.value(named("c", item.name), Some(node));
            self.part(item, "element_viscous", String::new(), vec![row]);
        }
    }

    pub(super) fn bearing(&mut self, item: &Item<'_>) {
        self.known(item, BEARING);
        let Some(rotor) = self.rotor_of(item) else { return };
        let row = vec![Term::new(rotor, 1.0, &[])];
        let [viscous, friction] = ["viscous", "friction"].map(|key| item.get(key));
        if viscous.is_none() && friction.is_none() {
            let help = "add viscous = \"... N*m*s/rad\", or friction = \"... N*m\", or both";
            self.report.add(item.place, format!("{} has no friction", item.title()), "nothing given", help);
        }
        if viscous.is_some() {
            self.value(named("c", item.name), viscous);
            self.part(item, "element_viscous", String::new(), vec![row.clone()]);
        }
        if friction.is_some() {
            self.value(named("Tc", item.name), friction);
            self.value(named("rise", item.name), item.get("breakaway"));
            self.part(item, "element_dry_friction", String::new(), vec![row]);
        }
    }

    pub(super) fn clutch(&mut self, item: &Item<'_>) {
        self.known(item, CLUTCH);
        let Some(ends) = self.between(item, true) else { return };
        self.join(item, ends, false);
        self.value(named("Tmax", item.name), item.get("capacity"));
        self.value(named("Tdrag", item.name), item.get("drag"));
        self.part(item, "element_clutch", String::new(), vec![difference(ends)]);
    }
}

/// The rotation of the first rotor relative to the second.
fn difference([a, b]: [Option<usize>; 2]) -> Terms {
    [(a, 1.0), (b, -1.0)].into_iter().filter_map(|(end, sign)| end.map(|rotor| Term::new(rotor, sign, &[]))).collect()
}
