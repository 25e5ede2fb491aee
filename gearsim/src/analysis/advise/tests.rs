//! Tests of the estimates for the paper's gear pair against runs.

use std::f64::consts::TAU;
use std::path::Path;

use super::orbit::{Steady, Unknown};
use super::*;
use crate::known::MODELS;
use crate::run::Outcome;
use crate::scene::Scene;
use crate::trajectory::Moment;

fn scene(rpm: f64, effects: &str, more: &[&str]) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes/oh2005/energy_300rpm.toml");
    let models: Vec<_> = MODELS.iter().map(|entry| entry.model).collect();
    let mut set = vec![format!("effects=[{effects}]"), format!("start.speed={rpm} rpm")];
    set.extend(more.iter().map(ToString::to_string));
    Scene::load_with(&path, &set, &models).unwrap()
}

const ALL: &str = "\"stiffness_step\", \"damping\", \"torques\"";
const FROZEN: &str = "\"stiffness_step\", \"damping\", \"torques\", \"frozen_phase\"";

fn run(scene: &Scene) -> Outcome {
    let entry = MODELS.iter().find(|entry| entry.model.name == scene.model.name).unwrap();
    entry.run(scene, &mut |_| {}).unwrap()
}

fn steady_of<T>(scene: &Scene, f: impl FnOnce(&Steady<'_>) -> T) -> Result<T, Unknown> {
    let entry = MODELS.iter().find(|entry| entry.model.name == scene.model.name).unwrap();
    let system = entry.system(scene).unwrap();
    Steady::of(scene, &system).map(|steady| f(&steady))
}

/// A run under the classical equations converges to the settled motion: size, mean square and peak agree. The spectral lines sum to the
/// mean square.
#[test]
fn the_orbit_is_where_a_run_settles() {
    let errors = "laws.e={pitch_errors=[\"0 rad\", \"1e-3 rad\"], phase=\"0.4 rad\"}";
    for (rpm, error) in [(600.0, false), (1500.0, false), (4500.0, false), (600.0, true), (4500.0, true)] {
        // The pitch errors have a period of two teeth.
        let pitch = if error { 2.0 } else { 1.0 } * 60.0 / (24.0 * rpm);
        // The run has 60 pitches, and the last 20 are evaluated: by then e^(-zeta w t) is below 1e-9.
        let t_end = format!("run.t_end={:?} s", 60.0 * pitch);
        let rate = format!("output.rate={:?} Hz", 1000.0 / pitch);
        let set = [&t_end[..], &rate, "parameters.zeta=0.1"];
        let set = if error { [&set[..], &[errors]].concat() } else { set.to_vec() };
        let with = |effects: &str| if error { format!("{effects}, \"transmission_error\"") } else { effects.into() };
        let outcome = run(&scene(rpm, &with(FROZEN), &set));
        let orbit = steady_of(&scene(rpm, &with(ALL), &set), |steady| steady.orbit(1.0, false).unwrap()).unwrap();
        assert!((orbit.period / pitch - 1.0).abs() < 1e-12 && orbit.steps == if error { 6 } else { 2 });
        let t = &outcome.trajectory;
        let late = |i: &usize| t.moment[*i] == Moment::Sample && t.t[*i] > 40.0 * pitch * (1.0 + 1e-9);
        let phi: Vec<f64> = (0..t.len()).filter(late).map(|i| t.q[1][i]).collect();
        let mean = phi.iter().sum::<f64>() / phi.len() as f64;
        let square = phi.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / phi.len() as f64;
        let peak = phi.iter().fold(0.0f64, |m, x| m.max((x - mean).abs()));
        let size = phi.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        assert!((orbit.size[1] / size - 1.0).abs() < 1e-3, "{rpm}: size {} {size}", orbit.size[1]);
        assert!((orbit.square[1] / square - 1.0).abs() < 2e-3, "{rpm}: square {} {square}", orbit.square[1]);
        assert!((orbit.peak[1] / peak - 1.0).abs() < 1e-3, "{rpm}: peak {} {peak}", orbit.peak[1]);
        // Parseval's theorem: the sum of the lines is the mean square.
        let lines: f64 = orbit.lines[1].iter().sum();
        assert!((lines / orbit.square[1] - 1.0).abs() < 1e-3, "{rpm}: lines {lines}");
    }
}

/// In slow rotation the vibration after every step decays before the next step. A pitch then dissipates
/// T0² (1/k1 - 1/k2)² (k1 + k2), the strain energy left over at both steps. This holds with and without the impulses, which only
/// transfer this energy.
#[test]
fn a_slow_pitch_dissipates_the_energy_of_its_steps() {
    let set = ["parameters.zeta=0.1", "parameters.T0=10 N*m"];
    let orbit = steady_of(&scene(30.0, ALL, &set), |steady| steady.orbit(1.0, false).unwrap()).unwrap();
    let (k1, k2) = (1430.0, 2780.0);
    let cost = 100.0 * (1.0 / k1 - 1.0f64 / k2).powi(2) * (k1 + k2);
    assert!((orbit.lost / cost - 1.0).abs() < 0.02, "{} {cost}", orbit.lost);
}

/// The jump strength of the gear pair is that of Oh, Grosh & Barber (2005), M2 dk (T0/k1)²/theta'².
#[test]
fn the_jump_strength_is_that_of_the_paper() {
    let scene = scene(600.0, ALL, &["parameters.T0=10 N*m"]);
    let entry = MODELS.iter().find(|entry| entry.model.name == "gear_pair").unwrap();
    let system = entry.system(&scene).unwrap();
    let groups = groups::Groups::of(&scene, &system).unwrap();
    let m2 = 0.5 * (24f64.powi(2) / 2.89e-3 + 96f64.powi(2) / 0.7402);
    let speed = 24.0 * 600.0 * TAU / 60.0;
    let j = m2 * (2780.0 - 1430.0) * (10.0f64 / 1430.0).powi(2) / (speed * speed);
    assert!((groups.strength() / j - 1.0).abs() < 1e-9, "{} {j}", groups.strength());
    assert!((groups.mesh() - 240.0).abs() < 1e-9 && groups.meshes[0].ratio == 2780.0 / 1430.0);
}

/// Play is relative to the static deflection F/k of its own mesh at the mid stiffness. The torque is 95 N m at the first stage and three
/// times as much at the second.
#[test]
fn play_is_compared_with_the_deflection_of_its_mesh() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes/two_stage.toml");
    let models: Vec<_> = MODELS.iter().map(|entry| entry.model).collect();
    let set = ["effects=[\"torques\", \"backlash\"]", "parameters.b12=50 um", "parameters.b34=5 um"];
    let scene = Scene::load_with(&path, &set.map(String::from), &models).unwrap();
    let entry = MODELS.iter().find(|entry| entry.model.name == "two_stage").unwrap();
    let groups = groups::Groups::of(&scene, &entry.system(&scene).unwrap()).unwrap();
    let expected = [50e-6 / (95.0 / 24.7e-3 / 325e6), 5e-6 / (285.0 / 37.6e-3 / 520e6)];
    assert_eq!(groups.gaps.iter().map(|gap| gap.0).collect::<Vec<_>>(), ["b12", "b34"]);
    for ((name, found), expected) in groups.gaps.iter().zip(expected) {
        assert!((found / expected - 1.0).abs() < 1e-6, "{name}: {found}, not {expected}");
    }
}

