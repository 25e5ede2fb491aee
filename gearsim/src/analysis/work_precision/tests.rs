//! Tests of tables and words with curves made by hand, and of the measurements of scenes.

use std::path::Path;

use super::ladder::Kind;
use super::table::{self, Price};
use super::{By, Errors, MeasuredFamily, MeasuredSetting, Scenes, WorkPrecision, error};
use crate::known::MODELS;
use crate::model::{Coordinate, Model, Start};
use crate::output::fixture;
use crate::scene::Scene;
use crate::tolerance::analysis::AT_REST;
use crate::trajectory::{Moment, Trajectory};

fn point(error: f64, seconds: f64, right_events: bool) -> MeasuredSetting {
    let errors = Errors { end: error, path: error, times: None, events: i64::from(!right_events), energy: error };
    MeasuredSetting {
        setting: "s".into(),
        seconds: (seconds, seconds),
        evaluations: 1,
        steps: 1,
        events: 1,
        errors: Ok(errors),
        right_events,
        tried: true,
    }
}

fn curve(label: &'static str, kind: Kind, points: &[(f64, f64, bool)]) -> MeasuredFamily {
    MeasuredFamily { label, kind, points: points.iter().map(|&(e, t, right)| point(e, t, right)).collect() }
}

/// Between an error of 1e-4 at 1 ms and 1e-8 at 100 ms, an error of 1e-6 takes 10 ms.
#[test]
fn times_at_an_error_are_interpolated_logarithmically() {
    let c = curve("m", Kind::Method, &[(1e-4, 1e-3, true), (1e-8, 0.1, true)]);
    let Price::Seconds(seconds) = c.price(1e-6, 1e-13) else { panic!("a price") };
    assert!((seconds - 0.01).abs() < 1e-12);
    assert_eq!(c.price(1e-3, 1e-13), Price::Seconds(1e-3));
    assert_eq!(c.price(1e-9, 1e-13), Price::Never);
    assert_eq!(c.price(1e-14, 1e-13), Price::Unknown);
    // A setting with other events than the reference is not used.
    let c = curve("m", Kind::Method, &[(1e-4, 1e-5, false), (1e-8, 0.1, true)]);
    assert_eq!((c.price(1e-3, 0.0), c.failures()), (Price::Seconds(0.1), 1));
}

#[test]
fn the_text_states_the_measurements() {
    let curves = vec![
        curve("exact cells", Kind::Method, &[(0.0, 3e-4, true)]),
        curve("steps", Kind::Method, &[(1e-4, 1e-3, true), (1e-8, 0.1, true)]),
        curve("classical equations", Kind::Equations, &[(0.04, 1e-4, true)]),
    ];
    let reference = By::Compensated;
    let measured = WorkPrecision { scene: "x".into(), events: 9, reference, floor: 1e-12, curves };
    let words = table::words(&measured);
    assert_eq!(
        words,
        "Exact cells cost 300 µs for an error of 1e-12. With time steps, an error of 1e-6 costs at least 10 ms (steps). No method \
         with time steps reaches an error of 1e-9. The classical equations cost 100 µs and are wrong by 4.0 %."
    );
    let text = table::markdown(&measured);
    assert!(text.contains("never"), "{text}");
    assert_eq!(table::csv(&measured).lines().count(), 5);
}

fn measured(scene: &str, overrides: &[&str]) -> WorkPrecision {
    let models: Vec<&'static Model> = MODELS.iter().map(|m| m.model).collect();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes").join(scene).with_extension("toml");
    let overrides: Vec<String> = overrides.iter().map(|set| set.to_string()).collect();
    let exact = Scene::load_with(&path, &overrides, &models).unwrap_or_else(|e| panic!("{}", e.render(100, false)));
    let entry = MODELS.iter().find(|m| m.model.name == exact.model.name).unwrap();
    let run = |scene: &Scene| entry.run(scene, &mut |_| {});
    super::measure(&Scenes { exact, cheaper: vec![] }, &run, 1, &mut |_| {}).unwrap()
}

/// Only steps of the stiffness are compared as events. Flanks that part or meet are not, because methods record them differently.
#[test]
fn errors_of_a_scene_with_play() {
    let measured = measured("backlash", &["run.t_end=6 ms"]);
    assert_eq!(measured.reference, By::Compensated);
    assert!(measured.events > 20 && measured.floor < 1e-10, "{} {}", measured.events, measured.floor);
    for curve in measured.curves.iter().filter(|curve| curve.label.contains("order")) {
        // At a tolerance of 1e-3 or 1e-4, a step and a flank may be met in the wrong order.
        let failed: Vec<_> = curve.points[2..].iter().filter(|point| point.failed()).collect();
        assert!(failed.is_empty(), "{}: {failed:?}", curve.label);
        let last = curve.points.last().unwrap();
        assert!(last.error().unwrap() < 1e-8, "{}: {last:?}", curve.label);
    }
}

/// Without exact cells, two numerical methods give the reference.
#[test]
fn errors_of_a_scene_without_exact_cells() {
    let measured = measured("drives/fan_run_up", &["run.t_end=0.03 s"]);
    assert!(matches!(&measured.reference, By::Steps(why) if why.contains("induction")), "{:?}", measured.reference);
    assert!(measured.floor < 1e-9, "{:e}", measured.floor);
    assert!(measured.curves.iter().all(|curve| !curve.label.contains("exact")));
    let words = table::words(&measured);
    assert!(
        words.starts_with(
            "Cells are not linear here: there is no exact solution. With time steps, an error of 1e-6 costs at least"
        ),
        "{words}"
    );
}

