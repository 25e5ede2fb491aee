//! Tests of the gears of meshes: their rotation and lead are those of the run, and pairs of teeth leave contact where the stiffness falls.

use std::f64::consts::TAU;
use std::path::Path;

use super::*;
use crate::known::MODELS;

fn run(scene: &str, set: &[&str]) -> (Scene, Trajectory) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes").join(scene);
    let set: Vec<String> = set.iter().map(|value| value.to_string()).collect();
    let scene = Scene::load_with(&path, &set, &crate::known::descriptions()).unwrap();
    let entry = MODELS.iter().find(|entry| entry.model.name == scene.model.name).unwrap();
    let outcome = entry.run(&scene, &mut |_| {}).unwrap();
    (scene, outcome.trajectory)
}

/// The mesh of `law`.
fn mesh<'a>(all: &'a [Result<Engaged<'a>, (&'static Law, String)>], law: &str) -> &'a Engaged<'a> {
    all.iter().flatten().find(|mesh| mesh.law.name == law).unwrap_or_else(|| panic!("no mesh {law}"))
}

/// The rotation is the integral of the recorded speed: compared over the whole run, by the trapezoidal rule.
fn turns_as_recorded(mesh: &Engaged<'_>, run: &Trajectory) {
    let speed = run.output(mesh.rotor.expect("a rotor")).unwrap();
    let area = |i: usize| 0.5 * (speed[i] + speed[i + 1]) * (run.t[i + 1] - run.t[i]);
    let turned: f64 = (0..run.len() - 1).map(area).sum();
    let (first, last) = (mesh.rotation[0], mesh.rotation[run.len() - 1]);
    assert!(((last - first) / turned - 1.0).abs() < 1e-4, "{}: {} {turned}", mesh.law.name, last - first);
}

#[test]
fn a_gear_pair_turns_by_its_coordinates() {
    let (scene, run) = run("gear_pair_teeth.toml", &["run.t_end=20 ms"]);
    let all = engaged(&scene, &run);
    let mesh = mesh(&all, "k");
    assert_eq!((mesh.known, mesh.gears.teeth, mesh.rotor), (ToothData::Teeth, [24.0, 96.0], Some("rotor_speed_1")));
    // theta_1 = (theta + phi)/N1; the lead r_b1 theta_1 - r_b2 theta_2 = 2 r_b1/N1 phi.
    let base = mesh.gears.contact().unwrap().base[0];
    for row in 0..run.len() {
        assert!(
            (mesh.rotation[row] - (run.q[0][row] + run.q[1][row]) / 24.0).abs() < 1e-13 * run.q[0][row].abs().max(1.0)
        );
        assert!((mesh.lead[row] - 2.0 * base / 24.0 * run.q[1][row]).abs() < 1e-15);
    }
    turns_as_recorded(mesh, &run);
    assert!(mesh.force.unwrap().1.iter().any(|x| *x > 0.0) && mesh.play.is_none());
}

/// Where the recorded stiffness falls, a pair is at the end of the path of contact; where it rises, a pair is at the beginning. This holds
/// for laws from teeth, and for given steps with the contact ratio of the drawn teeth.
#[test]
fn pairs_enter_and_leave_where_the_stiffness_steps() {
    for (scene, tolerance) in [("gear_pair_teeth.toml", 1e-6), ("oh2005/energy_300rpm.toml", 2e-3)] {
        let (scene, run) = run(scene, &["run.t_end=40 ms"]);
        let all = engaged(&scene, &run);
        let mesh = mesh(&all, "k");
        let contact = mesh.gears.contact().unwrap();
        let (mut left, mut entered) = (0, 0);
        for (before, after) in run.events() {
            let x = contact.base[0] * mesh.rotation[after] + mesh.begin - 0.5 * mesh.lead[after];
            let from = |end: f64| ((x - end) / contact.base_pitch - ((x - end) / contact.base_pitch).round()).abs();
            let falls = run.strain[after] < run.strain[before];
            *(if falls { &mut left } else { &mut entered }) += 1;
            let end = if falls { contact.recess } else { -contact.approach };
            assert!(from(end) < tolerance, "{}: {falls} {}", scene.name, from(end));
        }
        assert!(left > 3 && entered > 3, "{left} {entered}");
    }
}

#[test]
fn meshes_of_several_models_have_their_gears() {
    let cases: [(&str, &str, [f64; 2], ToothData, bool); 8] = [
        ("two_stage.toml", "k12", [21.0, 63.0], ToothData::BaseRadius, true),
        ("two_stage.toml", "k34", [20.0, 74.0], ToothData::BaseRadius, true),
        ("idler.toml", "k23", [35.0, 56.0], ToothData::BaseRadius, true),
        ("backlash.toml", "k", [24.0, 96.0], ToothData::Numbers, true),
        ("planetary_3.toml", "k_s1", [27.0, 36.0], ToothData::BaseRadius, false),
        ("planetary_3.toml", "k_r1", [36.0, 99.0], ToothData::BaseRadius, false),
        ("train_turbine.toml", "k12", [80.0, 23.0], ToothData::BaseRadius, true),
        ("train_helical.toml", "k12", [17.0, 103.0], ToothData::Teeth, true),
    ];
    for (scene, law, teeth, known, has_rotor) in cases {
        let (scene, run) = run(scene, &["run.t_end=10 ms"]);
        let all = engaged(&scene, &run);
        let mesh = mesh(&all, law);
        assert_eq!((mesh.gears.teeth, mesh.known, mesh.rotor.is_some()), (teeth, known, has_rotor), "{law}");
        assert_eq!(mesh.gears.internal, law == "k_r1", "{law}");
        if has_rotor {
            turns_as_recorded(mesh, &run);
        }
        // One pitch of the phase moves a pair of teeth by one base pitch.
        let contact = mesh.gears.contact().unwrap();
        let phase = run.model.coordinates.iter().position(|c| c.name == mesh.law.phase).unwrap();
        let last = run.len() - 1;
        let moved = contact.base[0] * (mesh.rotation[last] - mesh.rotation[0]);
        let pitches = (run.q[phase][last] - run.q[phase][0]) / TAU;
        assert!((moved - pitches * contact.base_pitch).abs() < 0.05 * contact.base_pitch, "{law}: {moved} {pitches}");
    }
}

/// Play is a length along the line of action; in gear_pair b is an angle phi.
#[test]
fn play_is_a_length() {
    let (scene, trajectory) = run("backlash.toml", &["run.t_end=1 ms"]);
    let all = engaged(&scene, &trajectory);
    // b = bt N1/(2 rb1) with bt = 0.1 mm. In modules of 6.35 mm the play is 0.1/6.35.
    let play = mesh(&all, "k").play.unwrap();
    assert!((play / (0.1 / 6.35) - 1.0).abs() < 1e-3, "{play}");
    let (scene, trajectory) = run("response.toml", &["run.t_end=1 ms"]);
    let all = engaged(&scene, &trajectory);
    assert_eq!(mesh(&all, "k12").play, Some(1e-4));
}
