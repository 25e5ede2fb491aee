//! Tests of response curves: against closed forms, and at speeds where two steady motions exist.

use super::*;
use crate::plot::Marker;
use crate::sweep::Status;
use crate::sweep::response::{Hold, ResponseCurve, measure};
use crate::tolerance::analysis::SPEED_NOT_HELD;

/// The response of a committed scene, its speed held by its own means.
fn response(scene: &str, over: &str, settle: f64, sets: &[&str]) -> ResponseCurve {
    held(scene, over, settle, sets, &Hold::Own).unwrap()
}

fn held(scene: &str, over: &str, settle: f64, sets: &[&str], hold: &Hold) -> Result<ResponseCurve, Error> {
    let request = Request {
        vary: vec![over.into()],
        overrides: sets.iter().map(|set| (*set).to_owned()).collect(),
        from: Some(settle),
        ..Request::default()
    };
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes").join(format!("{scene}.toml"));
    Sweep::load(&path, MODELS, &request).unwrap().response(true, hold, &mut |_| {})
}

/// One mass on a mesh of constant stiffness with the error e = E cos(w t): in the steady state the deflection x follows x'' + 2 zeta w0
/// x' + w0² (x - e) = 0, of amplitude E/((1 - r²)² + (2 zeta r)²)^(1/2) with r = w/w0. The damper acts on the rate of x.
#[test]
fn a_linear_response_is_that_of_the_closed_form_on_both_ways() {
    let (k, zeta, error) = (2e3_f64, 0.05, 1e-7);
    let mobility = (24.0_f64.powi(2) / 2890e-6 + 96.0_f64.powi(2) / 740200e-6) / 4.0;
    let w0 = (2.0 * k * mobility).sqrt();
    let rpm = |r: f64| r * w0 / 24.0 * 30.0 / std::f64::consts::PI;
    let over = format!("start.speed={:.3} rpm:{:.3} rpm:5", rpm(0.5), rpm(1.5));
    let sets = [
        "effects=[\"stiffness_step\",\"transmission_error\",\"torques\",\"damping\"]",
        "parameters.zeta=0.05",
        "parameters.T0=1e-4 N*m",
        "laws.k={steps=[{value=\"2 kN*m\"}]}",
        "laws.e={harmonics=[{order=1, amplitude=\"1e-7 rad\"}]}",
        "run.method=dop853",
        "run.tolerance=1e-9",
        // Long enough for exp(-zeta w0 t) to be negligible, and measured over many periods.
        "run.t_end=0.06 s",
        "output.rate=500 kHz",
        "output.record=[\"dte\"]",
    ];
    let response = response("oh2005/energy_300rpm", &over, 0.04, &sets);
    assert_eq!(response.points.len(), 10);
    for point in &response.points {
        let r = point.value * 24.0 / w0;
        let amplitude = error / ((1.0 - r * r).powi(2) + (2.0 * zeta * r).powi(2)).sqrt();
        let expected = 2.0 * amplitude / 24.0 / 2.0_f64.sqrt();
        let found = point.observed[0].unwrap().rms;
        // The tolerance covers the rest of the transient, exp(-zeta w0 0.04 s), and the error of sampling.
        assert!((found / expected - 1.0).abs() < 1e-3, "r = {r}: {found}, not {expected}");
        assert!((point.speed / point.value - 1.0).abs() < 1e-3);
        let span = point.span.unwrap();
        assert!(
            span.of == "e"
                && (span.time() * point.value * 24.0 / std::f64::consts::TAU - f64::from(span.periods)).abs() < 0.01
        );
    }
}

#[test]
fn contact_loss_gives_two_motions_at_one_speed() {
    let over = "start.speed=2600 rpm:4200 rpm:5";
    let response = response("response", over, 0.1, &["output.record=[\"dte_12\",\"mesh_force_12\"]"]);
    let figure = crate::plot::response::figure("response", &response, measure("rms").unwrap());
    assert_eq!((&*figure.x.label, &*figure.x.unit), ("speed", "rpm"));
    let markers: Vec<_> = figure.panels[0].series.iter().map(|series| series.style.marker).collect();
    assert_eq!(markers, [Marker::Dot, Marker::Square]);
    let at = |upward: bool, i: usize| {
        let mut points: Vec<_> = response.points.iter().filter(|point| point.upward == upward).collect();
        points.sort_by(|a, b| a.value.total_cmp(&b.value));
        (points[i].observed[0].unwrap().rms, points[i].observed[1].unwrap().min)
    };
    // Between the jumps: in contact on the way up, with loss of contact and a multiple of the amplitude on the way down.
    let (up, down) = (at(true, 1), at(false, 1));
    // Where flanks part, the force is zero to a rounding error.
    assert!(up.1 > 0.0 && down.1.abs() < 1e-9 && down.0 > 5.0 * up.0, "{up:?}, {down:?}");
    // Above the jumps there is one motion.
    let (up, down) = (at(true, 4), at(false, 4));
    assert!((up.0 / down.0 - 1.0).abs() < 1e-3, "{up:?}, {down:?}");
}

