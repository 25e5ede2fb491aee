//! The effects and terms that could be left out of a scene. An effect with several parts is a candidate as a whole, and each of its parts
//! is a candidate too.

use indexmap::IndexMap;

use crate::analysis::orders::force;
use crate::analysis::pulling::Pulling;
use crate::model::{Model, Parameter, Switching};
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

/// The play that is assumed where a scene states none [deflections of the mesh under its load]: that of common gears, so that the teeth part
/// before their other flanks meet.
const PLAY: f64 = 10.0;

/// The scene without the effects that drop terms.
pub(crate) fn base(scene: &Scene) -> Scene {
    let mut names = scene.effects.names(scene.model);
    names.retain(|name| DROPPING.iter().all(|(_, how)| !switches(scene.model, name, *how)));
    let mut base = with(scene, &names);
    // Advice is about coordinates and energies, and about teeth that pull: other outputs would only cost time.
    let model = base.model;
    let forces: Vec<_> = model.laws.iter().filter_map(|law| force(model, law.name)).map(|output| output.name).collect();
    base.output.record.retain(|&i| forces.contains(&model.outputs[i].name));
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
    // Adding effects is a candidate too. Those that make a deflection nonlinear need no further values in the scene.
    let mut left_out: IndexMap<&str, Vec<usize>> = IndexMap::new();
    for (i, effect) in model.effects.iter().enumerate().filter(|(i, _)| !base.effects.contains(*i)) {
        if effect.bends || is_stated(base, effect.name) {
            left_out.entry(effect.of.unwrap_or(effect.name)).or_default().push(i);
        }
    }
    candidates.extend(left_out.into_values().filter_map(|effects| and_with(base.clone(), &effects, "")));
    candidates
}

/// The scene with play in the meshes that pull in its run, where it does not state their play: [`PLAY`] is assumed. `None` if there is no
/// such mesh.
pub(crate) fn with_play(base: &Scene, pulling: &[Pulling]) -> Option<Candidate> {
    let model = base.model;
    let (mut scene, mut effects, mut assumed) = (base.clone(), vec![], vec![]);
    for mesh in pulling.iter().filter(|mesh| mesh.share > 0.0) {
        let lacks = |p: &Parameter| p.with.is_some() && p.with == mesh.without && p.default.is_none();
        let Some(play) = model.parameters.iter().position(lacks) else { continue };
        let Some((_, stiffness)) = scene.present().find(|(law, _)| law.name == mesh.law.name) else { continue };
        if scene.parameters[play].is_nan() {
            let parameter = &model.parameters[play];
            scene.parameters[play] = PLAY * mesh.mean.abs().max(mesh.largest) / stiffness.mean();
            assumed.push(format!("{} = {:.1e} {}", parameter.name, scene.parameters[play], parameter.unit));
            effects.extend(model.effects.iter().position(|effect| mesh.without == Some(effect.name)));
        }
    }
    let values = format!(", with an assumed play of {}", assumed.join(", "));
    (!effects.is_empty()).then(|| and_with(scene, &effects, &values)).flatten()
}

/// The scene with further effects; `values` says in words which values it does not state. `None` if they contradict its effects.
fn and_with(base: Scene, effects: &[usize], values: &str) -> Option<Candidate> {
    let model = base.model;
    let names = Effects::numbered(model, effects.iter().copied()).names(model);
    let effects = effects.iter().fold(base.effects.clone(), |all, &i| all.with(i));
    let quoted: Vec<_> = names.iter().map(|name| format!("`{name}`")).collect();
    effects.contradictions(model).is_empty().then(|| Candidate {
        without: format!("nothing, and with {}", names.join(", ")),
        how: format!("add {}{values}", quoted.join(", ")),
        scene: Scene { effects, ..base },
        way: Way::Run,
    })
}

/// Whether a scene states all values that an effect needs, and there are such values.
fn is_stated(scene: &Scene, effect: &str) -> bool {
    let model = scene.model;
    let needed = model.parameters.iter().zip(&scene.parameters);
    let needed = needed.filter(|(p, _)| p.with == Some(effect) && p.default.is_none());
    let laws = model.laws.iter().zip(&scene.laws).filter(|(law, _)| law.with == Some(effect));
    let laws = laws.map(|(_, law)| law.extremes() != (0.0, 0.0));
    let mut all = needed.map(|(_, value)| value.is_finite() && *value != 0.0).chain(laws).peekable();
    all.peek().is_some() && all.all(|stated| stated)
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

fn with(scene: &Scene, names: &[&str]) -> Scene {
    let effects = Effects::from_names(names.iter().copied(), scene.model).unwrap_or_else(|| scene.effects.clone());
    Scene { effects, ..scene.clone() }
}
