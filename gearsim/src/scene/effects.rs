//! Effect sets: conversion from and to names, and checks of combinations.

use super::Effects;
use super::document::Node;
use super::field;
use super::mistake::{Report, list};
use crate::model::{Effect, Model};

impl Effects {
    /// Whether effect `i` of the model is in the set.
    pub fn contains(self, i: usize) -> bool {
        i < u64::BITS as usize && self.0 >> i & 1 == 1
    }

    /// The names of the effects, in the model's order.
    pub fn names(self, model: &Model) -> Vec<&'static str> {
        model.effects.iter().enumerate().filter(|(i, _)| self.contains(*i)).map(|(_, effect)| effect.name).collect()
    }

    /// The terms that make cells of `model` nonlinear with these effects, as text; empty if cells are linear.
    pub fn nonlinear(self, model: &Model) -> String {
        let with = model.nonlinear_with.iter().filter(|(effect, _)| self.names(model).contains(effect));
        let all = std::iter::once(model.nonlinear).filter(|terms| !terms.is_empty()).chain(with.map(|(_, term)| *term));
        all.collect::<Vec<_>>().join("; ")
    }

    /// The effects of the set that exclude one another or need a missing one, as text; empty if there are none.
    pub fn contradictions(self, model: &Model) -> String {
        let names = self.names(model);
        let of = |effect: &Effect| {
            let excluded = effect.excludes.iter().filter(|other| names.contains(other));
            let lacking = effect.requires.iter().filter(|other| !names.contains(other));
            let excluded = excluded.map(|other| format!("`{}` excludes `{other}`", effect.name));
            excluded.chain(lacking.map(|other| format!("`{}` needs `{other}`", effect.name))).collect::<Vec<_>>()
        };
        let present = model.effects.iter().filter(|effect| names.contains(&effect.name));
        present.flat_map(of).collect::<Vec<_>>().join(", ")
    }

    /// The set of the effects with these names; `None` if the model lacks one of them.
    pub fn from_names<'a>(names: impl IntoIterator<Item = &'a str>, model: &Model) -> Option<Effects> {
        let index = |name| model.effects.iter().position(|effect| effect.name == name);
        names.into_iter().try_fold(Effects(0), |set, name| Some(set.with(index(name)?)))
    }

    fn with(self, i: usize) -> Effects {
        Effects(self.0 | 1u64.checked_shl(i as u32).unwrap_or(0))
    }
}

/// Reads `effects`.
pub(super) fn read(node: &Node, model: &Model, report: &mut Report) -> Option<Effects> {
    let allowed: Vec<_> = model.effects.iter().map(|effect| effect.name).collect();
    let chosen = field::names("effects", node, "effect", &allowed, report)?;
    for (n, &i) in chosen.iter().enumerate() {
        let effect = &model.effects[i];
        let name = effect.name;
        let has = |other: &&&str| chosen.iter().any(|j| allowed[*j] == **other);
        let lacking: Vec<_> = effect.requires.iter().filter(|other| !has(other)).copied().collect();
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
    Some(chosen.into_iter().fold(Effects(0), Effects::with))
}
