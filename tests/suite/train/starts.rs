//! Static starts: the start speeds decide how friction and clutches act, parts that they hold do not accelerate, and nothing vibrates.

use gearsim::run::Outcome;
use gearsim::scene::Scene;

use crate::common;

/// A motor and two rotors, 0.1 kg m² each: motor and `a` are joined as `joint` says, and a shaft of 10 kN m/rad turns `b`.
fn train(joint: &str, effects: &str, [motor, load]: [f64; 2], rest: &str) -> Outcome {
    let text = format!(
        "model = \"train\"\neffects = [{effects}, \"torques\"]\n\
         [rotors]\nmotor = \"0.1 kg*m^2\"\na = \"0.1 kg*m^2\"\nb = \"0.1 kg*m^2\"\n\
         {joint}\n[shafts.s]\nbetween = [\"a\", \"b\"]\nstiffness = \"10 kN*m/rad\"\n\
         [drives.d]\nrotor = \"motor\"\ntorque = \"{motor} N*m\"\n[loads.l]\nrotor = \"b\"\ntorque = \"{load} N*m\"\n\
         {rest}\n[run]\nt_end = \"20 ms\"\n[output]\nrate = \"20 kHz\"\n"
    );
    let scene = Scene::parse("start", "start.toml", &text, &[], &common::models())
        .unwrap_or_else(|e| panic!("{}", e.render(100, false)));
    common::run(&scene)
}

const CLUTCH: &str = "[clutches.c]\nbetween = [\"motor\", \"a\"]\ncapacity = \"500 N*m\"";
const SHAFT: &str = "[shafts.m]\nbetween = [\"motor\", \"a\"]\nstiffness = \"20 kN*m/rad\"";

/// Checks that an output has one value in the whole run.
fn is_constant(run: &Outcome, name: &str, value: f64) {
    let column = run.trajectory.output(name).unwrap_or_else(|| panic!("{name} is recorded"));
    let off = column.iter().fold(0.0, |most: f64, x| most.max((x - value).abs()));
    assert!(off <= 1e-9 * value.abs(), "{name}: {value} expected, off by {off}");
}

/// A locked clutch transmits the torques that accelerate the rotors behind it: 30 N m each at 300 rad/s².
#[test]
fn a_locked_clutch_transmits_from_the_start() {
    let turning = "[start]\nspeed_motor = \"1000 rpm\"\nspeed_a = \"1000 rpm\"";
    for (torques, clutch, shaft) in [([100.0, 100.0], 100.0, 100.0), ([100.0, 10.0], 70.0, 40.0)] {
        let run = train(CLUTCH, "\"overrunning_clutch\"", torques, turning);
        is_constant(&run, "clutch_torque_c", clutch);
        is_constant(&run, "shaft_torque_s", shaft);
    }
}

/// A clutch that is overrun transmits nothing: its rotors accelerate by themselves.
#[test]
fn an_overrun_clutch_transmits_nothing_at_the_start() {
    let turning = "[start]\nspeed_motor = \"500 rpm\"\nspeed_a = \"1000 rpm\"";
    let run = train(CLUTCH, "\"overrunning_clutch\"", [0.0, 10.0], turning);
    is_constant(&run, "shaft_torque_s", 5.0);
}

/// Dry friction of a rotor that turns is a torque as any other, in either direction.
#[test]
fn dry_friction_brakes_from_the_start() {
    for sense in [1.0, -1.0] {
        let friction =
            format!("[bearings.f]\nrotor = \"b\"\nfriction = \"90 N*m\"\n[start]\nspeed = \"{} rpm\"", sense * 1e3);
        let run = train(SHAFT, "\"dry_friction\"", [sense * 100.0, sense * 10.0], &friction);
        is_constant(&run, "shaft_torque_s", sense * 100.0);
    }
}

/// A train at rest that friction holds: the shafts carry the torque to the brake. A torque beyond the friction accelerates all of it.
#[test]
fn a_brake_holds_from_the_start_up_to_its_torque() {
    let friction = "[bearings.f]\nrotor = \"b\"\nfriction = \"40 N*m\"\n[start]\nspeed = 0";
    let held = train(SHAFT, "\"dry_friction\"", [30.0, 0.0], friction);
    is_constant(&held, "shaft_torque_s", 30.0);
    // The rounding errors of 30 N m let the shafts vibrate.
    let fastest = held.trajectory.q_dot.iter().flatten().fold(0.0, |most: f64, v| most.max(v.abs()));
    assert!(fastest < 1e-9, "{fastest} rad/s");
    // 100 N m against 40 N m: 200 rad/s².
    let loose = train(SHAFT, "\"dry_friction\"", [100.0, 0.0], friction);
    is_constant(&loose, "shaft_torque_s", 60.0);
}

/// Frozen phases begin where the static start puts them.
#[test]
fn a_frozen_phase_begins_at_its_static_place() {
    let effects = "effects=[\"frozen_phase\",\"stiffness_step\",\"torques\"]".to_string();
    let short = "run.t_end=\"5 ms\"".to_string();
    let given = common::run(&common::scene("two_stage", &[effects.clone(), short.clone()]));
    let theta2 = format!("start.theta2=\"{:?} rad\"", given.trajectory.q[2][0]);
    let stated = common::run(&common::scene("two_stage", &[effects, short, theta2]));
    assert!(given.trajectory.q[2][0].abs() > 0.01, "the place of the second mesh differs from zero");
    for (a, b) in given.trajectory.q.iter().zip(&stated.trajectory.q) {
        let (a, b) = (a.last().expect("rows"), b.last().expect("rows"));
        assert!((a - b).abs() <= 1e-9 * b.abs().max(1e-6), "{a} and {b}");
    }
}

/// Gravity turns the crank: the train accelerates, and its mesh follows without a vibration. With a vibration the mesh deflection would
/// have an acceleration of 80 m/s².
#[test]
fn gravity_accelerates_a_crank_without_vibration() {
    let at = |angle: &str| {
        let overrides =
            [format!("start.theta=\"{angle}\""), "run.t_end=\"1 us\"".into(), "output.rate=\"2 MHz\"".into()];
        let run = common::run(&common::scene("crank_drive", &overrides)).trajectory;
        let (rate, last) = (&run.q_dot[1], run.len() - 1);
        (rate[last] - rate[0]) / (run.t[last] - run.t[0])
    };
    for angle in ["0 rad", "28.8 rad", "-40 rad"] {
        let acceleration = at(angle);
        assert!(acceleration.abs() < 1e-2, "{angle}: {acceleration} m/s^2");
    }
}
