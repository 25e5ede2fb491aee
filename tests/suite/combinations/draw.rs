//! Random scenes: a committed scene of a model with other effects, numbers, start, method and precision.

use std::cell::OnceCell;

use gearsim::model::Model;
use gearsim::{Results, Scene};

use crate::checks::Checked;
use crate::effects;
use crate::random::Random;

/// Longest run \[s\].
const T_END: f64 = 5e-4;
/// Largest factor by which a parameter is changed, and its reciprocal.
const FACTOR: f64 = 2.0;

/// A random scene.
pub struct Case {
    /// The committed scene that it is made of.
    pub base: Scene,
    /// The overrides of the scene.
    pub sets: Vec<String>,
    /// The scene, or its mistakes.
    pub scene: Result<Scene, String>,
    /// Its run, once a check has asked for it.
    pub run: OnceCell<Result<Results, Checked>>,
    /// A random number for the checks.
    pub choice: u64,
}

impl Case {
    /// The command that runs the scene.
    pub fn command(&self) -> String {
        let sets: Vec<String> = self.sets.iter().map(|set| format!("--set '{set}'")).collect();
        format!("gearsim run {}.toml {}", self.base.name, sets.join(" "))
    }
}

/// The committed scenes of all models.
pub fn bases() -> Vec<Scene> {
    effects::models().iter().flat_map(|(model, _)| effects::committed(model, T_END)).collect()
}

/// Random scene `number`. Its base is the committed scene with the highest rank for this number. So a committed scene that is added later
/// becomes the base of some numbers, and all other numbers keep their base.
#[allow(dead_code)] // the fuzz target does not use it: it draws a scene from bytes
pub fn case(bases: &[Scene], number: u64) -> Case {
    let seed = number.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let mixed = |x: u64| Random::new(x).next();
    let rank = |base: &&Scene| mixed(base.name.bytes().fold(seed, |rank, byte| mixed(rank ^ u64::from(byte))));
    let base = bases.iter().max_by_key(rank).expect("there are scenes");
    drawn(base, Random::new(seed))
}

/// A base that the first random number chooses.
#[allow(dead_code)] // only the fuzz target uses it
pub fn base<'a>(bases: &'a [Scene], draw: &mut Random) -> &'a Scene {
    &bases[draw.below(bases.len())]
}

/// The scene that these random numbers make of a base.
pub fn drawn(base: &Scene, mut draw: Random) -> Case {
    let base = base.clone();
    let names = set(base.model, &mut draw);
    let mut sets = effects::overrides(&base, &names);
    sets.extend(method(&mut draw));
    // First with its own numbers: a scene that is refused with these would be refused with other numbers too.
    let read = |sets: &[String]| Scene::from_toml_with(&base.name, &base.text, sets).map_err(|error| error.to_string());
    let mut scene = read(&sets);
    if let Ok(plain) = &scene {
        // Numbers that do not fit one another, such as radii and teeth, stay as they are.
        for change in numbers(plain, &mut draw) {
            sets.push(change);
            match read(&sets) {
                Ok(changed) => scene = Ok(changed),
                Err(_) => drop(sets.pop()),
            }
        }
    }
    Case { base, sets, scene, run: OnceCell::new(), choice: draw.next() }
}

/// A set of effects without contradictions. The effect of one part is drawn only if the effect of all parts is not.
fn set(model: &'static Model, draw: &mut Random) -> Vec<&'static str> {
    let share = [0.2, 0.5, 0.9][draw.below(3)];
    let mut all: Vec<_> = model.effects.iter().collect();
    for i in (1..all.len()).rev() {
        all.swap(i, draw.below(i + 1));
    }
    let mut names: Vec<&'static str> = vec![];
    for effect in all {
        let related = |name: &&str| {
            effect.of == Some(*name) || model.effects.iter().any(|e| e.name == *name && e.of == Some(effect.name))
        };
        if draw.unit() > share || names.iter().any(related) {
            continue;
        }
        let more = effects::needed(model, effect.name);
        let fits = |name: &&str| names.iter().chain(&more).all(|other| !effects::exclude(model, name, other));
        if more.iter().all(fits) {
            let new: Vec<_> = more.into_iter().filter(|name| !names.contains(name)).collect();
            names.extend(new);
        }
    }
    names
}

/// A method and a precision: half the time those that gearsim chooses.
fn method(draw: &mut Random) -> Vec<String> {
    let choices: [&[&str]; 12] = [
        &[],
        &[],
        &[],
        &[],
        &[],
        &[],
        &["run.precision=compensated"],
        &["run.method=dopri5", "run.tolerance=1e-9"],
        &["run.method=dop853", "run.tolerance=1e-11"],
        &["run.method=dop853", "run.tolerance=1e-8"],
        &["run.method=radau", "run.tolerance=1e-9"],
        &["run.method=rk4", "run.step=0.5 us"],
    ];
    choices[draw.below(choices.len())].iter().map(|text| (*text).to_owned()).collect()
}

/// Other values for some parameters, for the speeds and for the phases.
fn numbers(scene: &Scene, draw: &mut Random) -> Vec<String> {
    let mut changes = vec![];
    for (i, parameter) in scene.model.parameters.iter().enumerate() {
        let fixed = scene.time_histories.iter().all(|(which, _)| *which != i);
        let factor = FACTOR.powf(2.0 * draw.unit() - 1.0);
        // Pure numbers are counts of teeth, ratios and angles, which other numbers have to fit.
        if fixed && parameter.unit != "1" && scene.parameters[i] != 0.0 && draw.unit() < 0.3 {
            changes.push(format!(
                "parameters.{}={:?} {}",
                parameter.name,
                factor * scene.parameters[i],
                parameter.unit
            ));
        }
    }
    for (motion, speed) in scene.model.motions.iter().zip(&scene.start.motions) {
        let factor = [1.0, 0.3, -1.0, 2.0][draw.below(4)];
        if *speed != 0.0 {
            changes.push(format!("start.{}={:?} {}", motion.name, factor * speed, motion.unit));
        }
    }
    for (i, coordinate) in scene.model.coordinates.iter().enumerate() {
        let Some(law) = scene.model.laws.iter().find(|law| law.phase == coordinate.name) else { continue };
        if !scene.start.q[i].is_static() && draw.unit() < 0.5 {
            let at = law.period * (4.0 * draw.unit() - 2.0);
            changes.push(format!("start.{}={at:?} {}", law.phase, coordinate.unit));
        }
    }
    changes
}
