//! Axial motion of rotors on thrust bearings, and the axial forces of helical gears.
//!
//! With the hand h of a gear (1 right, -1 left) and the base helix angle beta_b, its flank in a transverse plane advances by
//! r_b dphi - h tan(beta_b) dz, as the gear turns by dphi about its axis and moves by dz along it. Deflection and stiffness are along the
//! line of action in the transverse plane. The deflection has the derivatives d delta/dz = -h tan(beta_b) (d delta/dphi)/r_b, and the axial
//! force is the mesh force times tan(beta_b): F_a = F_t tan(beta). Source: ISO 21771-1:2024; G. Niemann, H. Winter, Maschinenelemente II.
//! The deflection stays linear, and cells exact.
//!
//! All axes have the same positive direction. The first rotor of the train, when it turns at positive speed, turns about this direction by the
//! right-hand rule.

use super::draft::{Axial, Geometry, Rotor, Term, named};
use super::item::Item;
use super::read::Reader;
use super::{ELSEWHERE, ROTOR, senses};
use crate::scene::document::{Node, Value};
use crate::scene::field;
use crate::scene::keys::{Key, Kind, Named, REQUIRED, each, key};

pub(super) const THRUST_BEARINGS: &[Named] =
    &[each("NAME", Kind::Table(&[THRUST_BEARING]), "none", "a thrust bearing of a rotor with helical gears")];
const THRUST_BEARING: &[Key] = &[
    key("rotor", ROTOR, REQUIRED, "the rotor that moves along its axis"),
    key("mass", Kind::Quantity("kg"), ELSEWHERE, "mass that moves along the axis"),
    key("stiffness", Kind::Quantity("N/m"), ELSEWHERE, "axial stiffness"),
    key("damping", Kind::Quantity("N*s/m"), ELSEWHERE, "axial damping, with the effect viscous_friction")
        .with("viscous_friction"),
];

/// The hand of the first gear of a mesh, or of a sun.
pub(super) const HAND: Key =
    key("hand", Kind::Choice(&HANDS), "right", "hand of the helix of the first gear; a planet set: of the sun");
const HANDS: [&str; 2] = ["right", "left"];

impl Reader<'_> {
    /// A thrust bearing: a coordinate along the axis of its rotor.
    pub(super) fn thrust_bearing(&mut self, item: &Item<'_>) {
        self.known(item, THRUST_BEARING);
        let Some(rotor) = self.rotor_of(item) else { return };
        if let Some(other) = self.draft.rotors.iter().find(|other| other.along == Some(rotor)) {
            let message = format!("rotor `{}` has two thrust bearings", self.draft.rotors[rotor].name);
            let help = format!("its axial motion is `{}`; add their stiffnesses", other.name);
            return self.report.add(item.place, message, "a second one", help);
        }
        for (quantity, key) in [("ma", "mass"), ("ka", "stiffness"), ("ca", "damping")] {
            self.stated(named(quantity, item.name), item, key);
        }
        let (name, z) = (named("z", &self.draft.rotors[rotor].name), self.draft.rotors.len());
        self.draft.rotors.push(Rotor { name: name.clone(), of: None, along: Some(rotor) });
        self.part(item, "element_thrust_bearing", name, vec![vec![Term::new(z, 1.0, &[])]]);
    }

    /// Notes the helix of the mesh that was added last. The hand of its first gear is the `hand` of an item times `sense`.
    pub(super) fn helix(&mut self, item: &Item<'_>, sense: f64, internal: bool) {
        let Some(node) = item.get("helix_angle") else {
            if let Some(node) = item.get("hand") {
                let message = format!("{} has a hand, but no helix angle", item.title());
                self.report.add(&node.place, message, "of which helix?", "add helix_angle, or leave out hand");
            }
            return;
        };
        let hand = match item.get("hand") {
            Some(node) => field::choice(&item.path("hand"), node, "hand", &HANDS, self.report),
            None => Some(0),
        };
        let (Some(hand), Some(rack)) = (hand, self.basic_rack(item, 1.0)) else { return };
        let tangent = rack.base_helix_angle().tan();
        // Spur gears have no axial force.
        if tangent == 0.0 {
            return;
        }
        let name = named("tanb", item.name);
        if !self.draft.geometry.iter().any(|known| known.name == name) {
            let doc = format!("tangent of the base helix angle of {}", item.name);
            self.fixed(&name, item.path("helix_angle"));
            self.draft.geometry.push(Geometry { name: name.clone(), unit: "1", gear_data: None, doc });
            self.value(name.clone(), Some(&Node { value: Value::Number(tangent), place: node.place.clone() }));
        }
        let first = sense * [1.0, -1.0][hand];
        let second = if internal { first } else { -first };
        let part = self.draft.parts.len() - 1;
        self.draft.axial.push(Axial { part, tangent: name, hands: [first, second] });
    }

    /// Adds the axial motions to the deflections of helical meshes, when all tables are read.
    pub(super) fn move_along_axes(&mut self) {
        let senses = senses::of(&self.draft);
        let moving: Vec<[usize; 2]> =
            self.draft.rotors.iter().enumerate().filter_map(|(z, rotor)| Some([z, rotor.along?])).collect();
        let mut joined = vec![];
        for axial in std::mem::take(&mut self.draft.axial) {
            let found = self.draft.groups.iter().find_map(|group| {
                let i = group.parts.iter().position(|&part| part == axial.part)?;
                Some((group, group.meshes[i]))
            });
            let Some((group, pair)) = found else { continue };
            let gears = pair.map(|i| group.gears[i].clone());
            let mut of_mesh = vec![];
            for (i, gear) in gears.iter().enumerate() {
                let Some([z, rotor]) = moving.iter().find(|[_, rotor]| gear.rotor == Some(*rotor)) else { continue };
                let turns = [1.0, -1.0][i] * gear.sense * senses[*rotor];
                joined.push(*z);
                of_mesh.push(Term::new(*z, -axial.hands[i] * turns, &[(&axial.tangent, 1)]));
            }
            let name = self.draft.parts[axial.part].name.clone();
            self.draft.parts[axial.part].rows[1].extend(of_mesh);
            self.draft.axial_forces.push((name, axial.tangent));
        }
        for [z, rotor] in moving.iter().filter(|[z, _]| !joined.contains(z)) {
            let place = self.draft.parts.iter().find(|part| part.rows[0].iter().any(|term| term.rotor == *z));
            let Some(place) = place.map(|part| part.place.clone()) else { continue };
            let message =
                format!("rotor `{}` has a thrust bearing, but no helical gear", self.draft.rotors[*rotor].name);
            self.report.add(
                &place,
                message,
                "nothing moves it",
                "give its mesh a helix_angle, or leave out the bearing",
            );
        }
    }
}
