//! Effect sets: conversion from and to names, and checks of combinations.

use super::Effects;
use super::document::Node;
use super::field;
use super::mistake::{Report, list};
use crate::model::{Effect, Law, Model, Torque};

impl Effects {
    /// Whether effect `i` of the model is in the set.
    pub fn contains(self, i: usize) -> bool {
        i < u64::BITS as usize && self.0 >> i & 1 == 1
    }

    /// The effects of the set, in the model's order.
    fn of(self, model: &Model) -> impl Iterator<Item = &'static Effect> + use<> {
        model.effects.iter().enumerate().filter(move |(i, _)| self.contains(*i)).map(|(_, effect)| effect)
    }

    /// Whether the set has the effect `name`, or that of one of its parts.
    pub fn has(self, name: &str, model: &Model) -> bool {
        self.of(model).any(|effect| effect.name == name || effect.of == Some(name))
    }

    /// Whether a term that needs the effect `with` is active; a term without effect always is.
    pub fn activate(self, with: Option<&str>, model: &Model) -> bool {
        with.is_none_or(|effect| self.has(effect, model))
    }

    /// The external torques of a model that scenes with these effects have, by their numbers.
    pub fn torques(self, model: &Model) -> Vec<usize> {
        let has = |torque: &Torque| torque.with.iter().all(|effect| self.has(effect, model));
        (0..model.torques.len()).filter(|&i| has(&model.torques[i])).collect()
    }

    /// The names of the effects, in the model's order. If all parts have an effect, its name stands for them.
    pub fn names(self, model: &Model) -> Vec<&'static str> {
        let of_all = |name: &str| {
            model.effects.iter().filter(|e| e.of == Some(name)).all(|e| self.of(model).any(|o| o.name == e.name))
        };
        let mut names: Vec<&'static str> = vec![];
        for effect in self.of(model) {
            let name = effect.of.filter(|of| of_all(of)).unwrap_or(effect.name);
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
    }

    /// Whether the phase of a law rolls in scenes with these effects: nothing else depends on its whole pitches.
    pub fn rolls(self, law: &Law, model: &Model) -> bool {
        law.rolling && !law.held.iter().any(|effect| self.has(effect, model))
    }

    /// Whether a coordinate of a model rotates without end in scenes with these effects. It does if it is the phase of a law that rolls.
    pub fn turns(self, coordinate: &str, model: &Model) -> bool {
        model.laws.iter().any(|law| law.phase == coordinate && self.rolls(law, model))
    }

    /// The terms that make cells of `model` nonlinear with these effects, as text; empty if cells are linear.
    pub fn nonlinear(self, model: &Model) -> String {
        let with = model.nonlinear_with.iter().filter(|(effect, _)| self.has(effect, model));
        let all = std::iter::once(model.nonlinear).filter(|terms| !terms.is_empty()).chain(with.map(|(_, term)| *term));
        all.collect::<Vec<_>>().join("; ")
    }

    /// The effects of the set that exclude one another or need a missing one, as text; empty if there are none.
    pub fn contradictions(self, model: &Model) -> String {
        let of = |effect: &Effect| {
            let excluded = effect.excludes.iter().filter(|other| self.has(other, model));
            let lacking = effect.requires.iter().filter(|other| !self.has(other, model));
            let excluded = excluded.map(|other| format!("`{}` excludes `{other}`", effect.name));
            excluded.chain(lacking.map(|other| format!("`{}` needs `{other}`", effect.name))).collect::<Vec<_>>()
        };
        self.of(model).flat_map(of).collect::<Vec<_>>().join(", ")
    }

    /// The set of the effects with these names, those of all parts for an effect of parts; `None` if the model lacks one of them.
    pub fn from_names<'a>(names: impl IntoIterator<Item = &'a str>, model: &Model) -> Option<Effects> {
        let mut named = names.into_iter().map(|name| named(name, model));
        named.try_fold(Effects(0), |set, named| (!named.is_empty()).then(|| named.into_iter().fold(set, Effects::with)))
    }

    fn with(self, i: usize) -> Effects {
        Effects(self.0 | 1u64.checked_shl(i as u32).unwrap_or(0))
    }
}

/// The indices of the effect `name`, or of the effect of that name at each part.
fn named(name: &str, model: &Model) -> Vec<usize> {
    let all = model.effects.iter().enumerate().filter(|(_, effect)| effect.name == name || effect.of == Some(name));
    all.map(|(i, _)| i).collect()
}

/// The names that a scene may use: of effects, and of effects of parts for all parts.
pub fn allowed(model: &Model) -> Vec<&'static str> {
    let mut names = vec![];
    for effect in model.effects {
        names.extend(effect.of.filter(|of| !names.contains(of)));
        names.push(effect.name);
    }
    names
}

/// Reads `effects`.
pub(super) fn read(node: &Node, model: &Model, report: &mut Report) -> Option<Effects> {
    let allowed = allowed(model);
    let names = field::names("effects", node, "effect", &allowed, report)?;
    let mut chosen: Vec<usize> = vec![];
    for name in names {
        chosen.extend(named(allowed[name], model).into_iter().filter(|i| !chosen.contains(i)).collect::<Vec<_>>());
    }
    let set = chosen.iter().copied().fold(Effects(0), Effects::with);
    for (n, &i) in chosen.iter().enumerate() {
        let effect = &model.effects[i];
        let name = effect.name;
        let lacking: Vec<_> = effect.requires.iter().filter(|other| !set.has(other, model)).copied().collect();
        if !lacking.is_empty() {
            let message = format!("effect `{name}` needs {}", list(&lacking));
            let help = format!("add {}, or leave out `{name}`", list(&lacking));
            report.add(&node.place, message, "an effect is missing", help);
        }
        for other in chosen[..n].iter().map(|j| &model.effects[*j]) {
            if effect.excludes.contains(&other.name) || other.excludes.contains(&name) {
                let message = format!("effects `{}` and `{name}` contradict each other", other.name);
                let help = format!("leave out `{}` or `{name}`", other.name);
                report.add(&node.place, message, "not both", help);
            }
        }
    }
    Some(set)
}
