//! What a person chose on the page, and how it is written into the text of the scene.

use std::collections::BTreeMap;

use serde::Deserialize;
use toml_edit::{Item, Value};

use super::controls::offered;
use super::text::with_unit;
use crate::library::{usual_levels, usual_value};
use crate::model::Role;
use crate::page::run::View;
use crate::scene::quantity::Quantity;
use crate::scene::text::{self, Text};
use crate::scene::{Effects, Scene};

/// The state of the page. Values that it does not state are those of the scene.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct Choice {
    /// Numbers by key, each in the unit of its control.
    pub values: BTreeMap<String, f64>,
    /// The effects, by their names in the model.
    pub effects: Option<Vec<String>>,
    /// The solver.
    pub solver: Option<SolverChoice>,
    /// The identifiers of the sections that a person sees: the answer to `run` has these sections, the answer to `rest` the others. If
    /// empty, the answer to `run` has all sections.
    pub seen: Vec<String>,
    /// The part of the plots that a person sees. If it is stated, the answer to `run` has only this part, and the answer to `rest` has all
    /// sections.
    pub view: Option<View>,
    /// If true, the answer to `run` comes after the end of the run. If false, the answer to a long run has its beginning.
    pub whole: bool,
    /// Number of the choice. It is used in the identifiers of the arrays of its plots.
    pub number: u32,
}

/// The keys of `[run]` for the solver. `None` removes a key from the text.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct SolverChoice {
    /// Name of the method.
    pub method: Option<String>,
    /// Tolerance of a method with adaptive steps.
    pub tolerance: Option<f64>,
    /// Step \[s\] of a method with fixed steps.
    pub step: Option<f64>,
}

impl Choice {
    /// Writes the choice into the text of `scene`.
    pub fn write(&self, scene: &Scene, text: &mut Text) {
        self.write_effects(scene, text);
        complete(scene, text);
        for leaf in text.leaves() {
            if let Some(number) = self.values.get(&leaf.key()) {
                text.set(&leaf, *number);
            }
        }
        for offer in offered(scene, text) {
            if let Some(number) = self.values.get(&offer.key()).filter(|number| **number != offer.number) {
                let path: Vec<_> = offer.path.iter().map(String::as_str).collect();
                text.put(&path, with_unit(*number, &offer.unit));
            }
        }
        if let Some(solver) = &self.solver {
            solver.write(text);
        }
    }

    fn write_effects(&self, scene: &Scene, text: &mut Text) {
        let Some(chosen) = &self.effects else { return };
        let names = |names: &[String]| Effects::from_names(names.iter().map(String::as_str), scene.model);
        match names(chosen) {
            Some(set) if names(&text.names("effects")).as_ref() == Some(&set) => {}
            Some(set) => text.set_names("effects", &set.names(scene.model)),
            None => text.set_names("effects", &chosen.iter().map(String::as_str).collect::<Vec<_>>()),
        }
    }
}

impl SolverChoice {
    fn write(&self, text: &mut Text) {
        match &self.method {
            None => text.remove("run", "method"),
            Some(name) if text.at(&["run", "method"]).and_then(Item::as_str) == Some(name) => {}
            Some(name) => text.put(&["run", "method"], Value::from(name.as_str())),
        }
        let stated = |text: &Text, key: &str| text.leaves().into_iter().find(|leaf| leaf.path == ["run", key]);
        for (key, number, unit) in [("tolerance", self.tolerance, ""), ("step", self.step, "s")] {
            match (number, stated(text, key)) {
                (None, _) => text.remove("run", key),
                // The step may be written in another unit.
                (Some(x), Some(leaf)) if si(leaf.number, &leaf.unit) == x => {}
                (Some(x), _) => text.put(&["run", key], with_unit(x, unit)),
            }
        }
    }
}

/// Adds the parameters and laws that the effects of the text need and that neither the text nor the model gives. They get values of usual
/// size.
fn complete(scene: &Scene, text: &mut Text) {
    let model = scene.model;
    // The parts of a train have their own tables, so that an effect needs no other keys.
    let names = text.names("effects");
    let Some(effects) = Effects::from_names(names.iter().map(String::as_str), model) else { return };
    if scene.train.is_some() {
        return;
    }
    let active = |with: Option<&str>| with.is_some_and(|effect| effects.has(effect, model));
    for parameter in model.parameters.iter().filter(|p| p.default.is_none() && active(p.with)) {
        if let Some(value) =
            text::value(&usual_value(parameter)).filter(|_| text.at(&["parameters", parameter.name]).is_none())
        {
            text.put(&["parameters", parameter.name], value);
        }
    }
    for law in model.laws.iter().filter(|law| active(law.with)) {
        if text.at(&["laws", law.name]).is_some() {
            continue;
        }
        // If the teeth of a mesh are given, its friction follows from the teeth.
        let teeth = model.laws.iter().find(|other| {
            other.role == Role::Stiffness
                && other.phase == law.phase
                && text.at(&["laws", other.name, "teeth"]).is_some()
        });
        let (key, value) = match teeth.filter(|_| law.role.is_friction()) {
            Some(stiffness) => ("teeth_of", Some(Value::from(stiffness.name))),
            None => ("steps", usual_levels(law, model).strip_prefix("steps = ").and_then(text::value)),
        };
        if let Some(value) = value {
            text.put(&["laws", law.name, key], value);
        }
    }
}

/// A number in the unit `unit`, converted to SI; unchanged if the unit is not known.
pub(super) fn si(number: f64, unit: &str) -> f64 {
    Quantity::parse(&format!("{number:e} {unit}")).map_or(number, |quantity| quantity.value)
}
