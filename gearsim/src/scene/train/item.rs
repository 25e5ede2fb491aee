//! The table of one part of a train, and how its keys are read.

use super::draft::{DraftPart, Joint, Terms, named};
use super::read::{GROUND, Reader};
use crate::scene::document::{KeyEntry, Node, Place};
use crate::scene::keys::Key;
use crate::scene::mistake::Home;
use crate::scene::{field, keys};

/// A table of one part: its path, keys and place.
pub(super) struct Item<'a> {
    pub table: &'static str,
    pub name: &'a str,
    pub entries: &'a [KeyEntry],
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

    /// The effect of the damper of the element, if the table states no damping. The part does not have this effect.
    pub fn undamped(&self) -> Option<&'static str> {
        self.get("damping").is_none().then_some("viscous_friction_x")
    }
}

impl Reader<'_> {
    /// Reports unknown keys of an item. If there is a dot before a key, the help says that names have no dots.
    pub fn known(&mut self, item: &Item<'_>, allowed: &[Key]) {
        let (name, allowed) = (item.name, keys::names(&[allowed]));
        for KeyEntry { key, place, .. } in keys::unknown(item.entries, &allowed) {
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

    /// Notes the value of a parameter, which is then read with `[parameters]`.
    pub fn value(&mut self, parameter: String, node: Option<&Node>) {
        self.draft.values.extend(node.map(|node| (parameter, node.clone())));
    }

    /// Notes the value of a parameter that a key of an item states, or the table that lacks it.
    pub fn stated(&mut self, parameter: String, item: &Item<'_>, key: &'static str) {
        match item.get(key) {
            Some(node) => self.value(parameter, Some(node)),
            None => self.lacking(format!("parameters.{parameter}"), item, key),
        }
    }

    /// Notes the table to which a value belongs that is not stated.
    pub fn lacking(&mut self, name: String, item: &Item<'_>, key: &'static str) {
        self.draft.homes.push((name, Home { title: item.title(), key, place: item.place.clone() }));
    }

    /// Notes the laws of an item. `laws` has their quantities, their keys and the stated values.
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
