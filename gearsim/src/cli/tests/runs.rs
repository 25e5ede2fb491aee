//! Tests of the files that commands write, and of their refusals.

use std::path::Path;

use super::{go, scene};
use crate::cli::compare::Compare;
use crate::cli::failure::Failure;
use crate::cli::floquet::FloquetCommand;
use crate::cli::modes::Modes;
use crate::cli::report;
use crate::cli::run::Run;
use crate::engine::Stop;
use crate::output::{Summary, parquet};
use crate::scene::Scene;

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn a_run_writes_its_files_with_their_provenance() {
    let root = tempfile::tempdir().unwrap();
    let out = root.path().join("a/b");
    go::<Run>(&out, &["--csv", "-q", "--set", "output.plots=[\"energy\"]"]).unwrap();
    assert_eq!(
        names(&out),
        ["energy.png", "energy.svg", "lines.csv", "summary.json", "trajectory.csv", "trajectory.parquet"]
    );

    let text = std::fs::read_to_string(out.join("summary.json")).unwrap();
    let summary: Summary = serde_json::from_str(&text).unwrap();
    assert!(summary.completed && summary.cell_changes > 0);
    assert_eq!(summary.provenance.overrides, ["output.plots=[\"energy\"]"]);
    assert_eq!(summary.files.len(), 5);
    assert_eq!(summary.rows.samples + summary.rows.at_events, table_rows(&out));
    assert!(summary.rows.at_events >= 2 * summary.cell_changes);
    let (table, pairs) = parquet::read(&out.join("trajectory.parquet")).unwrap();
    assert!(table.rows() > 2000);
    let hash = pairs.iter().find(|(name, _)| name == "scene_sha256").map(|(_, value)| value);
    assert_eq!(hash, Some(&summary.provenance.scene_sha256));
}

/// Rows of the trajectory in a folder.
fn table_rows(folder: &Path) -> u64 {
    parquet::read(&folder.join("trajectory.parquet")).unwrap().0.rows() as u64
}

#[test]
fn sounds_and_load_spectra_are_files_of_their_own() {
    let root = tempfile::tempdir().unwrap();
    let rainflow = ["--set", "output.rainflow=[\"mesh_torque\"]"];
    let few = ["--set", "output.plots=[\"rainflow\", \"load_duration\"]"];
    let sound = ["--sound", "mesh_torque", "--stretch", "10"];
    go::<Run>(root.path(), &[&["-q"], &rainflow[..], &few, &sound].concat()).unwrap();
    let expected = ["lines.csv", "load_duration_mesh_torque.csv", "rainflow.svg", "rainflow_mesh_torque.csv"];
    let names = names(root.path());
    assert!(expected.iter().all(|name| names.iter().any(|found| found == name)), "{names:?}");
    let summary: Summary =
        serde_json::from_str(&std::fs::read_to_string(root.path().join("summary.json")).unwrap()).unwrap();
    let sound = &summary.sounds["mesh_torque"];
    assert!(sound.full_scale.0 > 0.0 && sound.stretch.0 == 10.0);
    let wav = hound::WavReader::open(root.path().join(&sound.file)).unwrap();
    // 0.1 s at 48 kHz, ten times as slow, with both ends.
    assert_eq!((wav.spec().sample_rate, wav.duration()), (48_000, 48_001));
    let largest = &summary.load_spectra["mesh_torque"];
    let torque = &summary.outputs["mesh_torque"];
    assert!((largest.largest_range.0 / (torque.max.0 - torque.min.0) - 1.0).abs() < 1e-12);
    let lines = std::fs::read_to_string(root.path().join("lines.csv")).unwrap();
    assert!(
        lines.starts_with(
            "signal,mesh,harmonic,rotor,sideband,order_of_rotor_speed_1,frequency [Hz],peak_amplitude,unit"
        )
    );
}

#[test]
fn a_plot_that_cannot_be_drawn_does_not_fail_the_run() {
    let root = tempfile::tempdir().unwrap();
    go::<Run>(root.path(), &["-q", "--set", "output.rate=20 Hz"]).unwrap();
    assert!(names(root.path()).contains(&"energy.png".into()));
    assert!(!names(root.path()).contains(&"spectrum.png".into()));
}

/// Time steps too long for the vibration create energy. The results are written, and the command fails.
#[test]
fn a_run_whose_energy_account_does_not_close_is_a_failure() {
    let root = tempfile::tempdir().unwrap();
    let coarse = ["run.method=rk4", "run.step=0.2 ms", "run.t_end=20 ms"].map(|set| ["--set", set]);
    let failure = go::<Run>(root.path(), &[&["-q"], &coarse.concat()[..]].concat()).unwrap_err();
    assert!(matches!(failure, Failure::Refuted { .. }), "{failure}");
    assert_eq!(failure.code(), 3);
    assert!(failure.to_string().contains("unaccounted for") && failure.to_string().contains("run.step"), "{failure}");
    assert!(names(root.path()).contains(&"summary.json".into()));
}

/// If the energy account refutes a run, the report must not say that the account holds.
#[test]
fn a_report_of_a_refuted_run_does_not_say_that_the_account_holds() {
    let scene = Scene::load(scene()).unwrap();
    let results = scene
        .with_all([("run.method", "rk4"), ("run.step", "0.2 ms")].map(|(key, value)| (key, value.into())))
        .unwrap()
        .run()
        .unwrap();
    let text = report::run(&results.scene, &results.summary(), results.trajectory().len(), 500);
    assert!(text.contains("none from t = ") && text.contains("wrong result"), "{text}");
    assert!(!text.contains("account still holds"), "{text}");
}

