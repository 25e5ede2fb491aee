//! The scenes of the paper, run with changed parameters, and numbers that several tables need.

use std::path::PathBuf;

use anyhow::{Context, anyhow};
use gearsim::run::Outcome;
use gearsim::scene::Scene;
use gearsim_tests::oh2005::GearPair;

/// T0 of the committed scenes [N m]; the paper does not say.
pub const T0: f64 = 10.0;
/// T0 of the scans [N m].
pub const TORQUES: [f64; 16] =
    [1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 30.0, 40.0, 50.0, 70.0, 100.0, 120.0, 150.0, 200.0, 300.0, 500.0];
/// Sampling rate of the spectra [Hz].
pub const RATE: f64 = 1e5;

/// A set of equations; the scenes' file names end with it.
#[derive(Clone, Copy, PartialEq)]
pub enum Set {
    /// Eqs. (2), (3), with jumps.
    Exact,
    /// Eqs. (4), (5), without jump terms.
    Rigid,
    /// Eq. (6).
    Classical,
}

impl Set {
    /// All, in the order of the paper's Fig. 4.
    pub const ALL: [Set; 3] = [Set::Exact, Set::Rigid, Set::Classical];

    /// Name in legends.
    pub fn label(self) -> &'static str {
        match self {
            Set::Exact => "exact, Eqs. (2), (3)",
            Set::Rigid => "rigid kinematic, Eqs. (4), (5)",
            Set::Classical => "classical, Eq. (6)",
        }
    }
}

/// The folder of the scenes.
pub fn folder() -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "..", "..", "models", "scenes", "oh2005"].iter().collect()
}

/// The hand-written gear pair at damping `zeta` and torque `t0` [N m]: for its constants, and for the damping as printed.
pub fn pair(zeta: f64, t0: f64) -> GearPair {
    GearPair::paper(zeta, t0)
}

/// Runs the scene `name` with `overrides`, as for `--set`.
pub fn run(name: &str, overrides: &[String]) -> anyhow::Result<Outcome> {
    let models: Vec<_> = gearsim::models().iter().map(|entry| entry.model).collect();
    let scene = Scene::load_with(&folder().join(format!("{name}.toml")), overrides, &models)
        .map_err(|errors| anyhow!("{}", errors.render(100, false)))
        .with_context(|| format!("scene {name} with {overrides:?}"))?;
    let entry = gearsim::models().iter().find(|entry| entry.model.name == scene.model.name).context("no such model")?;
    Ok(entry.run(&scene, &mut |_| {})?)
}

/// Jump strength at the start of a run from `rpm`: J = M2 dk phi_s^2/theta'^2 with phi_s = T0/k1. With
/// phi = phi_s at rest, a step with J > 1 reflects.
pub fn strength(rpm: u32, t0: f64) -> f64 {
    let p = pair(0.0, t0);
    let (phi, theta_dot) = (t0 / p.k1, p.start(f64::from(rpm)).theta_dot);
    p.m2() * (p.k2 - p.k1) * phi * phi / (theta_dot * theta_dot)
}

/// Runs the scene of Fig. 3 at torque `t0` [N m], and records its events.
pub fn energy(set: Set, t0: f64) -> anyhow::Result<Outcome> {
    let name = if set == Set::Exact { "energy_300rpm" } else { "energy_300rpm_rigid" };
    run(name, &[format!("parameters.T0={t0} N*m")])
}

/// Runs a scene of Fig. 4 from `rpm` for `t_end` [s] at torque `t0` [N m] and damping `zeta`; records samples only.
pub fn spectrum(set: Set, rpm: u32, zeta: f64, t0: f64, t_end: f64) -> anyhow::Result<Outcome> {
    let equations = match set {
        Set::Exact => "exact",
        Set::Rigid => "rigid",
        Set::Classical => "classical",
    };
    run(
        &format!("spectrum_{rpm}rpm_{equations}"),
        &[
            format!("parameters.T0={t0} N*m"),
            format!("parameters.zeta={zeta}"),
            format!("run.t_end={t_end} s"),
            format!("output.rate={RATE} Hz"),
            "output.events=false".into(),
        ],
    )
}

/// Mean speed theta' over the last two tooth pitches [rad/s], a whole number of periods, so that the vibration of theta'
/// averages out; over the last 10 ms if two pitches take longer.
pub fn mean_speed(outcome: &Outcome) -> f64 {
    let (t, theta) = (&outcome.trajectory.t, &outcome.trajectory.q[0]);
    let last = t.len() - 1;
    let from = theta[last] - 2.0 * std::f64::consts::TAU;
    let i = theta.partition_point(|x| *x < from);
    if i == 0 || t[last] - t[i] > 0.01 {
        let i = t.partition_point(|x| *x < t[last] - 0.01).min(last - 1);
        return (theta[last] - theta[i]) / (t[last] - t[i]);
    }
    let begin = t[i] - (theta[i] - from) / (theta[i] - theta[i - 1]) * (t[i] - t[i - 1]);
    (theta[last] - from) / (t[last] - begin)
}

/// Time of the first sample with a negative speed [s]; infinite if there is none.
pub fn turned(theta_dot: &[f64]) -> f64 {
    theta_dot.iter().position(|v| *v < 0.0).map_or(f64::INFINITY, |i| i as f64 / RATE)
}
