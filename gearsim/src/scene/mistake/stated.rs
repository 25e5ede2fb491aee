//! The keys of values in the tables of a train. These values are moved to `[parameters]` and `[laws]`, but messages name the keys that the
//! author wrote.

use std::collections::HashMap;

use crate::scene::document::Place;

/// The keys of tables, by the names to which their values are moved.
#[derive(Debug, Clone, Default)]
pub(crate) struct Stated {
    /// `shafts.ab.stiffness` for `parameters.k_ab`.
    keys: HashMap<String, String>,
    /// The tables to which values belong that no table states.
    homes: HashMap<String, Home>,
}

/// The table to which a value belongs.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Home {
    /// `[shafts.ab]`.
    pub title: String,
    /// `stiffness`.
    pub key: &'static str,
    pub place: Place,
}

impl Stated {
    /// Notes that a value is written at `key`.
    pub fn written(&mut self, name: String, key: String) {
        self.keys.insert(name, key);
    }

    /// Notes where a value would be written.
    pub fn belongs(&mut self, name: String, home: Home) {
        self.homes.insert(name, home);
    }

    /// The table that lacks the value `name`.
    pub fn home(&self, name: &str) -> Option<&Home> {
        self.homes.get(name)
    }

    /// The key at which a value is written.
    pub fn key(&self, name: &str) -> Option<&str> {
        self.keys.get(name).map(String::as_str)
    }

    /// The key at which a value is written, or would be.
    pub fn place_of(&self, name: &str) -> String {
        let home = || self.home(name).map(|home| format!("{}.{}", home.title.trim_matches(['[', ']']), home.key));
        self.key(name).map(String::from).or_else(home).unwrap_or_else(|| name.into())
    }

    /// A message in which names in backquotes and titles of laws are replaced by the keys of tables.
    pub fn renamed(&self, text: String) -> String {
        if self.keys.is_empty() {
            return text;
        }
        let parts = text.split('`').enumerate();
        let parts = parts.map(|(i, part)| if i % 2 == 1 { self.quoted(part) } else { self.titles(part) });
        parts.collect::<Vec<_>>().join("`")
    }

    /// A help text. A parameter at its beginning, as in "`k_ab` is the stiffness of the shaft", is replaced by its key.
    pub fn explained(&self, help: String) -> String {
        let name =
            help.strip_prefix('`').and_then(|rest| rest.split_once('`')).filter(|(_, rest)| rest.starts_with(" is "));
        match name.and_then(|(name, rest)| Some((self.key(&format!("parameters.{name}"))?, rest))) {
            Some((key, rest)) => format!("`{key}`{rest}"),
            None => help,
        }
    }

    /// The key for a name in backquotes, which may go on below a known name: `laws.k_m.steps.0.value`.
    fn quoted(&self, name: &str) -> String {
        let ends = name.match_indices('.').map(|(at, _)| at).chain([name.len()]);
        let within = ends.rev().find_map(|end: usize| Some(format!("{}{}", self.key(&name[..end])?, &name[end..])));
        within.unwrap_or_else(|| name.into())
    }

    /// A text without backquotes in which titles such as `[laws.k_m]` are replaced.
    fn titles(&self, text: &str) -> String {
        let Some((before, rest)) = text.split_once("[laws.") else { return text.into() };
        let Some((name, after)) = rest.split_once(']') else { return text.into() };
        let key = self.key(&format!("laws.{name}")).map_or_else(|| format!("laws.{name}"), String::from);
        format!("{before}[{key}]{}", self.titles(after))
    }
}
