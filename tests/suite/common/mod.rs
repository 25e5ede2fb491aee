//! Scenes for the tests, and functions that run them.

#![allow(dead_code)] // each test binary uses only some of these

use std::path::{Path, PathBuf};

use gearsim::model::Model;
use gearsim::run::{Entry, Outcome};
use gearsim::scene::Scene;
use gearsim_tests::oh2005::GearPair;

/// The scenes of the paper: file stem, damping ratio zeta, speed of the driving gear [rpm].
pub const PAPER: [(&str, f64, f64); 3] =
    [("energy_300rpm", 0.1, 300.0), ("spectrum_600rpm_exact", 0.05, 600.0), ("spectrum_4500rpm_exact", 0.05, 4500.0)];

/// The repository's root.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The registry entry of a model: its description and the function that runs its scenes.
pub fn model(name: &str) -> &'static Entry {
    gearsim::models().iter().find(|m| m.model.name == name).unwrap()
}

/// The descriptions of all models.
pub fn models() -> Vec<&'static Model> {
    gearsim::models().iter().map(|m| m.model).collect()
}

/// Loads a scene from `models/scenes`, with overrides (`key=value`).
pub fn scene(name: &str, overrides: &[String]) -> Scene {
    let path = root().join("models/scenes").join(format!("{name}.toml"));
    Scene::load_with(&path, overrides, &models()).unwrap_or_else(|e| panic!("{}", e.render(100, false)))
}

/// Runs a scene to its end; panics if the run stops early.
pub fn run(scene: &Scene) -> Outcome {
    let outcome = model(scene.model.name).run(scene, &mut |_| {}).unwrap();
    if let Some(stop) = &outcome.stopped_by {
        panic!("{}: {stop}", scene.name);
    }
    outcome
}

/// The scene of a gear pair that starts at theta = 0 with the speed `theta_dot` [rad/s], and phi in its static equilibrium.
/// It runs to `t_end` [s].
pub fn gear_pair(pair: &GearPair, theta_dot: f64, t_end: f64) -> Scene {
    let set = |key: &str, value: String| format!("{key}={value}");
    scene(
        "oh2005/energy_300rpm",
        &[
            set("parameters.zeta", format!("{:?}", pair.zeta)),
            set("parameters.T0", format!("{:?} N*m", pair.t0)),
            set("start.theta_dot", format!("{theta_dot:?} rad/s")),
            set("run.t_end", format!("{t_end:?} s")),
            set("output.rate", format!("{:?} Hz", (100.0 / t_end).round())),
        ],
    )
}

/// The relative difference |a - b| / max(|b|, scale).
pub fn relative(a: f64, b: f64, scale: f64) -> f64 {
    (a - b).abs() / b.abs().max(scale)
}
