//! Powers of torques, powers through parts, and reactions of held parts, compared with the work in the energy account and with Newton's
//! laws.

use std::collections::BTreeMap;

use gearsim::trajectory::Trajectory;

use crate::common::{run, scene};

/// The samples of a column.
fn samples(run: &Trajectory, name: &str) -> Vec<f64> {
    let column = run.column(name).unwrap_or_else(|| panic!("no column `{name}`"));
    run.samples().map(|row| column[row]).collect()
}

/// The largest magnitude.
fn size(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |m, x| f64::max(m, x.abs()))
}

/// The derivative of even samples by differences of fourth order, without two samples at each end.
fn slope(x: &[f64], h: f64) -> Vec<f64> {
    x.windows(5).map(|x| (x[0] - 8.0 * x[1] + 8.0 * x[3] - x[4]) / (12.0 * h)).collect()
}

/// The power of each torque, integrated between the rows, is its work in the account: for constant torques, torques that vary in time,
/// governors and friction.
#[test]
fn the_powers_of_torques_are_the_rates_of_their_works() {
    let mut seen = BTreeMap::new();
    for name in [
        "drives/torque_ripple",
        "drives/governor",
        "drives/fan_run_up",
        "sliding_friction",
        "train_turbine",
        "crank_drive",
    ] {
        // The trapezoidal rule has a relative error of (w h)²/12 for a vibration with w, 3e-6 of the power of friction at this rate.
        let run = run(&scene(name, &["run.t_end=20 ms".into(), "output.rate=2 MHz".into()])).trajectory;
        for (torque, work_done) in &run.torque_work {
            let power = run.output(&format!("power_{}", torque.name)).expect("an output of a torque of the scene");
            let [found, expected] = [work(&run, power), work_done[run.len() - 1]];
            let scale = size(power) * run.t[run.len() - 1];
            assert!((found - expected).abs() <= 1e-6 * scale, "{name}: {} {found}, not {expected} J", torque.name);
            *seen.entry(torque.name).or_insert(0) += 1;
        }
    }
    assert!(
        ["motor", "load", "governor_motor", "fan_load", "slide12", "roll12"].iter().all(|name| seen.contains_key(name)),
        "{seen:?}"
    );
}

/// A run has the works of the torques of its effects, and of no others. They sum to the work of the account, which closes with the losses
/// by cause.
#[test]
fn a_run_has_the_works_of_its_torques_alone() {
    let cases: [(&str, &str, &[&str]); 6] = [
        ("gear_pair_shafts", "\"stiffness_step\", \"damping\"", &[]),
        ("gear_pair_shafts", "\"stiffness_step\", \"damping\", \"torques\"", &["motor", "load"]),
        ("sliding_friction", "\"stiffness_step\", \"sliding_friction\"", &["slide12", "roll12"]),
        ("drives/governor", "\"governor_motor\", \"torques\"", &["motor", "governor_motor", "load"]),
        ("train_turbine", "\"stiffness_step\", \"damping\"", &[]),
        ("train_turbine", "\"stiffness_step\", \"damping\", \"torques\"", &["wind", "grid"]),
    ];
    for (name, effects, expected) in cases {
        let set = [&format!("effects=[{effects}]"), "run.t_end=5 ms", "output.rate=2 MHz", "output.plots=[]"];
        let run = run(&scene(name, &set.map(String::from))).trajectory;
        let names: Vec<_> = run.columns().filter_map(|c| Some(c.name.strip_prefix("work_")?.to_owned())).collect();
        assert_eq!(names, *expected, "{name}, {effects}");
        let scale = run.kinetic[0] + size(&run.strain);
        for row in 0..run.len() {
            let sum: f64 = run.torque_work.iter().map(|(_, work)| work[row]).sum();
            assert!((sum - run.work[row]).abs() <= 1e-12 * scale, "{name}: {sum} J, not {} J", run.work[row]);
            assert!(run.residual[row].abs() <= 1e-9 * scale, "{name}: {} J of {scale} J", run.residual[row]);
        }
        let lost: f64 =
            run.outputs.iter().filter(|(output, _)| output.is_loss()).map(|(_, power)| work(&run, power)).sum();
        let dissipated = run.dissipated[run.len() - 1];
        // Without torques the turbine is at rest, and its loss is a rounding error.
        let allowed = 1e-6 * dissipated + 1e-18 * scale;
        assert!((lost - dissipated).abs() <= allowed, "{name}: {lost} J by cause, {dissipated} J in all");
    }
}

