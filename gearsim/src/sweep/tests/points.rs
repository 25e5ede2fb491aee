//! Tests of the points of a sweep: their values, their order, and that the row of a point equals a single run with its values.

use super::{load, request};
use crate::analysis::dynamic_factor;
use crate::known::MODELS;
use crate::run::Outcome;
use crate::scene::Scene;
use crate::sweep::row::Status;
use crate::sweep::{Design, Plan, Request, Sweep};

fn plan(vary: &[&str], samples: Option<usize>) -> Plan {
    load(&Request { samples, seed: 3, ..request(vary) }).unwrap_or_else(|e| panic!("{vary:?}: {e}")).plan
}

fn points(plan: &Plan) -> Vec<String> {
    (0..plan.points().unwrap()).map(|i| plan.values(i).join(" | ")).collect()
}

#[test]
fn the_last_axis_varies_fastest() {
    let grid = plan(&["parameters.T0=1 N*m:3 N*m:3", "start.speed=100 rpm,200 rpm"], None);
    let expected = [
        "1 N*m | 100 rpm",
        "1 N*m | 200 rpm",
        "2 N*m | 100 rpm",
        "2 N*m | 200 rpm",
        "3 N*m | 100 rpm",
        "3 N*m | 200 rpm",
    ];
    assert_eq!(points(&grid), expected);
}

#[test]
fn values_are_written_as_in_a_scene_file() {
    let cases: [(&str, &str); 9] = [
        ("parameters.zeta=0.1:0.5:5", "0.1 0.2 0.3 0.4 0.5"),
        ("parameters.T0=3 N*m:1 N*m:3", "3 N*m 2 N*m 1 N*m"),
        ("parameters.T0=log:1 N*m:1000 N*m:4", "1 N*m 10 N*m 100 N*m 1000 N*m"),
        ("start.speed=100 rpm:300 rpm:3", "100 rpm 200 rpm 300 rpm"),
        ("start.speed=0:300 rpm:2", "0 rpm 300 rpm"),
        ("parameters.T0=1 kN*m:2000 N*m:3", "1000 kg*m^2/s^2 1500 kg*m^2/s^2 2000 kg*m^2/s^2"),
        ("parameters.T0=1 N*m, 2 kN*cm ,0", "1 N*m 2 kN*cm 0"),
        ("start.phi=static,0.01 rad", "static 0.01 rad"),
        ("effects=[\"damping\"],[\"damping\",\"torques\"]", "[\"damping\"] [\"damping\",\"torques\"]"),
    ];
    for (text, expected) in cases {
        assert_eq!(points(&plan(&[text], None)).join(" "), expected, "{text}");
    }
}

#[test]
fn random_points_depend_on_seed_and_number_alone() {
    let axes =
        ["start.speed=uniform:100 rpm:300 rpm", "parameters.zeta=0.1,0.2", "parameters.T0=log-uniform:1 N*m:100 N*m"];
    let few = plan(&axes, Some(50));
    assert_eq!(few.points(), Some(100));
    let values: Vec<Vec<String>> = (0..100).map(|i| few.values(i)).collect();
    // The grid varies more slowly than the samples.
    assert!(values[..50].iter().all(|v| v[1] == "0.1") && values[50..].iter().all(|v| v[1] == "0.2"));
    for v in &values {
        let (speed, torque) = (crate::sweep::axis::number(&v[0]), crate::sweep::axis::number(&v[2]));
        assert!((100.0..=300.0).contains(&speed) && (1.0..=100.0).contains(&torque), "{v:?}");
    }
    let mut distinct = values.clone();
    distinct.sort();
    distinct.dedup();
    assert_eq!(distinct.len(), 100);
    let below_ten = values.iter().filter(|v| crate::sweep::axis::number(&v[2]) < 10.0).count();
    // Half of the values on a logarithmic scale; the bounds are five standard deviations of 100 coin tosses.
    assert!((25..=75).contains(&below_ten), "{below_ten}");
    assert_eq!(plan(&axes, Some(200)).values(20), few.values(20));
    assert_ne!(Plan::new(few.axes.clone(), Design::Random, 50, 4).values(20), few.values(20));
}

