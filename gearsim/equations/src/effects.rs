//! Sets of effects of a model.

use std::collections::HashSet;

use fixedbitset::FixedBitSet;
use indexmap::IndexSet;

use crate::model::{Effect, Law, Model, Torque};

/// A set of effects of a model.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Effects(FixedBitSet);

impl Effects {
    /// The effects of a model with these numbers.
    ///
    /// # Panics
    /// If the model has no such effect.
    pub fn numbered(model: &Model, numbers: impl IntoIterator<Item = usize>) -> Effects {
        numbers.into_iter().fold(Effects(FixedBitSet::with_capacity(model.effects.len())), Effects::with)
    }

    /// No effect.
    pub fn none(model: &Model) -> Effects {
        Effects::numbered(model, [])
    }

    /// All effects of the model.
    pub fn all(model: &Model) -> Effects {
        Effects::numbered(model, 0..model.effects.len())
    }

    /// The set with effect `i` of the model too.
    pub fn with(mut self, i: usize) -> Effects {
        self.0.insert(i);
        self
    }

    /// The set without effect `i` of the model.
    pub fn without(mut self, i: usize) -> Effects {
        self.0.remove(i);
        self
    }

    /// The numbers of the effects that `name` stands for: the effect with this name, or this effect at all parts of the model. Empty if
    /// there are none.
    pub fn numbers(name: &str, model: &Model) -> Vec<usize> {
        let all = model.effects.iter().enumerate().filter(|(_, effect)| effect.name == name || effect.of == Some(name));
        all.map(|(i, _)| i).collect()
    }

    /// Whether effect `i` of the model is in the set.
    #[inline]
    pub fn contains(&self, i: usize) -> bool {
        self.0.contains(i)
    }

    /// Whether no effect of the set excludes another one, or needs one that is missing.
    pub fn agree(&self, model: &Model) -> bool {
        self.contradictions(model).is_empty()
    }

    /// The effects of the set, in the model's order.
    fn of(&self, model: &Model) -> impl Iterator<Item = &'static Effect> {
        self.0.ones().map(move |i| &model.effects[i])
    }

    /// Whether the set has the effect `name`, or this effect at one of the parts of the model.
    pub fn has(&self, name: &str, model: &Model) -> bool {
        self.of(model).any(|effect| effect.name == name || effect.of == Some(name))
    }

    /// Whether a term that needs the effect `with` is active. A term that needs no effect is always active.
    pub fn activate(&self, with: Option<&str>, model: &Model) -> bool {
        with.is_none_or(|effect| self.has(effect, model))
    }

    /// The numbers of the external torques that scenes with these effects have.
    pub fn torques(&self, model: &Model) -> Vec<usize> {
        let has = |torque: &Torque| torque.with.iter().all(|effect| self.has(effect, model));
        (0..model.torques.len()).filter(|&i| has(&model.torques[i])).collect()
    }

    /// The names of the effects, in the model's order. If all parts have an effect, its common name replaces the names of the parts.
    pub fn names(&self, model: &Model) -> Vec<&'static str> {
        let absent = model.effects.iter().enumerate().filter(|(i, _)| !self.contains(*i));
        let not_all: HashSet<&str> = absent.filter_map(|(_, effect)| effect.of).collect();
        let name = |effect: &'static Effect| effect.of.filter(|of| !not_all.contains(of)).unwrap_or(effect.name);
        self.of(model).map(name).collect::<IndexSet<_>>().into_iter().collect()
    }

    /// Whether the phase of a law rolls in scenes with these effects: nothing else depends on the number of its whole pitches.
    pub fn rolls(&self, law: &Law, model: &Model) -> bool {
        law.rolling && !law.held.iter().any(|effect| self.has(effect, model))
    }

    /// Whether a coordinate of a model rotates without end in scenes with these effects. It does if it is the phase of a law that rolls.
    pub fn turns(&self, coordinate: &str, model: &Model) -> bool {
        model.laws.iter().any(|law| law.phase == coordinate && self.rolls(law, model))
    }

    /// The terms that make the cells of `model` nonlinear if it has these effects, as text. Empty if the cells are linear.
    pub fn nonlinear(&self, model: &Model) -> String {
        let all = |effects: &[&str]| effects.iter().all(|effect| self.has(effect, model));
        let with = model.nonlinear_with.iter().filter(|(effects, _)| all(effects));
        let all = std::iter::once(model.nonlinear).filter(|terms| !terms.is_empty()).chain(with.map(|(_, term)| *term));
        all.collect::<Vec<_>>().join("; ")
    }

    /// The contradictions in the set, as text: effects that exclude one another, and effects that need one that is missing. Empty if there
    /// are none.
    pub fn contradictions(&self, model: &Model) -> String {
        let of = |effect: &Effect| {
            let excluded = effect.excludes.iter().filter(|other| self.has(other, model));
            let lacking = effect.requires.iter().filter(|other| !self.has(other, model));
            let excluded = excluded.map(|other| format!("`{}` excludes `{other}`", effect.name));
            excluded.chain(lacking.map(|other| format!("`{}` needs `{other}`", effect.name))).collect::<Vec<_>>()
        };
        self.of(model).flat_map(of).collect::<Vec<_>>().join(", ")
    }

    /// The set of the effects with these names. A common name stands for the effect at all parts. `None` if the model lacks one of the
    /// effects.
    pub fn from_names<'a>(names: impl IntoIterator<Item = &'a str>, model: &Model) -> Option<Effects> {
        let mut named = names.into_iter().map(|name| Effects::numbers(name, model));
        named.try_fold(Effects::none(model), |set, named| {
            (!named.is_empty()).then(|| named.into_iter().fold(set, Effects::with))
        })
    }
}
