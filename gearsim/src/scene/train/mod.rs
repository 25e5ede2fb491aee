//! Drivetrains whose parts a scene lists in tables: `model = "train"`.
//!
//! [`read`] turns the tables of a scene into a [`Draft`]: rotors, and parts along linear forms of their rotations. [`basis`] chooses the
//! coordinates. [`compose`] makes the description of the model from those of the elements, and the [`Train`], from which the engine puts
//! the equations together. Values that stand in the tables are moved to `[parameters]` and `[laws]` with their places in the text, so that
//! the rest of the scene is read as that of any model.
//!
//! A rotation is positive in the direction in which a rotor turns in normal drive: gears that mesh on fixed axes turn in opposite
//! directions, and both rotations are positive. Sun, ring, carrier and planets of one set have the same positive direction.

mod assembly;
mod axial;
mod basis;
mod bodies;
mod called;
mod compose;
mod draft;
mod gears;
mod groups;
mod item;
mod merge;
mod meshes;
mod planet_numbers;
mod planets;
mod radii;
mod read;
mod relative;
mod rigid;
mod senses;
mod tables;
mod text;
mod torques;

use super::document::{KeyEntry, Place};
use super::keys::{Key, Kind, key};
use super::mistake::Report;
use crate::model::Model;
use crate::train::Train;
use std::sync::Arc;

pub(super) use meshes::Meshes;
pub(crate) use planets::in_place_of;
use radii::OfTrain;

/// What [`read`] returns.
pub(super) struct Listed {
    pub model: &'static Model,
    pub train: Arc<Train>,
    /// The radii to which values per squared radius refer.
    pub radii: OfTrain,
    pub meshes: Meshes,
}

/// Reads the train that a scene lists; `bare` has the elements. The values in its tables are moved to `[parameters]` and `[laws]` of
/// `entries`. The places are the beginning of the scene and its end, where tables would be added. `None` if a mistake was reported.
pub(super) fn read(
    bare: &'static Model,
    entries: &mut Vec<KeyEntry>,
    [root, end]: [&Place; 2],
    report: &mut Report,
) -> Option<Listed> {
    let draft = read::draft(entries, root, report)?;
    senses::joined(&draft, report);
    let agree = senses::check(&draft, report);
    let draft = tables::fill(draft, entries, end, report)?;
    agree?;
    gears::check_rings(&draft, &|name| tables::number(entries, name), report);
    let values = tables::numbers(&draft, entries);
    let radii = radii::of(&draft, &|name| tables::number(entries, name));
    let (model, train) = compose::model(bare, &draft, &values, report)?;
    Some(Listed { model, train, radii, meshes: meshes::of(&draft) })
}

/// The tables of a train. Each has a table for each part, under the name of the part.
pub(super) const KEYS: &[Key] = &[
    key("rotors", Kind::Named(bodies::ROTORS), "required by `model = \"train\"`", "what turns"),
    key("shafts", Kind::Named(bodies::SHAFTS), "none", "torsional springs between rotors"),
    key("supports", Kind::Named(bodies::SUPPORTS), "none", "torsional springs between a rotor and the ground"),
    key("meshes", Kind::Named(gears::MESHES), "none", "pairs of gears"),
    key("planets", Kind::Named(planets::SETS), "none", "planet sets: sun, ring, carrier and planets"),
    key("thrust_bearings", Kind::Named(axial::THRUST_BEARINGS), "none", "axial motion of rotors with helical gears"),
    key(
        "bearings",
        Kind::Named(bodies::BEARINGS),
        "none",
        "friction between a rotor and the ground, or between two rotors",
    ),
    key("clutches", Kind::Named(bodies::CLUTCHES), "none", "overrunning clutches"),
    key(
        "end_stops",
        Kind::Named(bodies::END_STOPS),
        "none",
        "elastic stops of a rotor, or of a rotor relative to another",
    ),
    key("drives", Kind::Named(torques::DRIVES), "none", "driving torques"),
    key("loads", Kind::Named(torques::LOADS), "none", "loads"),
];

/// The keys of parts that need the effect, e.g. `shafts.NAME.damping`.
pub(super) fn keys_of(effect: &str) -> Vec<String> {
    fn walk(path: &str, kind: Kind, effect: &str, found: &mut Vec<String>) {
        match kind {
            Kind::Table(lists) => {
                for key in lists.iter().flat_map(|keys| keys.iter()) {
                    let path = format!("{path}.{}", key.name);
                    match key.effect {
                        Some(of) if of == effect => found.push(path),
                        _ => walk(&path, key.kind, effect, found),
                    }
                }
            }
            Kind::Named(all) => all.iter().for_each(|named| walk(&format!("{path}.NAME"), named.kind, effect, found)),
            _ => {}
        }
    }
    let mut found = vec![];
    KEYS.iter().for_each(|key| walk(key.name, key.kind, effect, &mut found));
    found
}

/// The default of a value that may be stated in `[parameters]` instead, by the name that `gearsim models SCENE` shows.
const ELSEWHERE: &str = "in [parameters]";
/// A rotor, as the value of a key.
const ROTOR: Kind = Kind::Name("a rotor");
/// Two rotors, as the value of a key.
const TWO_ROTORS: Kind = Kind::List(&Kind::Name("a rotor or \"ground\""));
