//! Laws with a mesh phase, in whole runs.

use std::f64::consts::TAU;
use std::path::Path;

use crate::known::MODELS;
use crate::run::Outcome;
use crate::scene::Scene;

fn load(name: &str, set: &[String]) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes").join(format!("{name}.toml"));
    let models: Vec<_> = MODELS.iter().map(|entry| entry.model).collect();
    Scene::load_with(&path, set, &models).map_err(|e| e.render(160, false)).unwrap()
}

fn run(scene: &Scene) -> Outcome {
    let entry = MODELS.iter().find(|entry| entry.model.name == scene.model.name).unwrap();
    let outcome = entry.run(scene, &mut |_| {}).unwrap();
    assert!(outcome.stopped_by.is_none());
    outcome
}

/// Coordinates and speeds at the end.
fn end(outcome: &Outcome) -> Vec<f64> {
    let t = &outcome.trajectory;
    t.q.iter().chain(&t.q_dot).map(|x| x[x.len() - 1]).collect()
}

fn apart(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs() / a.abs().max(b.abs()).max(1e-6)).fold(0.0, f64::max)
}

/// A mesh phase of whole pitches changes no bit of the result.
#[test]
fn a_phase_of_whole_pitches_changes_no_bit() {
    for phase in ["1", "-3"] {
        let set = [format!("laws.k.phase={phase}")];
        let (with, without) = (run(&load("oh2005/energy_300rpm", &set)), run(&load("oh2005/energy_300rpm", &[])));
        assert_eq!(end(&with), end(&without), "{phase}");
    }
}

/// The same law with its levels in another order: [a, b], shifted forwards by a part of b, is [end of b, a, beginning of b]. The
/// pitch then ends within a level. The runs use the exact, the rigid kinematic and the classical equations, both directions of
/// rotation, and both precisions.
#[test]
fn a_phase_shifts_the_beginning_of_the_pitch() {
    let dropping = [vec![], vec!["rigid_kinematics"], vec!["frozen_phase"]];
    for (more, speed) in dropping.iter().flat_map(|more| [300.0, -300.0].map(|speed| (more, speed))) {
        for precision in ["plain", "compensated"] {
            let names: Vec<_> = ["stiffness_step", "damping", "torques"].iter().chain(more).collect();
            let common = [
                format!("effects={names:?}"),
                format!("start.speed={speed} rpm"),
                format!("run.precision=\"{precision}\""),
                "parameters.T0=20 N*m".to_string(),
            ];
            let law = |law: &str| run(&load("oh2005/energy_300rpm", &[&common[..], &[law.to_string()]].concat()));
            let steps = "steps = [{ value = \"1.43 kN*m\", width = \"1.73 rad\" }, { value = \"2.78 kN*m\" }]";
            let ahead = law(&format!("laws.k={{ {steps}, phase = \"-1 rad\" }}"));
            let cut = law(
                "laws.k.steps=[{ value = \"2.78 kN*m\", width = \"1 rad\" }, { value = \"1.43 kN*m\", width = \"1.73 rad\" }, \
                 { value = \"2.78 kN*m\" }]",
            );
            let off = apart(&end(&ahead), &end(&cut));
            assert!(off < 1e-9, "{more:?} {speed} {precision}: {off:e}");
            assert!(ahead.counts.cell_changes < cut.counts.cell_changes, "the cut must not be an event");
        }
    }
}

/// Runs side by side in lanes against single runs.
#[test]
fn lanes_use_mesh_phases() {
    let phases = [0.0, 0.2, 0.5, 0.9];
    let set = |phase: f64| [format!("laws.k.phase={phase:?}"), "start.speed=-600 rpm".to_string()];
    let scenes: Vec<_> = phases.iter().map(|phase| load("oh2005/energy_300rpm", &set(*phase))).collect();
    let entry = MODELS.iter().find(|entry| entry.model.name == "gear_pair").unwrap();
    for (scene, side) in scenes.iter().zip(entry.ends(&scenes)) {
        let (alone, side) = (run(scene), side.unwrap());
        let off = apart(&end(&alone), &end(&side));
        assert!(off < 1e-9 && alone.counts.cell_changes == side.counts.cell_changes, "{off:e}");
    }
}

