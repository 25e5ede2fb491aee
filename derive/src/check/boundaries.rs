//! Checks that laws belong to effects where they must, and that the effects which decide how laws switch fit together.

use crate::model::{Boundary, Effect, Model, Role};
use crate::slip::Slip;

/// A law that is not always present belongs to an effect. If there are laws, an effect makes them switch.
pub(super) fn boundaries(model: &Model) -> Result<(), Slip> {
    if let Some(law) = model.laws.iter().find(|law| law.role != Role::Stiffness && law.with.is_none()) {
        return Err(Slip::WithoutEffect { model: model.name.clone(), law: law.name.clone() });
    }
    if let (Some(law), None) = (model.laws.first(), model.switching(Boundary::WithJump)) {
        return Err(Slip::NeverSwitches { model: model.name.clone(), law: law.name.clone() });
    }
    for (i, (how, effect)) in model.switching.iter().enumerate() {
        if let Some(why) = why(model, i, *how, effect) {
            return Err(Slip::Boundary { model: model.name.clone(), effect: effect.clone(), why });
        }
    }
    Ok(())
}

/// The mistake in statement `i` of [`Model::boundaries`], which declares that `effect` makes laws switch in the way `how`. `None` if there
/// is no mistake.
fn why(model: &Model, i: usize, how: Boundary, effect: &str) -> Option<String> {
    let declared = |name: &str| model.effects.iter().find(|e| e.name == name);
    let Some(own) = declared(effect) else {
        return Some("there is no such effect: declare it with m.effect(...)".into());
    };
    let excludes = |a: &Effect, b: &str| a.excludes.iter().any(|name| name == b);
    for (other, first) in &model.switching[..i] {
        if first == effect {
            return Some("it can do so in one way only".into());
        }
        if *other == how {
            return Some(format!("so does `{first}`, in the same way: one effect can"));
        }
        let steps = [how, *other].contains(&Boundary::WithJump);
        if !steps && !excludes(own, first) && !declared(first).is_some_and(|first| excludes(first, effect)) {
            return Some(format!("so does `{first}`, in another way: add m.exclude(\"{effect}\", &[\"{first}\"])"));
        }
    }
    let steps = model.switching(Boundary::WithJump).filter(|steps| *steps != effect)?;
    let needed = how != Boundary::WithJump && !own.requires.iter().any(|name| name == steps);
    needed.then(|| format!("laws do not switch without `{steps}`: add m.require(\"{effect}\", &[\"{steps}\"])"))
}