/// The paper's gear pair over at least four steps: the errors of methods fall with finer settings, those of ramps in proportion to
/// their width; those of the approximate equations do not fall.
#[test]
fn errors_of_a_scene() {
    let scene = |effects: &str| {
        let text = format!(
            r#"model = "gear_pair"
            effects = [{effects}]
            parameters = {{ I1 = "2890 kg*mm^2", I2 = "740200 kg*mm^2", zeta = 0.05, T0 = "10 N*m" }}
            laws.k.steps = [{{ value = "1.43 kN*m", width = "1.73 rad" }}, {{ value = "2.78 kN*m" }}]
            start.speed = "600 rpm"
            run.t_end = "0.01 s""#
        );
        let models: Vec<&'static Model> = MODELS.iter().map(|m| m.model).collect();
        Scene::parse("test", "test", &text, &[], &models).unwrap_or_else(|e| panic!("{}", e.render(100, false)))
    };
    let exact = scene(r#""stiffness_step", "damping", "torques""#);
    let rigid = scene(r#""stiffness_step", "rigid_kinematics", "damping", "torques""#);
    let scenes = Scenes { exact, cheaper: vec![("rigid", rigid)] };
    let run = |scene: &Scene| MODELS.iter().find(|m| m.model.name == "gear_pair").unwrap().run(scene, &mut |_| {});
    let measured = super::measure(&scenes, &run, 1, &mut |_| {}).unwrap();
    let of = |name: &str| {
        let curve = measured.curves.iter().find(|curve| curve.label.contains(name)).unwrap();
        curve.points.iter().map(|point| point.error().unwrap()).collect::<Vec<f64>>()
    };
    assert!(measured.events >= 4 && measured.floor < 1e-11, "{} {}", measured.events, measured.floor);
    assert!(measured.curves.iter().all(|curve| curve.failures() == 0));
    for (name, reached) in [("dopri5", 1e-9), ("dop853", 1e-9), ("radau", 1e-9), ("located", 1e-8)] {
        let errors = of(name);
        assert!(errors.len() >= 8 && errors.iter().any(|e| *e < reached), "{name}: {errors:?}");
    }
    // The error of ramps falls in proportion to their width, except for the widest, for which higher orders matter.
    let ramps = of("ramps");
    assert!(ramps[2..5].windows(2).all(|e| (8.0..12.5).contains(&(e[0] / e[1]))), "{ramps:?}");
    let (grid, rigid) = (of("ignored"), of("rigid"));
    assert!(grid[10] < 0.1 * grid[0] && grid[10] > 1e-6, "{grid:?}");
    assert!(rigid[0] > 1e-3, "{rigid:?}");
    // The diagram and the CSV file can be made from the measurements.
    assert!(crate::plot::work_precision::draw(&measured).svg().unwrap().contains("exact cells"));
    assert!(table::csv(&measured).lines().count() > 60);
}

/// A rotor of 2 kg m^2 turns at 3 rad/s for 2 s, and a mass of 0.5 kg is at rest except for rounding errors. With all the energy, 9 J, the
/// mass would move at 6 m/s and cover 12 m.
#[test]
fn sizes_at_rest_follow_from_the_energy_of_the_run() {
    let [rotor, mass] = [("theta", "rad"), ("x", "m")];
    let coordinate = |(name, unit)| Coordinate { name, unit, doc: "", start: Start::At(0.0) };
    let model =
        Box::leak(Box::new(Model { coordinates: vec![coordinate(rotor), coordinate(mass)].leak(), ..fixture::MODEL }));
    let mut run = Trajectory::new(model, &[], &[]);
    run.inertia = vec![2.0, 0.5];
    (run.t, run.kinetic) = (vec![0.0, 2.0], vec![9.0; 2]);
    (run.q, run.q_dot) = (vec![vec![0.0, 6.0], vec![0.0, 1e-300]], vec![vec![3.0; 2], vec![0.0, 1e-300]]);
    let (q, q_dot) = error::sizes(&run);
    assert_eq!((q[0], q_dot[0]), (6.0, 3.0));
    assert!((q[1] / (12.0 * AT_REST) - 1.0).abs() < 1e-15 && (q_dot[1] / 6.0 - 1.0).abs() < 1e-15);
    // A displacement that stays is not a rounding error.
    run.q[1] = vec![1e-6; 2];
    assert_eq!(error::sizes(&run).0[1], 1e-6);
    // A slow coordinate is not at rest.
    run.q_dot[1] = vec![0.0, 1e-7];
    assert_eq!(error::sizes(&run).1[1], 1e-7);
}

/// A rotor of 2 kg m^2 turns at 3 rad/s, and a mass of 0.5 kg moves at 1 mm/s. With all the energy, 9 J, the mass would move at 6 m/s. A
/// change of its speed by 1e-15 m/s is a rounding error of this speed; a change by 1e-9 m/s is a jump.
#[test]
fn rounding_errors_of_faster_coordinates_are_no_jumps() {
    let coordinate = |(name, unit)| Coordinate { name, unit, doc: "", start: Start::At(0.0) };
    let coordinates = [("theta", "rad"), ("x", "m")].map(coordinate).to_vec().leak();
    let mut run = Trajectory::new(Box::leak(Box::new(Model { coordinates, ..fixture::MODEL })), &[], &[]);
    run.inertia = vec![2.0, 0.5];
    run.moment = vec![Moment::Before, Moment::After];
    (run.t, run.kinetic, run.strain) = (vec![1.0; 2], vec![9.0; 2], vec![0.0; 2]);
    let jumps_by = |change: f64| {
        let mut run = run.clone();
        (run.q, run.q_dot) = (vec![vec![3.0; 2], vec![1e-3; 2]], vec![vec![3.0; 2], vec![1e-3, 1e-3 + change]]);
        error::jumps(&run)
    };
    assert_eq!((jumps_by(1e-15), jumps_by(1e-9)), (vec![], vec![0]));
}
