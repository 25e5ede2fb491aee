//! Checks that the parameters of an effect are used only with it: a scene without the effect does not state them.

use std::collections::BTreeSet;

use symbolica::atom::Atom;

use crate::expr::{Expr, Kind, number, set, symbol, symbols};
use crate::model::{Effect, Model, Parameter};
use crate::slip::Slip;

/// A part of the model in which a parameter may be: where it is, its value, and the names of the symbols in this value. Without the effect
/// `with` the part is not used.
struct Use<'a> {
    place: String,
    value: Atom,
    names: BTreeSet<String>,
    with: Option<&'a str>,
}

/// A parameter that is declared in the closure of an effect may be used only in terms that are absent without the effect.
pub(super) fn parameters(model: &Model) -> Result<(), Slip> {
    let uses = uses(model);
    let constants: Vec<_> = model.constants.iter().map(|(name, value)| (name, named(&value.atom()))).collect();
    for parameter in &model.parameters {
        let Some(effect) = &parameter.with else { continue };
        let (names, effects) = (names(model, &constants, parameter), needing(model, effect));
        let outside = |part: &&Use| {
            let gated = part.with.is_some_and(|with| effects.iter().any(|effect| effect == with));
            !gated && !part.names.is_disjoint(&names) && contains(&without(&part.value, &effects), &names)
        };
        if let Some(part) = uses.iter().find(outside) {
            let (model, parameter) = (model.name.clone(), parameter.name.clone());
            return Err(Slip::OfAnEffect { model, parameter, effect: effect.clone(), place: part.place.clone() });
        }
    }
    Ok(())
}

/// The terms that are left if all of `effects` are absent.
fn without(value: &Atom, effects: &[String]) -> Atom {
    effects.iter().fold(value.clone(), |e, effect| set(&e, symbol(Kind::Marker, effect), &number(0)))
}

/// The effect and all effects that require it, directly or through others. A scene with any of them has the effect.
fn needing(model: &Model, effect: &str) -> Vec<String> {
    let mut all = vec![effect.to_string()];
    let mut known = 0;
    while known < all.len() {
        let needs = |e: &&Effect| e.requires.contains(&all[known]) && !all.contains(&e.name);
        let more: Vec<_> = model.effects.iter().filter(needs).map(|e| e.name.clone()).collect();
        all.extend(more);
        known += 1;
    }
    all
}

/// The names of the parameter, and of the constants and functions that depend on it.
fn names(model: &Model, constants: &[(&String, BTreeSet<String>)], parameter: &Parameter) -> BTreeSet<String> {
    let mut names = BTreeSet::from([parameter.name.clone()]);
    for (name, within) in constants {
        if !within.is_disjoint(&names) {
            names.insert((*name).clone());
        }
    }
    for function in model.functions.iter().filter(|f| f.with.is_none()) {
        if contains(&function.value.atom(), &names) {
            names.extend(function.derivatives().into_iter().map(|d| d.name));
        }
    }
    names
}

fn contains(value: &Atom, names: &BTreeSet<String>) -> bool {
    !named(value).is_disjoint(names)
}

/// The names of all symbols in an expression.
fn named(value: &Atom) -> BTreeSet<String> {
    symbols(value).into_iter().map(|(_, name)| name).collect()
}

/// All parts of the model except its constants, and except the functions that belong to no effect.
fn uses(model: &Model) -> Vec<Use<'_>> {
    let of = |place: &str, value: &Expr, with| {
        let value = value.atom();
        Use { place: place.to_string(), names: named(&value), value, with }
    };
    let energies = [
        ("the kinetic energy", &model.kinetic),
        ("the potential energy", &model.potential),
        ("the dissipation function", &model.dissipation),
    ];
    let mut uses: Vec<_> =
        energies.iter().flat_map(|(place, terms)| terms.iter().map(|term| of(place, term, None))).collect();
    uses.extend(model.deflections.iter().map(|d| of(&format!("the deflection `{}`", d.name), &d.value, None)));
    uses.extend(model.motions.iter().flat_map(|m| m.speeds.iter().map(|(_, speed)| of("a motion", speed, None))));
    for function in model.functions.iter().filter(|f| f.with.is_some()) {
        let (place, with) = (format!("the function `{}`", function.name), function.with.as_deref());
        uses.extend([&function.value].into_iter().chain(&function.gradient).map(|value| of(&place, value, with)));
    }
    for switch in &model.switches {
        let (place, with) = (format!("the switch of `{}`", switch.over), Some(switch.effect.as_str()));
        let values =
            switch.modes.iter().flat_map(|mode| mode.values.iter().chain(mode.exits.iter().map(|exit| &exit.guard)));
        uses.extend(values.chain([&switch.loss]).map(|value| of(&place, value, with)));
    }
    uses.extend(model.forces.iter().map(|f| of(&format!("the force `{}`", f.name), &f.value, f.with.as_deref())));
    for torque in &model.torques {
        let place = format!("the torque `{}`", torque.name);
        let displacement = torque.along.unwrap_or(torque.through);
        uses.push(of(&place, &(torque.value * displacement), None));
    }
    uses.extend(model.outputs.iter().map(|o| of(&format!("the output `{}`", o.name), &o.value, o.with.as_deref())));
    uses
}
