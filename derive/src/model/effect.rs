//! Effects. An effect is a part of the equations. It is active only in scenes that name it.

use super::Model;
use crate::expr::{Expr, Kind};

/// An effect.
pub(crate) struct Effect {
    pub name: String,
    /// For an effect of one part, the effect of all parts: `backlash` of `backlash_12`.
    pub of: Option<String>,
    pub requires: Vec<String>,
    pub excludes: Vec<String>,
    pub doc: String,
}

impl Model {
    /// Declares an effect: what `add` adds is in the equations only of scenes that name the effect. Several components may add
    /// to one effect, one after another, each with the same `name` and `doc`. Inside the closure of another effect: energies and torques
    /// are in the equations only of scenes that name both.
    pub fn effect(&mut self, name: &str, doc: &str, add: impl FnOnce(&mut Model)) {
        if !self.effects.iter().any(|e| e.name == name && e.doc == doc) {
            self.effects.push(Effect {
                name: name.into(),
                of: None,
                requires: vec![],
                excludes: vec![],
                doc: doc.into(),
            });
        }
        self.within.push(name.into());
        add(self);
        self.within.pop();
    }

    /// The effect `name` at one part of the model, which scenes may name alone: `backlash_12`; `backlash` is that of all parts. A model
    /// whose only part has no name has the effect `name` itself. Otherwise as [`Model::effect`]. Returns the name of the effect.
    pub fn part_effect(&mut self, name: &str, part: &str, doc: &str, add: impl FnOnce(&mut Model)) -> String {
        if part.is_empty() {
            self.effect(name, doc, add);
            return name.into();
        }
        let own = format!("{name}_{part}");
        self.effect(&own, doc, add);
        self.effects.iter_mut().filter(|effect| effect.name == own).for_each(|effect| effect.of = Some(name.into()));
        own
    }

    /// The term `e` in scenes with the effect `name`, and zero in others. Use it if the effect `name` changes a term of another effect.
    pub fn only_with(&self, name: &str, e: Expr) -> Expr {
        Expr::var(Kind::Marker, name) * e
    }

    /// Declares that the effect `name`, declared before, needs each of `others`.
    pub fn require(&mut self, name: &str, others: &[&str]) {
        self.relate(name, others, |effect| &mut effect.requires);
    }

    /// Declares that the effect `name`, declared before, excludes each of `others`: a scene may name one side only.
    pub fn exclude(&mut self, name: &str, others: &[&str]) {
        self.relate(name, others, |effect| &mut effect.excludes);
    }

    /// Adds `others` to a list of the effect `name`, each once.
    fn relate(&mut self, name: &str, others: &[&str], list: fn(&mut Effect) -> &mut Vec<String>) {
        for effect in self.effects.iter_mut().filter(|effect| effect.name == name) {
            let list = list(effect);
            for other in others {
                if !list.iter().any(|known| known == other) {
                    list.push(other.to_string());
                }
            }
        }
    }

    /// The expression times the markers of the effects whose closures are running.
    pub(super) fn marked(&self, e: Expr) -> Expr {
        self.within.iter().fold(e, |e, effect| Expr::var(Kind::Marker, effect) * e)
    }

    /// The innermost effect whose closure is running.
    pub(super) fn innermost(&self) -> Option<String> {
        self.within.last().cloned()
    }
}