/// The integral of a power over the rows [J].
fn work(run: &Trajectory, power: &[f64]) -> f64 {
    let rows = run.t.windows(2).zip(power.windows(2));
    rows.map(|(t, p)| 0.5 * (t[1] - t[0]) * (p[0] + p[1])).sum()
}

/// The power of the motor minus the power that accelerates its rotor enters the shaft. The power that leaves the shaft minus the power that
/// accelerates the driving gear enters the mesh.
#[test]
fn power_passes_from_part_to_part() {
    for (name, mesh, radius) in [("gear_pair_shafts", "12", "r1"), ("two_stage", "12", "r1")] {
        let scene = scene(name, &["run.t_end=5 ms".into(), "output.rate=2 MHz".into(), "output.events=false".into()]);
        let number = |name: &str| scene.parameter(name).unwrap();
        let outcome = run(&scene);
        let (events, run) = (outcome.counts.cell_changes, outcome.trajectory);
        let of = |name: &str| samples(&run, name);
        let (speed, motor, shaft) = (of("rotor_speed_m"), of("power_motor"), of("shaft_power_m"));
        let gain = slope(&speed, 0.5e-6);
        let balance = |(i, gain): (usize, &f64)| {
            let row = i + 2;
            (motor[row] - shaft[row] - number("I_m") * speed[row] * gain).abs() / size(&motor)
        };
        let balances: Vec<f64> = gain.iter().enumerate().map(balance).collect();
        // Where the stiffness steps, the acceleration of the motor has a kink: differences over it, four samples, are of first order.
        let kinks = balances.iter().filter(|balance| **balance > 1e-9).count() as u64;
        assert!(kinks <= 4 * events && size(&balances) < 1e-5, "{name}: {kinks} samples, {:e}", size(&balances));
        let (force, gear) = (of(&format!("mesh_force_{mesh}")), of("rotor_speed_1"));
        let given = of(&format!("mesh_power_{mesh}"));
        for row in 0..given.len() {
            let expected = force[row] * number(radius) * gear[row];
            assert!((given[row] - expected).abs() < 1e-12 * size(&given), "{} {expected}", given[row]);
        }
    }
}

/// A train forms the powers through its parts from the speeds of its rotors. The sum of the powers at a body minus its change of energy is
/// zero; here each power is compared with force times speed.
#[test]
fn a_train_has_the_powers_of_its_parts() {
    let scene = scene("train_turbine", &["run.t_end=5 ms".into()]);
    let number = |name: &str| scene.parameter(name).unwrap_or_else(|| panic!("no parameter {name}"));
    let run = run(&scene).trajectory;
    let of = |name: &str| samples(&run, name);
    let shafts = [("low", "blades"), ("middle", "sun"), ("high", "4")];
    let torques =
        shafts.map(|(shaft, rotor)| (format!("shaft_power_{shaft}"), format!("shaft_torque_{shaft}"), rotor, 1.0));
    // The base radii of the first gear of each pair. That of the second pair is on the countershaft.
    let radii = [number("r1"), number("r34")];
    let meshes = [("12", "1", radii[0]), ("34", "counter", radii[1])];
    let forces =
        meshes.map(|(mesh, rotor, radius)| (format!("mesh_power_{mesh}"), format!("mesh_force_{mesh}"), rotor, radius));
    for (power, force, rotor, arm) in torques.into_iter().chain(forces) {
        let (power, force, speed) = (of(&power), of(&force), of(&format!("rotor_speed_{rotor}")));
        assert!(size(&power) > 0.0);
        for row in 0..power.len() {
            let expected = force[row] * arm * speed[row];
            assert!((power[row] - expected).abs() < 1e-9 * size(&power), "{rotor}: {} {expected}", power[row]);
        }
    }
    // The sun drives the middle shaft: the power that it gives to its meshes is the power that it takes from the shaft, except for its
    // acceleration.
    let given: f64 = ["p_s1", "p_s2", "p_s3"].map(|mesh| of(&format!("mesh_power_{mesh}"))[0]).iter().sum();
    assert!(given < 0.0 && of("shaft_power_middle")[0] > 0.0, "{given}");
}

