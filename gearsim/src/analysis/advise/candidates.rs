//! The effects and terms that could be left out of a scene. An effect of several parts is judged for all of them, and for each by itself.

use crate::model::{Model, Switching};
use crate::scene::{Effects, Scene};

/// The effects that remove terms, by the way in which laws then switch, each with the terms it removes. All other effects add terms.
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
    /// How its deviation is estimated.
    pub way: Way,
}

/// How a deviation is estimated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// From the settled motion without the impulses of the steps.
    WithoutJumps,
    /// From the mean alone: there is no vibration.
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
    for name in &present {
        // Effects that require this one are left out with it.
        let needs = |other: &&str| {
            model.effects.iter().any(|e| (e.name == *other || e.of == Some(*other)) && e.requires.contains(name))
        };
        let mut gone: Vec<&str> = vec![name];
        gone.extend(present.iter().copied().filter(|other| needs(other)));
        let names: Vec<_> = present.iter().copied().filter(|other| !gone.contains(other)).collect();
        let quoted: Vec<_> = gone.iter().map(|name| format!("`{name}`")).collect();
        let way = if switches(model, name, Switching::WithJump) { Way::WithoutSteps } else { Way::Run };
        let (without, how) = (gone.join(", "), format!("leave out {}", quoted.join(", ")));
        candidates.push(Candidate { without, how, scene: with(base, &names), way });
        candidates.extend(parts(base, &present, name));
    }
    // Effects that bend deflections need no further values in the scene, so the deviation that they would cause is estimated too.
    for name in Effects(u64::MAX).names(model).into_iter().filter(|name| !present.contains(name) && bends(base, name)) {
        let names: Vec<_> = present.iter().copied().chain([name]).collect();
        let scene = with(base, &names);
        if scene.effects.contradictions(model).is_empty() {
            let (without, how) = (format!("nothing, and with {name}"), format!("add `{name}`"));
            candidates.push(Candidate { without, how, scene, way: Way::Run });
        }
    }
    candidates
}

/// The scenes without the effect `name` at one part, one scene for each part; none if the effect does not belong to several parts.
fn parts(base: &Scene, present: &[&'static str], name: &str) -> Vec<Candidate> {
    let parts: Vec<_> = base.model.effects.iter().filter(|e| e.of == Some(name)).map(|e| e.name).collect();
    if parts.len() < 2 {
        return vec![];
    }
    let without = |part: &&'static str| {
        let others: Vec<_> = parts.iter().copied().filter(|other| other != part).collect();
        let quoted: Vec<_> = others.iter().map(|other| format!("`{other}`")).collect();
        let how = format!("name {} instead of `{name}`", quoted.join(", "));
        let names: Vec<_> = present.iter().copied().filter(|other| *other != name).chain(others).collect();
        Candidate { without: part.to_string(), how, scene: with(base, &names), way: Way::Run }
    };
    parts.iter().map(without).collect()
}

/// Whether laws switch in this way with an effect.
fn switches(model: &Model, name: &str, how: Switching) -> bool {
    model.switching(how).is_some_and(|effect| effect.name == name)
}

/// Whether an effect makes a deflection depend on the coordinates in another way than linearly.
fn bends(scene: &Scene, name: &str) -> bool {
    scene.model.effects.iter().any(|effect| effect.bends && (effect.name == name || effect.of == Some(name)))
}

fn with(scene: &Scene, names: &[&str]) -> Scene {
    let effects = Effects::from_names(names.iter().copied(), scene.model).unwrap_or(scene.effects);
    Scene { effects, ..scene.clone() }
}
