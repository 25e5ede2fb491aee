//! Random variants of the scenes, with other effects, starts, speeds and torques, each by two methods. In half of them the torques vary in
//! time: tables of ramps and jumps with harmonics, slow and fast.

use std::collections::hash_map::DefaultHasher;
use std::hash::{Hash, Hasher};

use gearsim::model::Varies;
use gearsim::scene::time_history::Harmonic;
use gearsim::scene::{Scene, TimeHistory};

use crate::common;
use crate::compare;

/// Number of variants of each scene.
const VARIANTS: u64 = 6;

/// Compares the variants of a scene.
///
/// # Errors
/// A text that says on which variant the methods disagree, and how.
pub fn agree(name: &str) -> Result<String, String> {
    let mut text = String::new();
    for variant in 0..VARIANTS {
        let mut scene = common::scene(name, &[]);
        let mut draw = Draw::new(name, variant);
        vary(&mut scene, &mut draw);
        if variant % 2 == 1 {
            drive(&mut scene, &mut draw);
        }
        let effects = scene.effects.names(scene.model).join(", ");
        let agreed = compare::agree(&scene)
            .map_err(|wrong| format!("variant {variant} with {effects}, {:?}: {wrong}", scene.start))?;
        text += &format!("variant {variant} with {effects}: {agreed}\n");
    }
    Ok(text)
}

/// Removes some effects and changes the start and the torques.
fn vary(scene: &mut Scene, draw: &mut Draw) {
    scene.t_end *= 0.3 + 0.2 * draw.unit();
    for bit in 0..scene.model.effects.len() {
        let without = scene.effects.clone().without(bit);
        // Effects are only removed, never added: without jump terms the account does not close, and a frozen phase is another
        // system. `stiffness_step` stays.
        if draw.unit() < 0.25
            && scene.model.effects[bit].name != "stiffness_step"
            && without.contradictions(scene.model).is_empty()
        {
            scene.effects = without;
        }
    }
    for motion in &mut scene.start.motions {
        *motion *= 0.5 + draw.unit();
    }
    let phases: Vec<&str> = scene.model.laws.iter().map(|law| law.phase).collect();
    for (i, coordinate) in scene.model.coordinates.iter().enumerate() {
        if phases.contains(&coordinate.name) && !scene.start.q[i].is_static() {
            scene.start.q[i] = gearsim::model::Start::At(6.0 * draw.unit() - 3.0);
        }
    }
    for torque in 0..scene.parameters.len() {
        let fixed = scene.time_histories.iter().all(|(which, _)| *which != torque);
        if fixed
            && scene.model.parameters[torque].unit == "N*m"
            && scene.model.parameters[torque].varies == Varies::AsLoad
        {
            scene.parameters[torque] *= 0.7 + 0.6 * draw.unit();
        }
    }
}

/// Lets the constant torques vary in time.
fn drive(scene: &mut Scene, draw: &mut Draw) {
    for torque in 0..scene.parameters.len() {
        let (parameter, mean) = (&scene.model.parameters[torque], scene.parameters[torque]);
        let fixed = scene.time_histories.iter().all(|(which, _)| *which != torque);
        if !fixed || parameter.unit != "N*m" || parameter.varies != Varies::AsLoad || mean == 0.0 {
            continue;
        }
        let points: Vec<(f64, f64)> =
            (0..4).map(|i| (f64::from(i) * 0.3 * scene.t_end, mean * (0.8 + 0.4 * draw.unit()))).collect();
        let harmonics = (0..2).map(|_| {
            let turns = 0.3 * 1000f64.powf(draw.unit());
            Harmonic::new(0.3 * mean * draw.unit(), turns / scene.t_end, draw.unit())
        });
        let history = TimeHistory::table(&points).with(harmonics.collect());
        scene.parameters[torque] = history.at_start();
        scene.time_histories.push((torque, history));
    }
}

/// Random numbers that depend only on the name and the variant.
struct Draw(u64);

impl Draw {
    fn new(name: &str, variant: u64) -> Self {
        let mut hasher = DefaultHasher::new();
        (name, variant).hash(&mut hasher);
        Draw(hasher.finish())
    }

    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 ^ (self.0 >> 33)) >> 11) as f64 / (1u64 << 53) as f64
    }
}
