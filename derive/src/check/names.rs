//! Checks that every name is unique and usable in the generated code.

use std::collections::BTreeMap;

use crate::expr::{
    Kind, MOVING, acceleration_name, is_word, partial_name, power_name, reaction_name, speed_name, symbols,
};
use crate::model::{JUMP_TERMS, MOVING_PHASE, Model, mid_name};
use crate::slip::Slip;

/// Words that cannot be names in the generated code: keywords of Rust, and names that this code uses itself.
const RUST: &str = "\
    Self abstract as async await become box break coefficients const continue crate do dyn else enum extern false final fn \
    for gen if impl in let loop macro match mids mod move mut override parameters priv pub ref return self \
    static struct super trait true try type typeof unsafe unsized use virtual where while yield";

/// What a symbol of a kind is, in words for messages.
pub(super) fn what_it_is(kind: Kind) -> &'static str {
    match kind {
        Kind::Coordinate => "a coordinate",
        Kind::Speed => "a speed",
        Kind::Deflection => "a deflection",
        Kind::Acceleration => "an acceleration",
        Kind::Rate => "the rate of a deflection",
        Kind::Parameter => "a parameter",
        Kind::Constant => "a constant",
        Kind::Law => "a law",
        Kind::Error => "a transmission error",
        Kind::Friction => "a friction law",
        Kind::Force => "a force",
        Kind::Partial => "a partial derivative of a force",
        Kind::Mid => "the mid value of a law",
        Kind::Slope => "the slope of a law",
        Kind::Curvature => "the curvature of a law",
        Kind::Function => "a function of a position",
        Kind::Switched => "a factor of a switch",
        Kind::Edge => "an offset of a switch",
        Kind::Reaction => "the reaction of a hold",
        Kind::Output => "an output",
        Kind::Known => "a reaction or a power, for outputs",
        Kind::Spring => "the force of springs",
        Kind::Damper => "the force of dampers",
        Kind::Marker | Kind::Mobility | Kind::Free => "not declared",
    }
}

/// All declared names, each with its kind in words for messages.
pub(super) fn declared(model: &Model) -> Result<BTreeMap<String, &'static str>, Slip> {
    let mut all = BTreeMap::new();
    let mut declare = |name: &str, what: &'static str, derived: bool| -> Result<(), Slip> {
        let allowed = is_word(name)
            && !RUST.split(' ').any(|word| word == name)
            && (derived || !(name.ends_with("_dot") || name.ends_with("_mid")));
        if !allowed {
            return Err(Slip::Name { model: model.name.clone(), name: name.into() });
        }
        match all.insert(name.to_string(), what) {
            None => Ok(()),
            Some(first) => Err(Slip::Twice { model: model.name.clone(), name: name.into(), first, second: what }),
        }
    };
    use Kind::*;
    let known = what_it_is;
    declare(&model.name, "the model", false)?;
    model.coordinates.iter().try_for_each(|c| declare(&c.name, known(Coordinate), false))?;
    model.speeds().iter().try_for_each(|s| declare(s, known(Speed), true))?;
    if model.inertia_moves() {
        model.coordinates.iter().try_for_each(|c| declare(&acceleration_name(&c.name), known(Acceleration), true))?;
    }
    model.parameters.iter().try_for_each(|p| declare(&p.name, known(Parameter), false))?;
    model.constants.iter().try_for_each(|(name, _)| declare(name, known(Constant), false))?;
    for d in &model.deflections {
        declare(&d.name, known(Deflection), false)?;
        declare(&speed_name(&d.name), known(Rate), true)?;
    }
    for function in &model.functions {
        declare(&function.name, known(Function), false)?;
        function.derivatives().iter().skip(1).try_for_each(|d| declare(&d.name, known(Function), true))?;
    }
    for switch in &model.switches {
        switch.symbols.iter().try_for_each(|s| declare(&s.name, known(s.kind), false))?;
        if switch.modes.iter().any(|mode| mode.held) {
            declare(&reaction_name(&switch.over), known(Known), true)?;
        }
    }
    for law in &model.laws {
        declare(&law.name, known(law.kind()), false)?;
        if law.with.is_none() {
            declare(&mid_name(&law.name), known(Mid), true)?;
        }
        declare(&format!("d{}", law.name), known(Slope), true)?;
        declare(&format!("dd{}", law.name), known(Curvature), true)?;
    }
    for force in &model.forces {
        declare(&force.name, known(Force), false)?;
        for by in symbols(&force.value.atom()).into_iter().filter(|(kind, _)| MOVING.contains(kind)) {
            declare(&partial_name(&force.name, &by.1), known(Partial), true)?;
        }
    }
    model.motions.iter().try_for_each(|m| declare(&m.name, "a motion", false))?;
    model.effects.iter().try_for_each(|e| declare(&e.name, "an effect", false))?;
    [JUMP_TERMS, MOVING_PHASE].into_iter().try_for_each(|name| declare(name, "a condition", true))?;
    for (i, torque) in model.torques.iter().enumerate() {
        // One torque may have the name of its effect: only its power is a symbol.
        let is_first = model.torques[..i].iter().all(|before| before.name != torque.name);
        if !is_first || model.effects.iter().all(|e| e.name != torque.name) {
            declare(&torque.name, "a torque", false)?;
        }
        declare(&power_name(&torque.name), known(Known), true)?;
    }
    model.outputs.iter().try_for_each(|o| declare(&o.name, known(Output), false))?;
    Ok(all)
}
