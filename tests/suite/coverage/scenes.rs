//! For each effect of each model a scene with it: a committed scene, the effect and those that it needs, without those that exclude it.

use std::path::Path;

use gearsim::model::Model;
use gearsim::{Scene, usual_levels, usual_value};

/// Models that differ from another one only in a number of parts.
const SAME: &[&str] = &[
    "planetary_4",
    "planetary_5",
    "planetary_6",
    "planetary_7",
    "planar_planetary_4",
    "planar_planetary_5",
    "chain_2",
    "chain_32",
];

/// Scenes that run longer than this [s] are cut.
const T_END: f64 = 5e-4;

/// Name and title of each model.
pub fn models() -> Vec<(String, &'static str)> {
    let all = gearsim::models().iter().map(|entry| entry.model).filter(|model| !SAME.contains(&model.name));
    all.map(|model| (model.name.to_string(), model.title)).collect()
}

/// Each effect of a model, beginning with none, and a scene with it; the error is why there is none.
pub fn of(model: &str) -> Vec<(&'static str, Result<Scene, String>)> {
    let base = base(model);
    let effects = base.model.effects.iter().filter(|effect| effect.of.is_none()).map(|effect| effect.name);
    let with = |effect| (effect, scene(&base, effect));
    effects.map(with).collect()
}

/// The first committed scene of a model.
fn base(model: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes");
    let mut files: Vec<_> = ["", "oh2005", "drives"]
        .iter()
        .flat_map(|sub| std::fs::read_dir(folder.join(sub)).unwrap())
        .map(|file| file.unwrap().path())
        .filter(|path| path.extension().is_some_and(|end| end == "toml"))
        .collect();
    files.sort();
    let scenes =
        files.iter().filter(|file| std::fs::read_to_string(file).unwrap().contains(&format!("model = \"{model}\"")));
    let scene = scenes.map(|file| Scene::load(file).unwrap_or_else(|e| panic!("{e}"))).next();
    let scene = scene.unwrap_or_else(|| panic!("no scene of {model}"));
    // What runs is chosen by the commands, and so are method and tolerance.
    let chosen = ["method =", "tolerance =", "step =", "rate ="];
    let own = |line: &&str| !chosen.iter().any(|key| line.trim_start().starts_with(key));
    let text: String = scene.text.lines().filter(own).map(|line| format!("{line}\n")).collect();
    let t_end = format!("run.t_end={} s", scene.t_end.min(T_END));
    Scene::from_toml_with(&scene.name, &text, &[t_end]).unwrap_or_else(|error| panic!("{error}"))
}

/// `base` with an effect, with what this needs, and with values for what it requires.
fn scene(base: &Scene, effect: &'static str) -> Result<Scene, String> {
    let model = base.model;
    let mut names = vec![effect];
    let mut i = 0;
    while i < names.len() {
        let needed = model.effects.iter().find(|e| e.name == names[i]).map_or(&[][..], |e| e.requires);
        names.extend(needed.iter().filter(|name| !names.contains(name)).copied().collect::<Vec<_>>());
        i += 1;
    }
    for name in base.effects.names(model) {
        let excludes = |a: &str, b: &str| model.effects.iter().any(|e| e.name == a && e.excludes.contains(&b));
        if !names.contains(&name) && !names.iter().any(|other| excludes(name, other) || excludes(other, name)) {
            names.push(name);
        }
    }
    let mut texts = base.overrides.clone();
    texts.push(format!("effects={names:?}"));
    texts.extend(missing(base, model, &names));
    Scene::from_toml_with(&base.name, &base.text, &texts).map_err(|error| error.to_string())
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