/// The load differs from the motor torque. The torque that holds the speed is found: that of the load and of the dampers. Without a hold,
/// the train slows down.
#[test]
fn a_torque_holds_the_speed() {
    let sets = ["output.record=[\"dte_12\"]", "parameters.T_load=120 N*m", "run.t_end=60 ms"];
    let found = response("response", "start.speed=1000 rpm:1400 rpm:3", 0.02, &sets);
    assert_eq!(found.held, Some(("T_motor", "N*m")));
    for point in &found.points {
        // Gears of equal teeth; the damper of the mesh takes little below the resonance.
        assert!(point.hold > 120.0 && point.hold < 121.0, "{}", point.hold);
        assert!((point.speed / point.value - 1.0).abs() < 1e-3 && point.drift.abs() < 1e-4, "{point:?}");
    }
    let by_load = held("response", "start.speed=1000 rpm:1400 rpm:3", 0.02, &sets, &Hold::By("T_load".into())).unwrap();
    assert!(by_load.points.iter().all(|point| point.hold > 149.0 && point.hold < 150.0));
    let free = held("response", "start.speed=1000 rpm:1400 rpm:3", 0.02, &sets, &Hold::Nothing).unwrap();
    assert!(free.held.is_none() && free.points.iter().all(|point| point.drift.abs() > 5e-3), "{:?}", free.points);
    let error = held("response", "start.speed=1000 rpm:1400 rpm:3", 0.02, &sets, &Hold::By("k_m".into())).unwrap_err();
    assert!(error.to_string().contains("`k_m` cannot hold the speed"), "{error}");
}

/// The governor's torque c (n - omega) carries the load, so its set point is above the speed by T_load/(c times the ratio).
#[test]
fn the_set_point_of_a_governor_holds_the_speed() {
    let sets = ["output.record=[\"dte_12\"]", "parameters.T_load=100 N*m", "run.t_end=0.3 s"];
    let found = response("drives/governor", "start.speed=500 rpm:700 rpm:3", 0.2, &sets);
    assert_eq!(found.held, Some(("n_motor", "rad/s")));
    for point in &found.points {
        assert!((point.speed / point.value - 1.0).abs() < 1e-3 && point.drift.abs() < 1e-4, "{point:?}");
        assert!((point.hold - point.value - 2.5).abs() < 0.1, "{} at {}", point.hold, point.value);
    }
}

#[test]
fn a_response_needs_ascending_values() {
    let request = |over: &str| Request { vary: vec![over.into()], ..Request::default() };
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes/response.toml");
    for over in ["start.speed=300 rpm,200 rpm", "start.speed=300 rpm"] {
        let error =
            Sweep::load(&path, MODELS, &request(over)).unwrap().response(true, &Hold::Own, &mut |_| {}).unwrap_err();
        assert!(error.to_string().contains("do not rise"), "{error}");
    }
}

/// At 3000 rpm a pitch has forty samples. In each pitch the force steps at the same place between the same two samples. The expected numbers
/// are those of a run with samples at 2 MHz. From the samples alone the mean would be wrong by 0.3 %, and the root mean square by 1.7 %.
#[test]
fn steps_between_samples_do_not_shift_the_mean_force() {
    let sets = ["output.record=[\"mesh_force_12\"]", "run.t_end=0.3 s"];
    let response = response("response", "start.speed=2600 rpm:3000 rpm:2", 0.2, &sets);
    let force = response.points[1].observed[0].unwrap();
    // The greatest force lies between samples.
    let range = (force.max - force.min, 1579.0, 4e-3);
    for (found, expected, allowed) in [(force.mean, 2127.5, 1e-3), (force.rms, 466.2, 2e-3), range] {
        assert!((found / expected - 1.0).abs() < allowed, "{found}, not {expected}");
    }
}