#[test]
fn scenes_without_a_settled_motion_name_the_reason() {
    let undamped = scene(600.0, "\"stiffness_step\", \"torques\"", &[]);
    assert_eq!(steady_of(&undamped, |_| ()).unwrap_err(), Unknown::Unsettled);
    let ramped = scene(600.0, ALL, &["laws.k.ramp=0.1 rad"]);
    assert_eq!(steady_of(&ramped, |_| ()).unwrap_err(), Unknown::Curved);
    let still = scene(0.0, ALL, &[]);
    assert!(matches!(steady_of(&still, |_| ()).unwrap_err(), Unknown::Aperiodic(_)));
}

/// Every effect of the scene is a candidate. It is left out together with the effects that require it. Each approximation of the jump terms
/// is a candidate too.
#[test]
fn candidates_are_the_effects() {
    let scene = scene(600.0, FROZEN, &[]);
    let base = base(&scene);
    assert_eq!(base.effects.names(base.model), ["stiffness_step", "damping", "torques"]);
    let found = candidates(&base);
    let without: Vec<_> = found.iter().map(|c| c.without.as_str()).collect();
    assert_eq!(without, ["jump terms", "jump terms, moving phase", "stiffness_step", "damping", "torques"]);
    let names = |i: usize| found[i].scene.effects.names(base.model).join(" ");
    assert_eq!(names(0), "stiffness_step rigid_kinematics damping torques");
    assert_eq!(names(2), "damping torques");
}

