//! Refuses shafts and supports that a scene states to be rigid. Each needs a finite stiffness.

use super::item::Item;
use super::read::Reader;
use crate::scene::document::{Node, Value};
use crate::scene::keys::Key;

/// Words for an infinite stiffness.
const RIGID: [&str; 5] = ["rigid", "inf", "+inf", "infinite", "infinity"];

impl Reader<'_> {
    /// Refuses a shaft or a support that is stated to be rigid. Returns whether it is.
    pub(super) fn not_elastic(&mut self, item: &Item<'_>, ends: [Option<usize>; 2]) -> bool {
        let rigid = |node: &&Node| match &node.value {
            Value::Number(k) => k.is_infinite(),
            Value::Text(text) => text.split_whitespace().next().is_some_and(|word| RIGID.contains(&word)),
            _ => false,
        };
        let stated = item.entries.iter().find(|entry| entry.key == "rigid").map(|entry| &entry.place);
        let Some(place) = stated.or_else(|| item.get("stiffness").filter(rigid).map(|node| &node.place)) else {
            return false;
        };
        let names: Vec<&str> = ends.iter().flatten().map(|&i| self.draft.rotors[i].name.as_str()).collect();
        let instead = match names[..] {
            [a, b] => {
                format!("for a rigid one make `{a}` and `{b}` one rotor, with the sum of their moments of inertia")
            }
            [a] => format!("if `{a}` cannot turn, leave it out, and name \"ground\" in its place"),
            _ => String::new(),
        };
        let help = format!("give a finite stiffness, e.g. stiffness = \"10 kN*m/rad\"; {instead}");
        self.report.add(place, format!("{} is stated to be rigid", item.title()), "cannot be rigid", help);
        true
    }

    /// Reports unknown keys other than `rigid`, which has its own message.
    pub(super) fn known_but_rigid(&mut self, item: &Item<'_>, allowed: &[Key]) {
        let others: Vec<_> = item.entries.iter().filter(|entry| entry.key != "rigid").cloned().collect();
        self.known(&Item { entries: &others, ..*item }, allowed);
    }
}
