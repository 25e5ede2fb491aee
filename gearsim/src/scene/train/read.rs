//! Reads the tables of a train.

use super::KEYS;
use super::draft::{Draft, DraftPart, Joint, Terms, named};
use crate::scene::document::{Entry, Node, Place, Value};
use crate::scene::keys::Key;
use crate::scene::mistake::{Home, Report};
use crate::scene::{field, keys};
use crate::tolerance::scene::ROTORS;

/// The name of what does not turn.
pub(super) const GROUND: &str = "ground";

/// Reads all tables. `None` if a mistake was reported that leaves no train.
pub(super) fn draft(entries: &[Entry], root: &Place, report: &mut Report) -> Option<Draft> {
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
                // No part could name a rotor.
                "rotors" => return None,
                _ => continue,
            }
        };
        let mut items: Vec<&Entry> = items.iter().collect();
        // In the order of the text: a table of TOML has none of its own.
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

/// A table of one part: its path, keys and place.
pub(super) struct Item<'a> {
    pub table: &'static str,
    pub name: &'a str,
    pub entries: &'a [Entry],
    pub place: &'a Place,
}

impl Item<'_> {
    pub fn path(&self, key: &str) -> String {
        format!("{}.{}.{key}", self.table, self.name)
    }

    pub fn title(&self) -> String {
        format!("[{}.{}]", self.table, self.name)
    }

    pub fn get(&self, key: &str) -> Option<&Node> {
        keys::get(self.entries, key)
    }

    /// The effect of the damper of its element, if the table has no damper.
    pub fn undamped(&self) -> Option<&'static str> {
        self.get("damping").is_none().then_some("viscous_friction_x")
    }
}

impl Reader<'_> {
    /// Whether the name of a part can be part of the names of parameters.
    fn is_name(&mut self, table: &str, item: &Entry) -> bool {
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

    fn item(&mut self, table: &'static str, entry: &Entry) {
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
            _ => self.torque(&item),
        }
    }

    /// Reports unknown keys of an item. A dot before one may have been meant as a part of the item's name.
    pub fn known(&mut self, item: &Item<'_>, allowed: &[Key]) {
        let (name, allowed) = (item.name, keys::names(&[allowed]));
        for Entry { key, place, .. } in keys::unknown(item.entries, &allowed) {
            let mut help = keys::choices(key, &allowed);
            let before = place.span.start.saturating_sub(1)..place.span.start;
            if !help.starts_with("did you mean") && self.report.text(&Place { span: before, ..*place }) == "." {
                help += &format!("\na name has no dots: `{name}.{key}` is the key `{key}` of `{name}`");
            }
            self.report.add(place, format!("{} has no `{key}`", item.title()), "unknown key", help);
        }
    }

    /// A key of an item that it must have.
    pub fn needed<'a>(&mut self, item: &'a Item<'_>, key: &'static str, example: &str) -> Option<&'a Node> {
        let node = item.get(key);
        if node.is_none() {
            keys::missing(&[(key, format!("{key} = {example}"))], &item.title(), item.place, self.report);
        }
        node
    }

    /// A value that is a parameter: it is read with `[parameters]`.
    pub fn value(&mut self, parameter: String, node: Option<&Node>) {
        self.draft.values.extend(node.map(|node| (parameter, node.clone())));
    }

    /// The value of a key of an item, which is a parameter.
    pub fn stated(&mut self, parameter: String, item: &Item<'_>, key: &'static str) {
        match item.get(key) {
            Some(node) => self.value(parameter, Some(node)),
            None => self.lacking(format!("parameters.{parameter}"), item, key),
        }
    }

    /// Notes where a value that is not stated belongs.
    pub fn lacking(&mut self, name: String, item: &Item<'_>, key: &'static str) {
        self.draft.homes.push((name, Home { title: item.title(), key, place: item.place.clone() }));
    }

    /// The laws of an item: the names of their quantities, the keys, and what is stated.
    pub fn laws(&mut self, item: &Item<'_>, mesh: &str, laws: [(&str, &'static str, Option<Node>); 2]) {
        for (quantity, key, stated) in laws {
            let name = named(quantity, mesh);
            match stated {
                Some(node) => self.draft.laws.push((name, node)),
                None => self.lacking(format!("laws.{name}"), item, key),
            }
        }
    }

    /// The rotor that a key names; `Some(None)` for the ground, if that is allowed.
    pub fn end(&mut self, path: &str, node: &Node, ground: bool) -> Option<Option<usize>> {
        let turning = self.draft.rotors.iter().enumerate().filter(|(_, rotor)| rotor.along.is_none());
        let (numbers, mut names): (Vec<usize>, Vec<&str>) = turning.map(|(i, rotor)| (i, rotor.name.as_str())).unzip();
        if ground {
            names.push(GROUND);
        }
        let i = field::choice(path, node, "rotor", &names, self.report)?;
        Some(numbers.get(i).copied())
    }

    /// The rotor of an item.
    pub fn rotor_of(&mut self, item: &Item<'_>) -> Option<usize> {
        let node = self.needed(item, "rotor", "\"...\"")?;
        self.end(&item.path("rotor"), node, false)?
    }

    /// The two rotors of an item.
    pub fn between(&mut self, item: &Item<'_>, ground: bool) -> Option<[Option<usize>; 2]> {
        let node = self.needed(item, "between", "[\"...\", \"...\"]")?;
        let path = item.path("between");
        let items = field::array(&path, node, "[\"motor\", \"1\"]", self.report)?;
        let [a, b] = items else {
            let help = "a part is between two rotors: between = [\"motor\", \"1\"]";
            self.report.add(
                &node.place,
                format!("`{path}` must have two names, not {}", items.len()),
                "two names",
                help,
            );
            return None;
        };
        let ends = [self.end(&path, a, ground), self.end(&path, b, ground)];
        let [Some(a), Some(b)] = ends else { return None };
        if a == b {
            let help = "name two different rotors";
            self.report.add(&node.place, format!("{} joins a rotor with itself", item.title()), "twice the same", help);
            return None;
        }
        Some([a, b])
    }

    /// Adds a part with one coordinate.
    pub fn part(&mut self, item: &Item<'_>, element: &'static str, called: String, rows: Vec<Terms>) {
        let (name, place) = (item.name.to_string(), item.place.clone());
        self.draft.parts.push(DraftPart {
            element,
            name,
            place,
            renamed: vec![],
            rows,
            driving: vec![],
            called,
            without: None,
        });
    }

    /// Notes that a part joins two rotors.
    pub fn join(&mut self, item: &Item<'_>, ends: [Option<usize>; 2], turns: bool) {
        if let [Some(a), Some(b)] = ends {
            let (place, part) = (item.place.clone(), item.title());
            self.draft.joints.push(Joint { ends: [a, b], turns, place, part });
        }
    }
}
