//! How long and how hard the teeth of a mesh pull. Teeth can only push. Without the effect of play a mesh is a spring in both directions,
//! and its force may take the sign opposite to that of its load.
//!
//! The load has the sign of the mean force, an integral over the time. The force varies linearly between recorded rows. Both sides of an
//! event are rows.

use super::orders::{force, play};
use crate::model::{Law, Output, Role};
use crate::scene::Scene;
use crate::tolerance::analysis::PULL;
use crate::trajectory::Trajectory;

/// How a mesh pulls.
#[derive(Debug, Clone, Copy)]
pub struct Pulling {
    /// The stiffness law of the mesh.
    pub law: &'static Law,
    /// The output that is its force, or its torque.
    pub force: &'static Output,
    /// Mean force over the time \[N or N m\].
    pub mean: f64,
    /// Share of the time in which the teeth pull \[1\].
    pub share: f64,
    /// Largest magnitude of the pulling force \[N or N m\].
    pub largest: f64,
    /// The effect with which the teeth would part; `None` if the model has none for this mesh.
    pub without: Option<&'static str>,
}

/// The pulling of all meshes of a run whose forces are recorded, from the time `from` \[s\] on. A mesh with play does not pull.
pub fn of(scene: &Scene, run: &Trajectory, from: f64) -> Vec<Pulling> {
    let laws = scene.present().map(|(law, _)| law).filter(|law| law.role == Role::Stiffness);
    laws.filter_map(|law| of_mesh(scene, run, law, from)).collect()
}

/// The pulling of the mesh with the stiffness `law`; `None` if its force is not recorded, or no time passes.
pub fn of_mesh(scene: &Scene, run: &Trajectory, law: &'static Law, from: f64) -> Option<Pulling> {
    let force = force(scene.model, law.name)?;
    let begin = run.row_from(from);
    let (t, x) = (&run.t[begin..], &run.output(force.name)?[begin..]);
    let pieces = || t.windows(2).zip(x.windows(2)).map(|(t, x)| (t[1] - t[0], x[0], x[1]));
    let time: f64 = pieces().map(|(dt, ..)| dt).sum();
    if time.partial_cmp(&0.0) != Some(std::cmp::Ordering::Greater) {
        return None;
    }
    let mean = pieces().map(|(dt, a, b)| 0.5 * (a + b) * dt).sum::<f64>() / time;
    let switch = play(scene.model, law.name);
    let none = Pulling { law, force, mean, share: 0.0, largest: 0.0, without: switch.map(|switch| switch.with) };
    if switch.is_some_and(|switch| scene.effects.has(switch.with, scene.model)) {
        return Some(none);
    }
    let pull = |x: f64| if mean < 0.0 { x } else { -x };
    let largest = x.iter().fold(0.0, |m: f64, x| m.max(pull(*x)));
    let load = x.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    if largest <= PULL * load {
        return Some(none);
    }
    let pulls = pieces().map(|(dt, a, b)| dt * share_above_zero(pull(a), pull(b))).sum::<f64>();
    Some(Pulling { share: pulls / time, largest, ..none })
}

/// The share of an interval in which a line from `a` to `b` is above zero \[1\].
fn share_above_zero(a: f64, b: f64) -> f64 {
    match (a > 0.0, b > 0.0) {
        (true, true) => 1.0,
        (false, false) => 0.0,
        (true, false) => a / (a - b),
        (false, true) => b / (b - a),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A mesh whose force is 1 N m + 2 N m sin: it pulls for a third of a period, with 1 N m.
    #[test]
    fn an_offset_sine_pulls_for_a_third_of_its_period() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes/gear_pair_shafts.toml");
        let pulls = |changes: &[&str], sign: f64| {
            let changes: Vec<String> = changes.iter().map(|change| (*change).to_owned()).collect();
            let scene = Scene::load_with(std::path::Path::new(path), &changes, &crate::known::descriptions()).unwrap();
            let number = scene.model.outputs.iter().position(|output| output.name == "mesh_force_12").unwrap();
            let mut run = Trajectory::new(scene.model, &[], &[number]);
            run.t = (0..=6000).map(|i| f64::from(i) / 1000.0).collect();
            run.outputs[0].1 = run.t.iter().map(|t| sign * (1.0 + 2.0 * (std::f64::consts::TAU * t).sin())).collect();
            of(&scene, &run, 1.0)[0]
        };
        for sign in [1.0, -1.0] {
            let found = pulls(&[], sign);
            assert!((found.mean - sign).abs() < 1e-12 && found.without == Some("backlash_12"), "{found:?}");
            // The error of a line between samples: the sine bends by (w h)^2/8 of its value at a zero of the force.
            assert!((found.share - 1.0 / 3.0).abs() < 1e-6 && (found.largest - 1.0).abs() < 1e-12, "{found:?}");
            let with_play = pulls(&["effects=[\"torques\", \"backlash\"]", "parameters.b12=100 um"], sign);
            assert_eq!((with_play.share, with_play.largest), (0.0, 0.0));
        }
    }
}
