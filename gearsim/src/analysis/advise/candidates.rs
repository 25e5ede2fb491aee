//! What could be left out of a scene.

use crate::scene::{Effects, Scene};

/// Effects that drop terms rather than add them.
const DROPPING: [&str; 2] = ["rigid_kinematics", "frozen_phase"];

/// A scene without something.
#[derive(Debug, Clone)]
pub struct Candidate {
    /// What is left out.
    pub without: String,
    /// What to write into the scene's effects.
    pub how: String,
    /// The scene without it.
    pub scene: Scene,
    /// How its deviation can be told from numbers.
    pub way: Way,
}

/// From what a deviation is estimated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// The settled motion without the impulses of the steps.
    WithoutJumps,
    /// No motion but the mean.
    WithoutSteps,
    /// A short run: the numbers alone do not tell.
    Run,
}

/// The scene with nothing dropped: without the effects that drop terms.
pub fn base(scene: &Scene) -> Scene {
    let mut names = scene.effects.names(scene.model);
    names.retain(|name| !DROPPING.contains(name));
    with(scene, &names)
}

/// What can be left out of `base`, which has nothing dropped.
pub fn candidates(base: &Scene) -> Vec<Candidate> {
    let model = base.model;
    let present = base.effects.names(model);
    let mut candidates = vec![];
    let what = [("jump terms", DROPPING[0]), ("jump terms, moving phase", DROPPING[1])];
    for (without, name) in what {
        let Some(effect) = model.effects.iter().find(|effect| effect.name == name) else { continue };
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
        // What needs it goes with it.
        let needs = |other: &&str| model.effects.iter().any(|e| e.name == *other && e.requires.contains(name));
        let mut gone: Vec<&str> = vec![name];
        gone.extend(present.iter().copied().filter(|other| needs(other)));
        let names: Vec<_> = present.iter().copied().filter(|other| !gone.contains(other)).collect();
        let quoted: Vec<_> = gone.iter().map(|name| format!("`{name}`")).collect();
        let way = if *name == "stiffness_step" { Way::WithoutSteps } else { Way::Run };
        let (without, how) = (gone.join(", "), format!("leave out {}", quoted.join(", ")));
        candidates.push(Candidate { without, how, scene: with(base, &names), way });
    }
    candidates
}

fn with(scene: &Scene, names: &[&str]) -> Scene {
    let effects = Effects::from_names(names.iter().copied(), scene.model).unwrap_or(scene.effects);
    Scene { effects, ..scene.clone() }
}