/// Without damping, vibrations change the mean force on the rotation from run to run.
#[test]
fn a_speed_that_is_not_held_has_its_own_status() {
    let sets = ["output.record=[\"mesh_force_12\"]", "run.t_end=0.15 s"];
    let response = response("two_stage", "start.speed=1000 rpm:2000 rpm:3", 0.1, &sets);
    let held =
        |point: &&crate::sweep::response::ResponsePoint| (point.speed / point.value - 1.0).abs() <= SPEED_NOT_HELD;
    for point in &response.points {
        assert_eq!(point.status == Status::Done, held(&point), "{} at {}: {}", point.speed, point.value, point.reason);
    }
    let unheld = response.points.iter().find(|point| point.status == Status::Unheld).expect("such a point");
    assert!(unheld.reason.contains("instead of"), "{}", unheld.reason);
}

/// The dynamic factor and K_v of a response are those of the group `meshes` of a sweep. Only the torque of the mesh has them.
#[test]
fn a_response_has_the_dynamic_factor_of_the_sweep() {
    let (over, from) = ("start.speed=400 rpm:600 rpm:2", 0.3);
    let sets = ["output.record=[\"dte\",\"mesh_torque\"]"];
    let response = held("gear_pair_teeth", over, from, &sets, &Hold::Nothing).unwrap();
    let request =
        Request { vary: vec![over.into()], record: vec!["meshes".into()], from: Some(from), ..Request::default() };
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes/gear_pair_teeth.toml");
    let row = Sweep::load(&path, MODELS, &request).unwrap().point(0).numbers;
    for (name, expected) in ["dynamic_factor", "kv_iso6336"].into_iter().zip(row) {
        let found = (measure(name).unwrap().value)(&response.points[0], 1);
        // The vibration of the start has decayed to exp(-zeta w0 0.3 s).
        assert!(expected > 1.0 && (found / expected - 1.0).abs() < 1e-6, "{name}: {found}, not {expected}");
    }
    let table = response.table().unwrap();
    let of = |name: &str| table.columns().iter().filter(|column| column.name.starts_with(name)).count();
    assert_eq!([of("dte_"), of("mesh_torque_")], [3, 7]);
    let figure = crate::plot::response::figure("teeth", &response, measure("dynamic_factor").unwrap());
    let labels: Vec<_> = figure.panels[0].series.iter().map(|series| series.label.as_str()).collect();
    assert_eq!((figure.panels.len(), labels), (1, vec!["upward", "downward", "K_v of ISO 6336-1, method B"]));
}

/// Dry friction of twice the torque of the drive stops the train before the measured time. The torque that holds the speed is that of the
/// load and the friction, 210 N m/2. It is found from the deceleration of the train.
#[test]
fn a_train_that_dry_friction_stops_is_held() {
    let text = "model = \"train\"\neffects = [\"stiffness_step\", \"damping\", \"torques\", \"dry_friction\"]\n\
                rotors = { 1 = \"0.02 kg*m^2\", 2 = \"0.08 kg*m^2\" }\n\
                meshes.12 = { between = [\"1\", \"2\"], teeth = [20, 40], base_radius = \"28.19 mm\", stiffness = \"300 MN/m\" }\n\
                bearings.b = { rotor = \"2\", friction = \"200 N*m\" }\n\
                drives.m = { rotor = \"1\", torque = \"50 N*m\" }\nloads.l = { rotor = \"2\", torque = \"10 N*m\" }\n\
                parameters.beta_K = \"20 us\"\nstart.speed = \"600 rpm\"\nrun.t_end = \"0.4 s\"\noutput.rate = \"20 kHz\"\n\
                output.record = [\"mesh_force_12\"]\n";
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("braked.toml");
    std::fs::write(&path, text).unwrap();
    let request = Request { vary: vec!["start.speed=300 rpm:900 rpm:3".into()], from: Some(0.2), ..Request::default() };
    let sweep = Sweep::load(&path, MODELS, &request).unwrap();
    let response = sweep.response(true, &Hold::Own, &mut |_| {}).unwrap();
    for point in &response.points {
        assert_eq!(point.status, Status::Done, "{}: {}", point.value, point.reason);
        assert!((point.speed / point.value - 1.0).abs() < 2e-3, "{} {}", point.value, point.speed);
        assert!((point.hold / 105.0 - 1.0).abs() < 2e-3, "{} N m", point.hold);
    }
}