#[test]
fn deviations_are_those_of_the_worst_coordinate() {
    let bands = Bands::of(100.0, 900.0, 4000.0);
    assert_eq!(
        (bands.width, bands.index(49.0), bands.index(51.0), bands.index(451.0)),
        (400.0, None, Some(0), Some(1))
    );
    let a = Measures {
        rms: vec![1.0, 2.0],
        peak: vec![3.0, 4.0],
        size: vec![3.0, 4.0],
        bands: vec![vec![1.0, 1e-9], vec![1.0, 0.5]],
        speed: vec![100.0],
        energy: 10.0,
        at_start: 20.0,
        events: 200.0,
        reflections: 0,
    };
    assert!(a.apart(&a, &["m", "m"]).each().iter().all(|x| *x == 0.0));
    let mut b = a.clone();
    (b.rms[1], b.peak[0], b.bands[1][1], b.speed[0], b.energy, b.events) = (2.2, 2.7, 5.0, 99.0, 12.0, 150.0);
    // A band with too little power is not compared.
    b.bands[0][1] = 1e-7;
    let apart = a.apart(&b, &["m", "m"]).each();
    for (x, want) in apart.into_iter().zip([0.1, 0.1, 10.0, 0.01, 0.1, 0.25]) {
        assert!((x - want).abs() < 1e-12, "{apart:?}");
    }
}

/// The play of two meshes is judged for both together, and for each with the other one kept. If only one mesh has play, it is judged once.
#[test]
fn effects_of_parts_are_judged_together_and_separately() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes/two_stage.toml");
    let models: Vec<_> = MODELS.iter().map(|entry| entry.model).collect();
    let of = |effects: &str| {
        let set = [format!("effects=[{effects}]"), "parameters.b12=50 um".into(), "parameters.b34=5 um".into()];
        candidates(&base(&Scene::load_with(&path, &set, &models).unwrap()))
    };
    let play = |candidates: Vec<Candidate>| -> Vec<(String, Vec<&'static str>)> {
        let names = |c: Candidate| (c.without, c.scene.effects.names(c.scene.model));
        candidates.into_iter().map(names).filter(|(without, _)| without.starts_with("backlash")).collect()
    };
    let left = |of: &[(String, Vec<&'static str>)]| {
        let left = of.iter().map(|(without, names)| {
            let kept: Vec<_> = names.iter().filter(|name| name.starts_with("backlash")).copied().collect();
            (without.clone(), kept.join(", "))
        });
        left.collect::<Vec<_>>()
    };
    let both = left(&play(of("\"stiffness_step\", \"torques\", \"backlash\"")));
    let expected = [("backlash", ""), ("backlash_12", "backlash_34"), ("backlash_34", "backlash_12")];
    assert_eq!(both, expected.map(|(without, kept)| (without.to_string(), kept.to_string())));
    let one = left(&play(of("\"stiffness_step\", \"torques\", \"backlash_12\"")));
    assert_eq!(one, [("backlash_12".to_string(), String::new())]);
}
