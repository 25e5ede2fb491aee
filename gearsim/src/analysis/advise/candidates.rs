//! The effects and terms that could be left out of a scene. An effect with several parts is a candidate as a whole, and each of its parts
//! is a candidate too.

use crate::model::{Model, Switching};
use crate::scene::{Effects, Scene};

/// The effects that remove terms: the removed terms, and how laws switch with the effect. All other effects add terms.
const DROPPING: [(&str, Switching); 2] =
    [("jump terms", Switching::WithoutJump), ("jump terms, moving phase", Switching::ByTime)];

/// A scene without one of its effects, or without some terms.
#[derive(Debug, Clone)]
pub struct Candidate {
    /// The effects or terms left out.
    pub without: String,
    /// How to change the scene's list of effects.
    pub how: String,
    /// The scene without them.
    pub scene: Scene,
    /// How the deviation without them is estimated.
    pub way: Way,
}

/// How a deviation is estimated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// From the settled motion without the impulses of the steps.
    WithoutJumps,
    /// From the static deflection alone: without steps nothing vibrates.
    WithoutSteps,
    /// From a short run, because no settled motion can be computed without the effect.
    Run,
}

/// The scene without the effects that drop terms.
pub(crate) fn base(scene: &Scene) -> Scene {
    let mut names = scene.effects.names(scene.model);
    names.retain(|name| DROPPING.iter().all(|(_, how)| !switches(scene.model, name, *how)));
    let mut base = with(scene, &names);
    // Advice is about coordinates and energies: outputs would only cost time.
    base.output.record.clear();
    base
}

/// The candidates of `base`, a scene without effects that drop terms.
pub(crate) fn candidates(base: &Scene) -> Vec<Candidate> {
    let model = base.model;
    let present = base.effects.names(model);
    let mut candidates = vec![];
    for (without, how) in DROPPING {
        let Some(effect) = model.switching(how) else { continue };
        let name = effect.name;
        if effect.requires.iter().all(|needed| present.contains(needed)) {
            let names: Vec<_> = present.iter().copied().chain([name]).collect();
            let how = format!("add `{name}`");
            candidates.push(Candidate {
                without: without.into(),
                how,
                scene: with(base, &names),
                way: Way::WithoutJumps,
            });
        }
    }
    for &name in &present {
        let way = if switches(model, name, Switching::WithJump) { Way::WithoutSteps } else { Way::Run };
        let all = Effects::numbers(name, model);
        candidates.push(without(base, &all, way));
        let is_of_parts = all.len() > 1 && model.effects[all[0]].of == Some(name);
        candidates.extend(all.iter().filter(|_| is_of_parts).map(|&part| without(base, &[part], Way::Run)));
    }
    // Effects that make a deflection nonlinear need no further values in the scene, so that adding them is a candidate too.
    for name in Effects::all(model).names(model).into_iter().filter(|name| !present.contains(name) && bends(base, name))
    {
        let names: Vec<_> = present.iter().copied().chain([name]).collect();
        let scene = with(base, &names);
        if scene.effects.contradictions(model).is_empty() {
            let (without, how) = (format!("nothing, and with {name}"), format!("add `{name}`"));
            candidates.push(Candidate { without, how, scene, way: Way::Run });
        }
    }
    candidates
}

/// The scene without these effects, and without those that require one of them.
fn without(base: &Scene, effects: &[usize], way: Way) -> Candidate {
    let model = base.model;
    let mut left = effects.iter().fold(base.effects.clone(), |left, &i| left.without(i));
    let lacks = |left: &Effects, i: usize| {
        left.contains(i) && model.effects[i].requires.iter().any(|needed| !left.has(needed, model))
    };
    while let Some(i) = (0..model.effects.len()).find(|&i| lacks(&left, i)) {
        left = left.without(i);
    }
    let gone = (0..model.effects.len()).filter(|&i| base.effects.contains(i) && !left.contains(i));
    let gone = Effects::numbered(model, gone);
    let names = gone.names(model);
    Candidate {
        without: names.join(", "),
        how: how(base, &gone, &left),
        scene: Scene { effects: left, ..base.clone() },
        way,
    }
}

/// How to change the list of effects of a scene, in words: the effects `gone` are left out, the effects `left` stay.
fn how(base: &Scene, gone: &Effects, left: &Effects) -> String {
    let model = base.model;
    let (before, after) = (base.effects.names(model), left.names(model));
    let quoted = |names: Vec<&str>| names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    let leave_out: Vec<&str> = before.iter().copied().filter(|name| !after.contains(name)).collect();
    let name: Vec<&str> = after.into_iter().filter(|name| !before.contains(name)).collect();
    match name.is_empty() {
        true => format!("leave out {}", quoted(gone.names(model))),
        false => format!("name {} instead of {}", quoted(name), quoted(leave_out)),
    }
}

/// Whether laws switch in the way `how` because of the effect `name`.
fn switches(model: &Model, name: &str, how: Switching) -> bool {
    model.switching(how).is_some_and(|effect| effect.name == name)
}

/// Whether an effect, or one of its parts, makes a deflection nonlinear in the coordinates.
fn bends(scene: &Scene, name: &str) -> bool {
    scene.model.effects.iter().any(|effect| effect.bends && (effect.name == name || effect.of == Some(name)))
}

fn with(scene: &Scene, names: &[&str]) -> Scene {
    let effects = Effects::from_names(names.iter().copied(), scene.model).unwrap_or_else(|| scene.effects.clone());
    Scene { effects, ..scene.clone() }
}