/// Two meshes on one coordinate. Shifting all mesh phases forwards by an angle and the start backwards by the same angle gives
/// the same motion.
#[test]
fn shifting_phases_equals_shifting_the_start() {
    for speed in [400.0, -400.0] {
        let at = |start: f64, shift: f64| {
            let set = [
                format!("start.speed={speed} rpm"),
                format!("start.theta={start:?} rad"),
                format!("laws.k12.phase={:?} rad", 0.4 + shift),
                format!("laws.k23.phase={:?} rad", 2.9 + shift),
            ];
            let outcome = run(&load("idler", &set));
            let mut end = end(&outcome);
            let theta = outcome.trajectory.model.coordinates.iter().position(|c| c.name == "theta").unwrap();
            end[theta] -= start;
            (end, outcome.counts.cell_changes)
        };
        let (here, events) = at(0.3, 0.0);
        for shift in [0.1, -2.0, 5.0, TAU] {
            let (there, same) = at(0.3 - shift, shift);
            let off = apart(&here, &there);
            assert!(off < 1e-9 && events == same, "{speed} {shift}: {off:e}");
        }
        let (other, _) = at(0.3, 1.0);
        assert!(apart(&here, &other) > 1e-6, "a shift of one phase alone must change the motion");
    }
}

/// Parker & Lin (2004): planets in phase excite the torsional modes only, and the centres of sun, ring and carrier stay at rest. With a
/// third of a pitch between the mesh phases of the planets, the centres move. k_s and k_r have the same phases. Teeth: 27-36-99 and
/// 28-35-98.
#[test]
fn planets_in_phase_do_not_move_the_centres() {
    let stage = |z_s: u32, z_r: u32| {
        let planet = (z_r - z_s) / 2;
        let mut set = vec![
            format!("parameters.Z_s={z_s}"),
            format!("parameters.Z_r={z_r}"),
            format!("parameters.r_s={:?} m", f64::from(z_s) * 1.5e-3 * 20f64.to_radians().cos()),
            format!("parameters.T_load={:?} N*m", 300.0 * (1.0 + f64::from(z_r) / f64::from(z_s))),
            "run.t_end=0.02 s".to_string(),
            "effects=[\"stiffness_step\", \"torques\"]".to_string(),
        ];
        for (i, place) in [0, 120, 240].into_iter().enumerate() {
            let i = i + 1;
            set.push(format!("laws.k_s{i}.teeth=[{z_s}, {planet}]"));
            set.push(format!("laws.k_r{i}.teeth=[{planet}, {z_r}]"));
            set.push(format!("laws.k_s{i}.phase={{ sun = {z_s}, at = \"{place} deg\" }}"));
            set.push(format!("laws.k_r{i}.phase={{ ring = {z_r}, planet = {planet}, at = \"{place} deg\" }}"));
        }
        let outcome = run(&load("planar_planetary_3_phases", &set));
        let t = &outcome.trajectory;
        let largest = |start: &str| {
            let of = t.model.coordinates.iter().zip(&t.q).filter(|(c, _)| c.name.starts_with(start));
            of.flat_map(|(_, q)| q).fold(0.0f64, |m, x| m.max(x.abs()))
        };
        let swing = |name: &str| {
            let q = &t.q[t.model.coordinates.iter().position(|c| c.name == name).unwrap()];
            q.iter().fold(f64::NEG_INFINITY, |m, x| m.max(*x)) - q.iter().fold(f64::INFINITY, |m, x| m.min(*x))
        };
        let centres = ["x_", "y_"].map(largest).into_iter().fold(0.0, f64::max);
        (centres, swing("u1"))
    };
    let (together, turned) = stage(27, 99);
    assert!(turned > 1e-6, "the planets must oscillate: {turned:e} m");
    assert!(together < 1e-9 * turned, "the centres must stay at rest: {together:e} m of {turned:e} m");
    let (apart, _) = stage(28, 98);
    assert!(apart > 1e-7, "the centres must move: {apart:e} m");
}

/// A frozen phase that starts at rest never reaches a step: the stiffness is that of its cell.
#[test]
fn a_frozen_phase_at_rest_stays_in_its_cell() {
    for precision in ["plain", "compensated"] {
        let common = ["start.speed=0 rpm".to_string(), format!("run.precision=\"{precision}\"")];
        let under = |effects: &str| run(&load("oh2005/energy_300rpm", &[&common[..], &[effects.to_string()]].concat()));
        let frozen = under(r#"effects=["stiffness_step", "frozen_phase", "torques"]"#);
        assert_eq!(frozen.counts.cell_changes, 0);
    }
}