/// The rows recorded until the limit are written, and the message says what to do.
#[test]
fn a_run_stops_when_the_row_limit_is_reached() {
    let root = tempfile::tempdir().unwrap();
    let sets = ["output.most_rows=50", "output.rate=200 Hz"].map(|set| ["--set", set]);
    let failure = go::<Run>(root.path(), &[&["-q"], &sets.concat()[..]].concat()).unwrap_err();
    assert!(matches!(&failure, Failure::Stopped { stop, .. } if matches!(**stop, Stop::Rows { .. })), "{failure}");
    assert!(failure.to_string().contains("output.events = false"), "{failure}");
    let (table, _) = parquet::read(&root.path().join("trajectory.parquet")).unwrap();
    assert!((50..60).contains(&table.rows()), "{}", table.rows());
}

#[test]
fn a_refused_command_writes_nothing() {
    let root = tempfile::tempdir().unwrap();
    let out = root.path().join("out");
    for wrong in ["parameters.T1=3", "parameters.I1=1e-300", "effects=[\"frozen_phase\"]", "t_end"] {
        let failure = go::<Run>(&out, &["-q", "--set", wrong]).unwrap_err();
        assert_eq!(failure.code(), 2, "{wrong}: {failure}");
        let failure = go::<Compare>(&out, &["--set", wrong]).unwrap_err();
        assert_eq!(failure.code(), 2, "{wrong}: {failure}");
    }
    assert_eq!(go::<Run>(&out, &["--nonsense"]).unwrap_err().code(), 2);
    assert!(names(root.path()).is_empty());
}

#[test]
fn a_folder_that_cannot_be_written_is_an_error_before_the_run() {
    let file = tempfile::NamedTempFile::new().unwrap();
    for out in [file.path().to_owned(), file.path().join("below")] {
        let failure = go::<Run>(&out, &["-q"]).unwrap_err();
        assert_eq!(failure.code(), 1);
        assert!(failure.to_string().contains("choose another"), "{failure}");
    }
}

#[test]
fn a_comparison_writes_three_runs_and_their_plots() {
    let root = tempfile::tempdir().unwrap();
    go::<Compare>(root.path(), &["--set", "output.plots=[\"energy\"]"]).unwrap();
    let expected = "compare.json energy.png energy.svg outputs.png outputs.svg trajectory_classical.parquet trajectory_exact.parquet \
                    trajectory_rigid_kinematic.parquet";
    assert_eq!(names(root.path()).join(" "), expected);
    let json: serde_json::Value =
        serde_json::from_slice(&std::fs::read(root.path().join("compare.json")).unwrap()).unwrap();
    let residual = |i: usize| json["runs"][i]["summary"]["energy"]["residual"].as_f64().unwrap();
    assert!(residual(0).abs() < 1e-12 && residual(1) > 0.1 && residual(2) > 0.1);
}

#[test]
fn a_run_that_stopped_early_has_exit_code_3() {
    let stop = Box::new(Stop::Search { t: 0.1, steps: 7, state: "q = [0]".into(), cell: 1.into() });
    let failure = Failure::Stopped { run: "scene x".into(), stop, folder: "out/x".into() };
    assert_eq!(failure.code(), 3);
    let text = failure.to_string();
    assert!(text.contains("scene x stopped early: at t = 0.1 s") && text.contains("out/x"), "{text}");
}

#[test]
fn modes_and_floquet_write_their_results_and_plots() {
    let root = tempfile::tempdir().unwrap();
    let json = |file: &str| -> serde_json::Value {
        serde_json::from_slice(&std::fs::read(root.path().join(file)).unwrap()).unwrap()
    };
    go::<Modes>(root.path(), &["--cell", "1"]).unwrap();
    let modes = json("modes.json");
    assert_eq!(modes["chosen"]["levels"][0], 2780.0);
    // sqrt(M2 k)/2 pi of the gear pair.
    let m2 = 0.5 * (24f64.powi(2) / 2.89e-3 + 96f64.powi(2) / 0.7402);
    let expected = (m2 * 2780.0).sqrt() / std::f64::consts::TAU;
    let found = modes["chosen"]["modes"][1]["natural_frequency"].as_f64().unwrap();
    assert!((found / expected - 1.0).abs() < 1e-14, "{found}, not {expected}");
    go::<FloquetCommand>(root.path(), &["--vary", "start.speed=4000 rpm:14000 rpm:9"]).unwrap();
    assert_eq!(json("floquet.json")["verdict"], "stable");
    let expected = "campbell.png campbell.svg floquet.json modes.json shapes.png shapes.svg stability.csv stability.png \
                    stability.svg";
    assert_eq!(names(root.path()).join(" "), expected);
    for wrong in [["--cell", "2"], ["--cell", "0,1"]] {
        assert_eq!(go::<Modes>(root.path(), &wrong).unwrap_err().code(), 2);
    }
    for wrong in [
        "start.speed=3 rpm",
        "start.sped=1 rpm:2 rpm:3",
        "start.speed=3 rpm:1 rpm:3",
        "start.speed=uniform:1 rpm:2 rpm",
    ] {
        assert_eq!(go::<FloquetCommand>(root.path(), &["--vary", wrong]).unwrap_err().code(), 2, "{wrong}");
    }
}
