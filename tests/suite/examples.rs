//! The examples of the library, gearsim/examples: each runs, and what it computes is right.

#[path = "../../gearsim/examples/accuracy_and_time.rs"]
#[allow(dead_code)] // `main` is not called
mod accuracy_and_time;
#[path = "../../gearsim/examples/build_a_scene.rs"]
#[allow(dead_code)]
mod build_a_scene;
#[path = "../../gearsim/examples/effects_and_time.rs"]
#[allow(dead_code)]
mod effects_and_time;
#[path = "../../gearsim/examples/natural_frequencies.rs"]
#[allow(dead_code)]
mod natural_frequencies;
#[path = "../../gearsim/examples/response_curve.rs"]
#[allow(dead_code)]
mod response_curve;
#[path = "../../gearsim/examples/run_a_scene.rs"]
#[allow(dead_code)]
mod run_a_scene;
#[path = "../../gearsim/examples/spectrum.rs"]
#[allow(dead_code)]
mod spectrum;
#[path = "../../gearsim/examples/stability.rs"]
#[allow(dead_code)]
mod stability;
#[path = "../../gearsim/examples/tolerances.rs"]
#[allow(dead_code)]
mod tolerances;
#[path = "../../gearsim/examples/vary_a_parameter.rs"]
#[allow(dead_code)]
mod vary_a_parameter;
#[path = "../../gearsim/examples/write_a_table.rs"]
#[allow(dead_code)]
mod write_a_table;

use std::f64::consts::TAU;

use gearsim::Scene;
use gearsim::output::parquet;
use gearsim_tests::oh2005::GearPair;