/// The row of a point is bit-identical to a single run with the same values set by `--set`.
#[test]
fn a_point_equals_a_single_run_with_its_values() {
    let request = request(&["parameters.T0=1 N*m:9 N*m:7", "start.speed=log:100 rpm:500 rpm:5"]);
    let sweep = load(&request).unwrap();
    for point in [0, 17, 34] {
        let row = sweep.point(point);
        let overrides = [request.overrides.clone(), sweep.plan.overrides(point)].concat();
        let scene = Scene::load_with(&super::scene(), &overrides, &[MODELS[0].model]).unwrap();
        let outcome: Outcome = MODELS[0].run(&scene, &mut |_| {}).unwrap();
        assert_eq!(row.status, Status::Done);
        let column = |name: &str| row.numbers[sweep.columns().iter().position(|(n, _)| n == name).unwrap()];
        let run = &outcome.trajectory;
        let last = |v: &Vec<f64>| v[v.len() - 1].to_bits();
        assert_eq!(column("phi").to_bits(), last(&run.q[1]));
        assert_eq!(column("theta_dot").to_bits(), last(&run.q_dot[0]));
        assert_eq!(column("dissipated").to_bits(), last(&run.dissipated));
        assert_eq!(column("residual").to_bits(), last(&run.residual));
        assert_eq!(column("cell_changes"), outcome.counts.cell_changes as f64);
        let greatest = run.q[1].iter().copied().fold(f64::MIN, f64::max);
        assert_eq!(column("phi_max").to_bits(), greatest.to_bits());
    }
}

/// A sweep without --from begins its statistics at `output.from` of the scene. A run does the same.
#[test]
fn statistics_begin_where_the_scene_says() {
    let all = request(&["start.speed=300 rpm,310 rpm"]);
    let overrides = vec!["output.from=10 ms".to_owned()];
    let request = |from| Request { from, record: vec!["extremes".into()], overrides: overrides.clone(), ..all.clone() };
    let [own, same, whole] = [None, Some(0.01), Some(0.0)].map(|from| load(&request(from)).unwrap().point(0).numbers);
    assert_eq!(own, same);
    assert_ne!(own, whole);
}

/// The times of the first reflection in models/scenes/oh2005/README.md, "Loss of speed", which other code computed.
#[test]
fn the_first_reflection_is_at_the_time_given_in_the_readme_of_the_paper_scenes() {
    let path = super::scene().with_file_name("spectrum_600rpm_exact.toml");
    let all = request(&["parameters.T0=30 N*m,50 N*m"]);
    let request = Request { overrides: vec!["run.t_end=1.6 s".into()], record: vec!["events".into()], ..all };
    let sweep = crate::sweep::Sweep::load(&path, MODELS, &request).unwrap();
    let column = sweep.columns().iter().position(|(name, _)| name == "first_reflection").unwrap();
    // The README gives three digits.
    for (point, t, half_digit) in [(0, 1.50, 0.005), (1, 0.469, 0.0005)] {
        let found = sweep.point(point).numbers[column];
        assert!((found - t).abs() <= half_digit, "{found} s");
    }
}

/// If no samples are recorded, points run side by side. They have the same events, and states that differ by rounding errors, which
/// these motions amplify by a factor of about 1e4.
#[test]
fn the_recorded_groups_do_not_change_the_motion() {
    let all = request(&["parameters.T0=1 N*m:50 N*m:4"]);
    let few = Request { record: vec!["state".into(), "energy".into()], ..all.clone() };
    let (all, few) = (load(&all).unwrap(), load(&few).unwrap());
    let events = all.columns().iter().position(|(name, _)| name == "theta").unwrap();
    for point in 0..4 {
        let (a, b) = (all.point(point).numbers, few.point(point).numbers);
        let close = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-10 * (a.abs() + 1.0);
        assert!(a[events..events + b.len()].iter().zip(&b).all(close), "{a:?} {b:?}");
    }
}

