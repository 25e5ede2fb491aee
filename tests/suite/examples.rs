//! The examples of the library, gearsim/examples: each runs, and what it computes is right.

#[path = "../../gearsim/examples/natural_frequencies.rs"]
#[allow(dead_code)] // `main` is not called
mod natural_frequencies;
#[path = "../../gearsim/examples/run_a_scene.rs"]
#[allow(dead_code)]
mod run_a_scene;
#[path = "../../gearsim/examples/spectrum.rs"]
#[allow(dead_code)]
mod spectrum;
#[path = "../../gearsim/examples/vary_a_parameter.rs"]
#[allow(dead_code)]
mod vary_a_parameter;
#[path = "../../gearsim/examples/write_a_table.rs"]
#[allow(dead_code)]
mod write_a_table;

use std::f64::consts::TAU;

use gearsim::output::parquet;
use gearsim_tests::oh2005::GearPair;

/// The path of a scene under models/scenes.
fn scene(name: &str) -> String {
    format!("{}/../models/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn run_a_scene_conserves_energy_and_holds_the_speed() {
    let outcome = run_a_scene::run(&scene("two_stage")).unwrap();
    let run = &outcome.trajectory;
    assert!(run.residual[run.len() - 1].abs() < 1e-9 * run.largest_energy());
    // 1500 rpm of the 21 teeth, with torques in balance: the speed of the pitch angle vibrates about 21 times 157 rad/s.
    let [slow, fast] = run_a_scene::range(&run.q_dot[0]);
    let speed = 21.0 * 1500.0 * TAU / 60.0;
    assert!(slow < speed && speed < fast && fast - slow < 0.5 * speed, "{slow} to {fast}");
    // Tooth force: 95 N m on a base radius of 24.7 mm; mesh stiffness from 250 to 400 MN/m.
    let [low, high] = run_a_scene::range(&run.q[1]);
    let force = 95.0 / 24.7e-3;
    assert!(low < force / 250e6 && force / 400e6 < high, "{low} to {high}");
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
    let cells = natural_frequencies::cells(&scene("oh2005/spectrum_4500rpm_exact")).unwrap();
    assert_eq!(cells.len(), 2);
    for (cell, k) in cells.iter().zip([pair.k1, pair.k2]) {
        assert_eq!(cell.levels, [k]);
        let [rigid, elastic] = &cell.modes[..] else { panic!("{} modes", cell.modes.len()) };
        assert_eq!((rigid.natural, rigid.zeta), (0.0, None));
        let expected = (pair.m2() * k).sqrt() / TAU;
        assert!((elastic.natural / expected - 1.0).abs() < 1e-12, "{} Hz, expected {expected} Hz", elastic.natural);
    }
}

#[test]
fn write_a_table_writes_the_same_rows_twice_and_a_plot() {
    let out = tempfile::tempdir().unwrap();
    let folder = write_a_table::write(&scene("backlash"), out.path()).unwrap();
    assert_eq!(folder.files(), ["trajectory.csv", "trajectory.parquet", "motion.svg"]);
    let (table, provenance) = parquet::read(&out.path().join("trajectory.parquet")).unwrap();
    assert_eq!(provenance[0], ("scene".to_string(), "backlash".to_string()));
    let csv = std::fs::read_to_string(out.path().join("trajectory.csv")).unwrap();
    assert_eq!(csv.lines().count(), table.rows() + 1);
    let last = csv.lines().last().unwrap().split(',').next().unwrap();
    assert_eq!(last.parse::<f64>().unwrap(), *table.numbers("t").unwrap().last().unwrap());
    assert!(std::fs::read_to_string(out.path().join("motion.svg")).unwrap().contains("<svg"));
}