/// The path of a scene under models/scenes.
fn scene(name: &str) -> String {
    format!("{}/../models/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn run_a_scene_conserves_energy_and_holds_the_speed() {
    let results = run_a_scene::run(&scene("two_stage")).unwrap();
    let run = results.trajectory();
    assert!(run.residual[run.len() - 1].abs() < 1e-9 * run.largest_energy());
    // 1500 rpm; the torques are in balance, so that the speed vibrates about it.
    let speed = 1500.0 * TAU / 60.0;
    let outputs = results.summary().outputs;
    let rotor = &outputs["rotor_speed_1"];
    assert!(rotor.min.0 < speed && speed < rotor.max.0 && rotor.max.0 - rotor.min.0 < 0.5 * speed, "{rotor:?}");
    // Tooth force: 95 N m on a base radius of 24.7 mm.
    let force = 95.0 / 24.7e-3;
    assert!(
        (outputs["mesh_force_12"].mean.0 / force - 1.0).abs() < 0.02,
        "{:?}, static {force}",
        outputs["mesh_force_12"]
    );
    assert_eq!(results.events().count() as u64, results.summary().cell_changes + results.summary().reflections);
}

#[test]
fn a_scene_built_in_code_swings_as_its_closed_form() {
    let (inertia1, inertia2, stiffness, speed) = (0.5, 0.25, 1e4, 2.0);
    let results = build_a_scene::struck(inertia1, inertia2, stiffness, speed).unwrap();
    // The discs swing against each other at the relative speed of the blow.
    let omega = (stiffness * (1.0 / inertia1 + 1.0 / inertia2)).sqrt();
    for (t, twist) in results.column("t").unwrap().iter().zip(results.column("shaft_twist_1").unwrap()) {
        assert!((twist - speed / omega * (omega * t).sin()).abs() < 1e-12, "{t}: {twist}");
    }
}

#[test]
fn unknown_columns_and_parameters_are_refused_by_name() {
    let results = build_a_scene::struck(0.5, 0.25, 1e4, 2.0).unwrap();
    let error = results.column("twist").unwrap_err().to_string();
    assert!(error.contains("there is no column `twist`") && error.contains("shaft_twist_1"), "{error}");
    let error = results.scene.with("parameters.I9", 1.0).unwrap_err().to_string();
    assert!(error.contains("values set in code") && error.contains("parameters.I9=1"), "{error}");
    let error = Scene::of_model("chain_2").set("parameters.I1", 1.0).build().unwrap_err().to_string();
    assert!(error.contains("`I2`"), "{error}");
}

#[test]
fn values_set_in_code_are_those_of_the_command_line() {
    let path = scene("two_stage");
    let models: Vec<_> = gearsim::models().iter().map(|entry| entry.model).collect();
    let texts = ["run.t_end=2 ms", "parameters.T_motor=70 N*m"].map(String::from);
    let there = Scene::load_with(path.as_ref(), &texts, &models).unwrap();
    let here = Scene::load(&path).unwrap().with("run.t_end", "2 ms").unwrap();
    let here = here.with("parameters.T_motor", "70 N*m").unwrap();
    assert_eq!((&here.hash, &here.overrides), (&there.hash, &there.overrides));
    let number = Scene::load(&path).unwrap().with("parameters.T_motor", 70.0).unwrap();
    assert_eq!(number.parameter("T_motor"), here.parameter("T_motor"));
}

#[test]
fn vary_a_parameter_finds_less_vibration_with_more_damping() {
    let path = scene("oh2005/spectrum_4500rpm_exact");
    let table = vary_a_parameter::vary(&path, "parameters.zeta=0.02,0.05,0.1,0.2").unwrap();
    assert_eq!(table.numbers("parameters.zeta").unwrap(), [0.02, 0.05, 0.1, 0.2]);
    assert!(table.words("status").unwrap().iter().all(|status| status == "done"));
    let rms = table.numbers("phi_rms").unwrap();
    assert!(rms.windows(2).all(|pair| 0.0 < pair[1] && pair[1] < pair[0]), "{rms:?}");
}

#[test]
fn the_highest_line_of_the_spectrum_is_at_the_mesh_frequency() {
    let spectrum = spectrum::spectrum(&scene("oh2005/spectrum_4500rpm_exact"), "phi").unwrap();
    let highest = spectrum.frequency[spectrum::lines(&spectrum)[0]];
    // 24 teeth at 4500 rpm; the pair loses a little speed.
    let mesh = 24.0 * 4500.0 / 60.0;
    assert!((highest - mesh).abs() <= 2.0 * spectrum.resolution(), "{highest} Hz, mesh frequency {mesh} Hz");
}

#[test]
fn natural_frequencies_of_the_paper_agree_with_its_formula() {
    let pair = GearPair::paper(0.05, 10.0);
    let factors = [1.0, 0.5];
    let cells = natural_frequencies::cells(&scene("oh2005/spectrum_4500rpm_exact"), &factors).unwrap();
    assert_eq!(cells.len(), 2);
    for (cell, factor) in cells.iter().zip(factors) {
        let k = factor * 0.5 * (pair.k1 + pair.k2);
        assert!((cell.levels[0] / k - 1.0).abs() < 1e-15);
        let [rigid, elastic] = &cell.modes[..] else { panic!("{} modes", cell.modes.len()) };
        assert_eq!((rigid.natural, rigid.zeta), (0.0, None));
        let expected = (pair.m2() * k).sqrt() / TAU;
        assert!((elastic.natural / expected - 1.0).abs() < 1e-12, "{} Hz, expected {expected} Hz", elastic.natural);
    }
}

#[test]
fn pairs_with_other_backlash_and_damping_have_other_forces() {
    let forces = tolerances::largest_forces(&scene("response"), 6).unwrap();
    assert_eq!(forces.len(), 6);
    // 150 N m on a radius of 70.5 mm: the largest force exceeds the static one.
    assert!(forces[0] > 150.0 / 70.5e-3 && forces[0] < forces[5], "{forces:?}");
    assert_eq!(forces, tolerances::largest_forces(&scene("response"), 6).unwrap());
}

#[test]
fn a_pair_without_stiffness_steps_has_less_dynamic_force() {
    let path = scene("oh2005/spectrum_4500rpm_exact");
    let found = effects_and_time::without_each(&path, "mesh_torque").unwrap();
    let (_, force, time) = found.iter().find(|(effect, ..)| *effect == "stiffness_step").unwrap();
    assert!(*force < 0.5 && *time > 0.0, "{found:?}");
}

#[test]
fn a_tighter_tolerance_costs_steps_and_gives_digits() {
    let path = scene("oh2005/spectrum_4500rpm_exact");
    let found = accuracy_and_time::errors(&path, &[1e-5, 1e-8, 1e-11]).unwrap();
    assert!(found.windows(2).all(|pair| pair[1].1 < 0.1 * pair[0].1 && pair[1].2 > pair[0].2), "{found:?}");
    assert!(found[2].1 < 1e-8, "{found:?}");
}

#[test]
fn an_undamped_pair_is_unstable_near_twice_its_natural_frequency() {
    let mids = natural_frequencies::cells(&scene("oh2005/energy_300rpm"), &[1.0]).unwrap();
    // The first instability: mesh frequency at twice the natural frequency; 24 teeth.
    let speed = 60.0 * 2.0 * mids[0].modes[1].natural / 24.0;
    let found = stability::unstable(&scene("oh2005/energy_300rpm"), &[0.2 * speed, speed]).unwrap();
    assert!(found.contains(&speed), "{found:?}, expected {speed} rpm");
}

#[test]
fn a_response_goes_up_and_down_over_its_axis() {
    let response = response_curve::curve(&scene("response"), "start.speed=5000 rpm:5100 rpm:3").unwrap();
    let ways: Vec<_> = response.points.iter().map(|point| point.upward).collect();
    assert_eq!(ways, [true, true, true, false, false, false]);
    for (point, rpm) in response.points.iter().zip([5000.0, 5050.0, 5100.0, 5100.0, 5050.0, 5000.0]) {
        // The torques are in balance, so that the speed stays.
        assert!((point.speed / (rpm * TAU / 60.0) - 1.0).abs() < 0.01, "{} rad/s at {rpm} rpm", point.speed);
        assert!(point.observed[0].unwrap().rms > 0.0);
    }
}

#[test]
fn write_a_table_writes_the_same_rows_twice_and_a_plot() {
    let out = tempfile::tempdir().unwrap();
    let files = write_a_table::write(&scene("backlash"), out.path()).unwrap();
    let names: Vec<_> = files.iter().map(|file| file.strip_prefix(out.path()).unwrap().to_str().unwrap()).collect();
    assert_eq!(
        names,
        ["trajectory.parquet", "trajectory.csv", "motion.svg", "motion.png", "lines.csv", "summary.json"]
    );
    let (table, provenance) = parquet::read(&out.path().join("trajectory.parquet")).unwrap();
    assert!(provenance.contains(&("scene".to_string(), "backlash".to_string())), "{provenance:?}");
    let csv = std::fs::read_to_string(out.path().join("trajectory.csv")).unwrap();
    assert_eq!(csv.lines().count(), table.rows() + 1);
    let last = csv.lines().last().unwrap().split(',').next().unwrap();
    assert_eq!(last.parse::<f64>().unwrap(), *table.numbers("t").unwrap().last().unwrap());
}

#[test]
fn the_examples_are_as_many_and_as_short_as_the_readme_says() {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/..");
    let files: Vec<_> =
        std::fs::read_dir(format!("{root}/gearsim/examples")).unwrap().map(|f| f.unwrap().path()).collect();
    let readme = std::fs::read_to_string(format!("{root}/README.md")).unwrap();
    assert!(files.len() == 11 && readme.contains("Eleven programs of less than 40 lines"), "{} examples", files.len());
    for file in files {
        let text = std::fs::read_to_string(&file).unwrap();
        assert!(text.lines().count() < 40, "{} has {} lines", file.display(), text.lines().count());
        let name = file.file_stem().unwrap().to_str().unwrap();
        assert!(include_str!("examples.rs").contains(&format!("\nmod {name};")), "{name} is not tested");
        let shown = include_str!("../../gearsim/src/examples.rs").contains(&format!("examples/{name}.rs"));
        assert!(shown, "{name} is not in the documentation");
    }
}
