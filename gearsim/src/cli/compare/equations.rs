//! The sets of equations that a scene is compared under: Oh, Grosh & Barber (2005), Eqs. (2)-(6).

use crate::cli::failure::Failure;
use crate::scene::{Effects, Scene, list};

/// A set of equations: what the scene says, with at most one effect that drops terms.
pub(in crate::cli) struct Set {
    /// Name in tables and legends.
    pub(in crate::cli) label: &'static str,
    /// The same with "equations", for sentences.
    pub(in crate::cli) equations: &'static str,
    /// Name in file names.
    pub(in crate::cli) suffix: &'static str,
    /// The effect that drops terms; none drops nothing.
    modifier: Option<&'static str>,
}

/// All of them.
pub(in crate::cli) const SETS: &[Set] = &[
    Set { label: "exact", equations: "exact equations", suffix: "exact", modifier: None },
    Set {
        label: "rigid kinematic",
        equations: "rigid kinematic equations",
        suffix: "rigid_kinematic",
        modifier: Some("rigid_kinematics"),
    },
    Set { label: "classical", equations: "classical equations", suffix: "classical", modifier: Some("frozen_phase") },
];

/// `scene` under every set of equations.
pub(in crate::cli) fn all(scene: &Scene) -> Result<Vec<(&'static Set, Scene)>, Failure> {
    SETS.iter().map(|set| Ok((set, under(scene, set)?))).collect()
}

fn under(scene: &Scene, set: &'static Set) -> Result<Scene, Failure> {
    let model = scene.model;
    let modifies = |name: &str| SETS.iter().any(|set| set.modifier == Some(name));
    let mut names = scene.effects.names(model);
    names.retain(|name| !modifies(name));
    if let Some(modifier) = set.modifier {
        let effect =
            model.effects.iter().find(|effect| effect.name == modifier).ok_or_else(|| Failure::Impossible {
                what: format!(
                    "model `{}` has no effect `{modifier}`, so there are no {} equations",
                    model.name, set.label
                ),
                help: "`gearsim run` simulates the scene as it is".into(),
            })?;
        let lacking: Vec<_> = effect.requires.iter().copied().filter(|other| !names.contains(other)).collect();
        if !lacking.is_empty() {
            let what =
                format!("scene {} lacks the effect {}: all sets of equations are the same", scene.name, list(&lacking));
            return Err(Failure::Impossible { what, help: format!("add {} to its effects", list(&lacking)) });
        }
        names.push(modifier);
    }
    let effects = Effects::from_names(names, model).unwrap_or(scene.effects);
    Ok(Scene { effects, ..scene.clone() })
}
