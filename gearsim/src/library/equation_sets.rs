//! The sets of equations that `gearsim compare` runs a scene with: Oh, Grosh & Barber (2005), Eqs. (2)-(6).

use super::Error;
use crate::model::Switching;
use crate::scene::{Effects, Scene, list};

/// A set of equations: those of the scene, with at most one effect that drops terms.
pub(crate) struct EquationSet {
    /// Name in tables and legends.
    pub(crate) label: &'static str,
    /// Name with the word "equations", for sentences.
    pub(crate) equations: &'static str,
    /// Name in file names.
    pub(crate) suffix: &'static str,
    /// How laws switch with the effect that drops terms, and what this effect does; `None`: nothing is dropped.
    modifier: Option<(Switching, &'static str)>,
}

/// All sets of equations, the exact ones first.
pub(crate) const SETS: &[EquationSet] = &[
    EquationSet { label: "exact", equations: "exact equations", suffix: "exact", modifier: None },
    EquationSet {
        label: "rigid kinematic",
        equations: "rigid kinematic equations",
        suffix: "rigid_kinematic",
        modifier: Some((Switching::WithoutJump, "leaves out the impulses of steps")),
    },
    EquationSet {
        label: "classical",
        equations: "classical equations",
        suffix: "classical",
        modifier: Some((Switching::ByTime, "lets laws step at the times of a steady rotation")),
    },
];

/// `scene` with every set of equations. Errors: [`Error::Impossible`] if the model has no such effects, or if the sets are the same.
pub(crate) fn all(scene: &Scene) -> Result<Vec<(&'static EquationSet, Scene)>, Error> {
    SETS.iter().map(|set| Ok((set, under(scene, set)?))).collect()
}

fn under(scene: &Scene, set: &'static EquationSet) -> Result<Scene, Error> {
    let model = scene.model;
    let modifiers = SETS.iter().filter_map(|set| model.switching(set.modifier?.0)).map(|effect| effect.name);
    let modifiers: Vec<_> = modifiers.collect();
    let mut names = scene.effects.names(model);
    names.retain(|name| !modifiers.contains(name));
    if let Some((how, does)) = set.modifier {
        let effect = model.switching(how).ok_or_else(|| {
            let what =
                format!("model `{}` has no effect that {does}, so there are no {} equations", model.name, set.label);
            Error::impossible(what, "run the scene as it is")
        })?;
        let lacking: Vec<_> =
            effect.requires.iter().copied().filter(|other| !scene.effects.has(other, model)).collect();
        if !lacking.is_empty() {
            let what =
                format!("scene {} lacks the effect {}: all sets of equations are the same", scene.name, list(&lacking));
            return Err(Error::impossible(what, format!("add {} to its effects", list(&lacking))));
        }
        names.push(effect.name);
    }
    let mut scene = scene.clone();
    if let Some(effects) = Effects::from_names(names.iter().copied(), model) {
        // The text of the scene and its settings have the effects too.
        scene.overrides.push(format!("effects={names:?}"));
        scene.effects = effects;
    }
    Ok(scene)
}
