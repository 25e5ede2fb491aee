//! Scenes of a model with chosen effects: a committed scene with these effects, the effects that they need, and values of their required
//! parameters.

#![allow(dead_code)] // each test binary uses only some of these

use std::path::{Path, PathBuf};

use gearsim::__private::{usual_levels, usual_value};
use gearsim::Scene;
use gearsim::model::{Effect, Model};

/// Models that differ from another one only in a number of parts.
const SAME: &[&str] = &["planar_planetary_4", "planar_planetary_5", "chain_2", "chain_32"];

/// Models whose inertia changes over a turn of the driven gear. `floquet` follows this turn. With equal numbers of teeth the turn has a
/// quarter as many tooth meshes.
const EQUAL_GEARS: &[&str] = &["crank_drive", "cardan_drive"];

/// Longer scenes are cut to this length [s].
pub const T_END: f64 = 5e-4;

/// Number of samples of a run. With the default of 10,000, these tests would spend most of their time on recording.
const SAMPLES: f64 = 1e3;

/// Name and title of each model.
pub fn models() -> Vec<(String, &'static str)> {
    let all = gearsim::models().iter().map(|entry| entry.model).filter(|model| !SAME.contains(&model.name));
    all.map(|model| (model.name.to_string(), model.title)).collect()
}

/// Each effect of a model with a scene that has it, or the reason why there is no such scene. An effect of parts is listed for all parts.
/// If there are several parts, it is also listed for the first part alone.
pub fn of(model: &str) -> Vec<(&'static str, Result<Scene, String>)> {
    let base = base(model);
    let mut names: Vec<&'static str> = vec![];
    for effect in base.model.effects {
        let Some(of) = effect.of else {
            names.push(effect.name);
            continue;
        };
        if !names.contains(&of) {
            names.push(of);
            let several = base.model.effects.iter().filter(|other| other.of == Some(of)).count() > 1;
            names.extend(several.then_some(effect.name));
        }
    }
    names.into_iter().map(|effect| (effect, scene(&base, effect))).collect()
}

/// The first committed scene of a model that starts with a speed, or else the first one, cut to at most `T_END`. A speed is needed because
/// phases that do not move have no Floquet multipliers. Scenes in which a varying parameter makes the cells nonlinear are left out, because
/// that nonlinearity does not come from an effect.
fn base(model: &str) -> Scene {
    let mut scenes = committed(model, T_END);
    scenes.retain(|scene| scene.time_histories.iter().all(|(p, _)| !scene.model.parameters[*p].varies.by_steps()));
    let turns = |scene: &Scene| scene.start.motions.iter().any(|speed| *speed != 0.0);
    let base = scenes.swap_remove(scenes.iter().position(turns).unwrap_or(0));
    if !EQUAL_GEARS.contains(&model) {
        return base;
    }
    let overrides: Vec<String> = base.overrides.iter().cloned().chain(["parameters.N2=24".into()]).collect();
    Scene::from_toml_with(&base.name, &base.text, &overrides).unwrap_or_else(|error| panic!("{error}"))
}

/// The committed scenes of a model, cut to at most `t_end` [s], without their choice of methods.
pub fn committed(model: &str, t_end: f64) -> Vec<Scene> {
    // The fuzz targets, in a folder below, include this file too.
    let above = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors();
    let folder = above.map(|folder| folder.join("models/scenes")).find(|folder| folder.is_dir()).unwrap();
    let mut files: Vec<_> = ["", "oh2005", "drives"]
        .iter()
        .flat_map(|sub| std::fs::read_dir(folder.join(sub)).unwrap())
        .map(|file| file.unwrap().path())
        .filter(|path| path.extension().is_some_and(|end| end == "toml"))
        .collect();
    files.sort();
    let scenes =
        files.iter().filter(|file| std::fs::read_to_string(file).unwrap().contains(&format!("model = \"{model}\"")));
    let cut = |file: &PathBuf| {
        let scene = Scene::load(file).unwrap_or_else(|e| panic!("{e}"));
        // The commands choose method, step, tolerance and rate.
        let chosen = ["method =", "tolerance =", "step =", "rate ="];
        let own = |line: &&str| !chosen.iter().any(|key| line.trim_start().starts_with(key));
        let text: String = scene.text.lines().filter(own).map(|line| format!("{line}\n")).collect();
        let t_end = scene.t_end.min(t_end);
        let sets = [format!("run.t_end={t_end} s"), format!("output.rate={} Hz", SAMPLES / t_end)];
        Scene::from_toml_with(&scene.name, &text, &sets).unwrap_or_else(|error| panic!("{error}"))
    };
    let scenes: Vec<Scene> = scenes.map(cut).collect();
    assert!(!scenes.is_empty(), "no scene of {model}");
    scenes
}

