//! Reads the tables of a train.

use super::KEYS;
use super::draft::Draft;
use super::item::Item;
use crate::scene::document::{KeyEntry, Place, Value};
use crate::scene::mistake::Report;
use crate::scene::{field, keys};
use crate::tolerance::scene::ROTORS;

/// The name of the ground, which does not turn.
pub(super) const GROUND: &str = "ground";

/// Reads all tables. `None` if a mistake was reported.
pub(super) fn draft(entries: &[KeyEntry], root: &Place, report: &mut Report) -> Option<Draft> {
    let before = report.len();
    if keys::get(entries, "rotors").is_none() {
        let lines = "[rotors]\nmotor = \"... kg*m^2\"  # name = moment of inertia".to_string();
        keys::missing(&[("[rotors]", lines)], "a scene of the model `train`", root, report);
        return None;
    }
    let mut reader = Reader { draft: Draft::default(), report };
    for table in keys::names(&[KEYS]) {
        let Some(node) = keys::get(entries, table) else { continue };
        if matches!(node.value, Value::Array(_)) {
            let help = format!("each part has a table of its own, under its name: [{table}.NAME]");
            let message = format!("`{table}` must be a table of named parts, not an array");
            reader.report.add(&node.place, message, "parts without names", help);
        }
        let items = match &node.value {
            Value::Array(_) => None,
            _ => field::table(table, node, reader.report),
        };
        let Some(items) = items else {
            match table {
                // Without rotors no other part can be read.
                "rotors" => return None,
                _ => continue,
            }
        };
        let mut items: Vec<&KeyEntry> = items.iter().collect();
        // The entries of a TOML table have no order: take the order of the text.
        items.sort_by_key(|item| (item.place.source, item.place.span.start));
        for item in items {
            if reader.is_name(table, item) {
                reader.item(table, item);
            }
        }
    }
    reader.move_along_axes();
    let draft = reader.draft;
    if draft.rotors.is_empty() && report.len() == before {
        let place = keys::get(entries, "rotors").map_or(root, |node| &node.place);
        report.add(place, "a train has at least one rotor", "no rotor", "add for example motor = \"0.1 kg*m^2\"");
    }
    let rotors = draft.rotors.iter().filter(|rotor| rotor.along.is_none()).count();
    if rotors > ROTORS {
        let message = format!("a train has at most {ROTORS} rotors, not {rotors}");
        report.add(root, message, "too many rotors", "join neighbouring discs");
    }
    (report.len() == before).then_some(draft)
}

pub(super) struct Reader<'a> {
    pub draft: Draft,
    pub report: &'a mut Report,
}

impl Reader<'_> {
    /// Whether the name of a part can be part of the names of parameters.
    fn is_name(&mut self, table: &str, item: &KeyEntry) -> bool {
        let fits = |name: &str| {
            name.len() <= 32 && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') && name != GROUND
        };
        if fits(&item.key) && !item.key.is_empty() {
            return true;
        }
        let message = format!("`{}` cannot be a name in [{table}]", item.key);
        let help = format!("use letters, digits and `_`, at most 32; `{GROUND}` is what does not turn");
        self.report.add(&item.place, message, "not a name", help);
        false
    }

    fn item(&mut self, table: &'static str, entry: &KeyEntry) {
        if table == "rotors" {
            return self.rotor(entry);
        }
        let Some(entries) = field::table(&format!("{table}.{}", entry.key), &entry.node, self.report) else { return };
        let item = Item { table, name: &entry.key, entries, place: &entry.place };
        match table {
            "shafts" => self.shaft(&item),
            "supports" => self.support(&item),
            "meshes" => self.mesh(&item),
            "planets" => self.planets(&item),
            "thrust_bearings" => self.thrust_bearing(&item),
            "bearings" => self.bearing(&item),
            "clutches" => self.clutch(&item),
            "end_stops" => self.end_stop(&item),
            _ => self.torque(&item),
        }
    }
}