/// A point can fail in several ways; each gives a row with the reason.
#[test]
fn a_failing_point_is_a_row_with_its_reason() {
    let cases = [
        // The mass matrix is singular.
        ("parameters.I1=2890 kg*mm^2,1e-300 kg*m^2", Status::Refused, "mass matrix"),
        ("start.phi_dot=1 rad/s,1e307 rad/s", Status::Refused, "beyond the range of floating-point numbers"),
        // Valid values, but events follow one another without end.
        ("parameters.T0=10 N*m,1e160 N*m", Status::Stopped, "followed one another"),
    ];
    for (axis, status, reason) in cases {
        let sweep = load(&request(&[axis])).unwrap();
        let (good, bad) = (sweep.point(0), sweep.point(1));
        assert_eq!((good.status, good.reason.as_str()), (Status::Done, ""), "{axis}");
        assert_eq!(bad.status, status, "{axis}: {}", bad.reason);
        assert!(bad.reason.contains(reason), "{axis}: {}", bad.reason);
        assert_eq!(bad.numbers.len(), good.numbers.len());
    }
    // Each width is valid alone, but together the widths must leave a part of the pitch: the last combination does not.
    let widths =
        ["laws.k.steps=[{value=\"1 kN*m\",width=\"1 rad\"},{value=\"2 kN*m\",width=\"2 rad\"},{value=\"1 kN*m\"}]"];
    let mut two = request(&["laws.k.steps.0.width=1 rad:4 rad:2", "laws.k.steps.1.width=2 rad:4 rad:2"]);
    two.overrides.extend(widths.map(Into::into));
    let sweep = load(&two).unwrap();
    let status: Vec<_> = (0..4).map(|point| sweep.point(point).status).collect();
    assert_eq!(status, [Status::Done, Status::Done, Status::Done, Status::Refused]);
    assert!(sweep.point(3).reason.contains("leaves nothing of the pitch"), "{}", sweep.point(3).reason);
}

#[test]
fn dynamic_factors_are_those_of_single_runs_from_the_time_of_the_sweep_on() {
    let path = super::scene().with_file_name("../two_stage.toml");
    let from = 0.01;
    let request = Request {
        vary: vec!["start.speed=500 rpm,900 rpm".into()],
        overrides: vec!["run.t_end=0.03 s".into()],
        record: vec!["meshes".into()],
        from: Some(from),
        ..Request::default()
    };
    let sweep = Sweep::load(&path, MODELS, &request).unwrap_or_else(|error| panic!("{error}"));
    let names: Vec<String> = sweep.columns().into_iter().map(|(name, _)| name).collect();
    let of_mesh = ["dynamic_factor", "kv_iso6336", "pulling_share", "largest_pull"];
    assert_eq!(names, ["k12", "k34"].map(|law| of_mesh.map(|name| format!("{law}_{name}"))).concat());
    let scene = sweep.first().unwrap();
    let alone = sweep.entry.run(&scene, &mut |_| {}).unwrap();
    let expected = dynamic_factor::of(&scene, &sweep.entry, &alone.trajectory, from);
    let row = sweep.point(0).numbers;
    for (mesh, values) in expected.iter().zip(row.chunks(4)) {
        assert_eq!(mesh.factor.clone().unwrap(), values[0], "{}", mesh.law.name);
        assert_eq!(mesh.iso6336.clone().unwrap_or(f64::NAN).to_bits(), values[1].to_bits(), "{}", mesh.law.name);
        let pulling = mesh.pulling.unwrap();
        assert_eq!([pulling.share, pulling.largest], values[2..], "{}", mesh.law.name);
    }
    assert!(row[0] > 1.0 && sweep.point(1).numbers[0] != row[0]);
}

/// The group `outputs` has columns for the outputs that at least one point records. Outputs whose effect no point has get no columns.
#[test]
fn outputs_without_their_effect_have_no_columns() {
    let columns = |vary: &[&str], set: &[&str]| {
        let mut request = Request { record: vec!["outputs".into()], ..request(vary) };
        request.overrides.extend(set.iter().map(|text| text.to_string()));
        let columns = load(&request).unwrap().columns();
        columns.iter().filter_map(|(name, _)| Some(name.strip_suffix("_max")?.to_string())).collect::<Vec<_>>()
    };
    let zeta = ["parameters.zeta=0.05,0.1"];
    let of_scene = columns(&zeta, &[]);
    assert!(of_scene.iter().any(|name| name == "mesh_torque") && of_scene.iter().all(|name| !name.contains("fan")));
    assert_eq!(columns(&zeta, &["output.record=[\"dte\"]"]), ["dte"]);
    let effects = "effects=[\"stiffness_step\"],[\"stiffness_step\", \"fan_load\"]";
    let varied =
        columns(&[effects], &["parameters.cf_load=1 N*m*s^2/rad^2", "output.record=[\"dte\", \"power_fan_load\"]"]);
    assert_eq!(varied, ["dte", "power_fan_load"]);
}