/// `base` with an effect, the effects that it needs, and values of its required parameters.
fn scene(base: &Scene, effect: &'static str) -> Result<Scene, String> {
    let model = base.model;
    let mut names = needed(model, effect);
    // The effect of one part replaces the effect of all parts, which the scene may have.
    let all = model.effects.iter().find(|e| e.name == effect).and_then(|e| e.of);
    for name in base.effects.names(model).into_iter().filter(|name| Some(*name) != all) {
        if !names.contains(&name) && !names.iter().any(|other| exclude(model, name, other)) {
            names.push(name);
        }
    }
    Scene::from_toml_with(&base.name, &base.text, &overrides(base, &names)).map_err(|error| error.to_string())
}

/// An effect and all that it requires, at each of its parts.
pub fn needed(model: &Model, effect: &'static str) -> Vec<&'static str> {
    let (mut names, mut i) = (vec![effect], 0);
    while i < names.len() {
        let name = names[i];
        for needed in model.effects.iter().filter(|e| is(e, name)).flat_map(|e| e.requires) {
            if !names.contains(needed) {
                names.push(needed);
            }
        }
        i += 1;
    }
    names
}

/// Whether one of two effects excludes the other.
pub fn exclude(model: &Model, a: &str, b: &str) -> bool {
    let of = |name: &str| model.effects.iter().find(|e| e.name == name).and_then(|e| e.of);
    let names = |e: &Effect, b: &str| {
        e.excludes.iter().any(|other| *other == b || of(b) == Some(*other) || of(other) == Some(b))
    };
    let excludes = |a: &str, b: &str| model.effects.iter().any(|e| is(e, a) && names(e, b));
    excludes(a, b) || excludes(b, a)
}

/// Whether an effect has the name `name`, or is the effect of this name at one part.
fn is(effect: &Effect, name: &str) -> bool {
    effect.name == name || effect.of == Some(name)
}

/// The overrides of a scene that give it the effects `names`.
pub fn overrides(base: &Scene, names: &[&'static str]) -> Vec<String> {
    let mut texts = base.overrides.clone();
    texts.push(format!("effects={names:?}"));
    texts.extend(missing(base, base.model, names));
    texts
}

/// Values for the parameters and laws that the effects require and the scene does not give.
fn missing(base: &Scene, model: &Model, names: &[&str]) -> Vec<String> {
    let has = |with: Option<&str>| {
        let part = |effect: &str| model.effects.iter().find(|e| e.name == effect).and_then(|e| e.of);
        with.is_some_and(|effect| names.contains(&effect) || part(effect).is_some_and(|of| names.contains(&of)))
    };
    let had = |with: Option<&str>| with.is_none_or(|effect| base.effects.has(effect, model));
    let stated =
        |key: &str| base.text.contains(&format!("[{key}]")) || base.overrides.iter().any(|o| o.starts_with(key));
    let parameters = model.parameters.iter().filter(|p| p.default.is_none() && has(p.with) && !had(p.with));
    let parameters =
        parameters.filter(|p| !base.text.lines().any(|line| line.trim_start().starts_with(&format!("{} =", p.name))));
    let parameters = parameters.map(|p| format!("parameters.{}={}", p.name, usual_value(p)));
    let laws = model.laws.iter().filter(|law| has(law.with) && !stated(&format!("laws.{}", law.name)));
    parameters.chain(laws.map(|law| format!("laws.{}.{}", law.name, usual_levels(law, model)))).collect()
}