/// A torque on a rotor at rest: the friction is the torque less that of the spring, up to the breakaway torque.
#[test]
fn dry_friction_at_rest_has_the_torque_that_it_resists() {
    let sets = [
        "effects=[\"dry_friction\",\"torques\"]".into(),
        "parameters.T_motor={steps=[{value=\"1 N*m\", until=\"0.1 s\"}, {value=\"-3 N*m\", until=\"0.2 s\"}, {value=\"4.5 N*m\"}]}".into(),
        "start.phi=\"2 mrad\"".into(),
        "run.t_end=0.3 s".into(),
    ];
    let run = run(&scene("friction_oscillator", &sets)).trajectory;
    let [t, phi, friction] = ["t", "phi", "friction_torque"].map(|name| samples(&run, name));
    for (i, t) in t.iter().enumerate() {
        let torque = match t {
            t if *t < 0.1 - 1e-9 => 1.0,
            t if *t > 0.1 + 1e-9 && *t < 0.2 - 1e-9 => -3.0,
            t if *t > 0.2 + 1e-9 => 4.5,
            _ => continue,
        };
        let expected = torque - 400.0 * phi[i];
        assert!((friction[i] - expected).abs() < 1e-9, "at {t} s {} N m, not {expected}", friction[i]);
    }
    assert!((size(&phi) - 2e-3).abs() < 1e-15, "it has moved");
}

/// In every mode the torque of a clutch is the torque of the motor minus the torque that accelerates its rotor.
#[test]
fn a_clutch_has_its_torque_locked_and_open() {
    // Without the torque curve and the friction of flanks: the motor's torque is 80 N*m, then -20 N*m.
    let sets = [
        r#"effects=["stiffness_step", "backlash", "transmission_error_12", "overrunning_clutch", "dry_friction", "viscous_friction", "damping", "torques"]"#.into(),
        r#"parameters.T_motor={ steps = [{ value = "80 N*m", until = "0.2 s" }, { value = "-20 N*m" }] }"#.into(),
    ];
    let rows = ["run.t_end=0.25 s", "output.rate=200 kHz", "output.events=false"].map(String::from);
    let scene = scene("electric_axle", &[&sets[..], &rows].concat());
    let inertia = scene.parameter("I_m").unwrap();
    let run = run(&scene).trajectory;
    let [t, speed, clutch] = ["t", "rotor_speed_m", "clutch_torque"].map(|name| samples(&run, name));
    let gain = slope(&speed, 5e-6);
    let (mut off, mut modes) = (0, [0, 0]);
    for (i, gain) in gain.iter().enumerate() {
        let row = i + 2;
        let motor = if t[row] < 0.2 { 80.0 } else { -20.0 };
        modes[usize::from((clutch[row] + 0.2).abs() < 1e-9)] += 1;
        // Differences across an impact of the flanks, or across the step of the motor's torque, are no accelerations.
        off += usize::from((clutch[row] - (motor - inertia * gain)).abs() > 0.02 * 80.0);
    }
    assert!(modes[0] > 10_000 && modes[1] > 100, "locked and overrunning samples: {modes:?}");
    assert!(off < gain.len() / 20, "{off} of {} samples differ", gain.len());
}
