//! The content of the tables of a train, by names.

use crate::model::GearData;
use crate::scene::document::{Node, Place};
use crate::scene::mistake::Home;

/// The motion of a rotor times a number and powers of parameters.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Term {
    /// The rotor.
    pub rotor: usize,
    /// The number.
    pub number: f64,
    /// Parameters and their exponents.
    pub powers: Vec<(String, i32)>,
}

impl Term {
    pub fn new(rotor: usize, number: f64, powers: &[(&str, i32)]) -> Term {
        Term { rotor, number, powers: powers.iter().map(|(name, power)| (name.to_string(), *power)).collect() }
    }
}

/// A linear form of rotations and axial motions.
pub(super) type Terms = Vec<Term>;

/// A rotor.
pub(super) struct Rotor {
    pub name: String,
    /// Its rotation as a multiple of that of another rotor, if it is geared rigidly.
    pub of: Option<Term>,
    /// `None` for a rotation [rad]. For an axial motion [m]: the rotor along whose axis it moves.
    pub along: Option<usize>,
}

/// The helix of a mesh.
pub(super) struct Axial {
    /// The mesh, a part.
    pub part: usize,
    /// The parameter that is the tangent of the base helix angle.
    pub tangent: String,
    /// The hands of the gears: 1 right, -1 left.
    pub hands: [f64; 2],
}

/// A geometric parameter.
#[derive(Clone)]
pub(super) struct Geometry {
    pub name: String,
    pub unit: &'static str,
    pub gear_data: Option<GearData>,
    pub doc: String,
}

/// A part: an element and its coordinates.
pub(super) struct DraftPart {
    pub element: &'static str,
    pub name: String,
    pub place: Place,
    /// Parameters of the element whose names do not follow from the name of the part: name in the element, name in the train.
    pub renamed: Vec<(&'static str, String)>,
    pub rows: Vec<Terms>,
    /// The displacement of its first end, for the power that enters there.
    pub driving: Terms,
    /// Name of its displacement, if that can be a coordinate of the train; else empty.
    pub called: String,
    /// An effect of the element that the part does not have, because its table does not state the values.
    pub without: Option<&'static str>,
}

impl DraftPart {
    /// Whether the part has this effect of its element.
    pub fn has(&self, effect: &str) -> bool {
        self.without != Some(effect)
    }
}

/// Gears that mesh with one another; they have one phase.
pub(super) struct GearGroup {
    /// Its first mesh.
    pub mesh: String,
    /// Candidates for its phase, in order of preference.
    pub phases: Vec<Terms>,
    /// The gears: rotor, carrier, number of teeth.
    pub gears: Vec<DraftGear>,
    /// The parameter that is the base radius of its first gear.
    pub radius: String,
    /// Pairs of gears that mesh, as indices into `gears`.
    pub meshes: Vec<[usize; 2]>,
    /// The title of the table of each mesh, and whether the second gear is a ring.
    pub stated: Vec<(String, bool)>,
    /// Indices of its meshes among the parts.
    pub parts: Vec<usize>,
}

/// A gear on a rotor.
#[derive(Clone, PartialEq)]
pub(super) struct DraftGear {
    /// `None`: fixed to the ground.
    pub rotor: Option<usize>,
    pub carrier: Option<usize>,
    /// The parameter that is its number of teeth.
    pub teeth: String,
    /// -1 if its pitch count falls while that of the first gear of the group rises.
    pub sense: f64,
}

/// Two rotors that a part joins, for the senses of rotation. A part between a rotor and the ground makes no joint.
pub(super) struct Joint {
    pub ends: [usize; 2],
    /// Whether they turn in opposite directions, seen from one side.
    pub turns: bool,
    pub place: Place,
    pub part: String,
}

/// A planet set: its rotors, `None` where they are fixed to the ground.
pub(super) struct PlanetSet {
    pub name: String,
    pub sun: usize,
    pub ring: Option<usize>,
    pub carrier: Option<usize>,
    pub planets: Vec<usize>,
}

/// The content of the tables.
#[derive(Default)]
pub(super) struct Draft {
    pub rotors: Vec<Rotor>,
    pub geometry: Vec<Geometry>,
    pub parts: Vec<DraftPart>,
    pub groups: Vec<GearGroup>,
    pub joints: Vec<Joint>,
    pub planet_sets: Vec<PlanetSet>,
    /// Helical meshes whose axial motion is not yet in their deflection.
    pub axial: Vec<Axial>,
    /// Helical meshes, by their names, with the parameter that is the axial force over the mesh force.
    pub axial_forces: Vec<(String, String)>,
    /// Ring meshes: place, title of the table, and the parameters that are the numbers of teeth of the gear and of the ring.
    pub rings: Vec<(Place, String, [String; 2])>,
    /// Parameters from which other values of the tables follow: the parameter, and the key that states it.
    pub fixed: Vec<(String, String)>,
    /// Values that the tables state: name of the parameter, and the value as written.
    pub values: Vec<(String, Node)>,
    /// Values that no table states: `parameters.NAME` or `laws.NAME`, and the table to which it belongs.
    pub homes: Vec<(String, Home)>,
    /// Laws that the tables state.
    pub laws: Vec<(String, Node)>,
    /// Laws that hold if the scene does not state them in `[laws]`.
    pub usual_laws: Vec<(String, Node)>,
}

/// The name of a quantity of a part: `I1` for `I` of part `1`, `I_motor` for `I` of part `motor`.
pub(super) fn named(quantity: &str, part: &str) -> String {
    let joint = if part.is_empty() || part.starts_with(|c: char| c.is_ascii_digit()) { "" } else { "_" };
    format!("{quantity}{joint}{part}")
}
