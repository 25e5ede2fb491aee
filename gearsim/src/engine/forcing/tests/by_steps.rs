//! Parameters that vary in time and whose factors depend on the state. The equations at a time are compared with those for the constant
//! value that the parameter has at this time.

use super::*;
use crate::engine::equations::{Equations, Exit, Known, varying_by_steps};
use crate::engine::vector::Vector;
use crate::scene::Effects;
use gearsim_generated::freewheel::Freewheel;
use gearsim_generated::friction_oscillator::FrictionOscillator;

const PAIR: &str = "parameters={I1=\"2890 kg*mm^2\", I2=\"740200 kg*mm^2\", T0=\"10 N*m\", zeta=0.1, Tp_motor=\"250 N*m\", \
    Pp_motor=\"50 kW\", sb_motor=0.1, ns_motor=\"120 rad/s\"}";
const OSCILLATOR: &str = "parameters={I=\"1 kg*m^2\", k=\"400 N*m/rad\", rise=0.2}";
const FREEWHEEL: &str =
    "parameters={I1=\"1 kg*m^2\", I2=\"2 kg*m^2\", Tdrag=\"0.1 N*m\", T_motor=\"3 N*m\", T_load=\"0 N*m\"}";

/// Model, effects, other numbers; the parameter, its time history, and its value at 0.4 s.
const VARYING: [(&str, &str, &str, &str, &str, f64); 5] = [
    ("gear_pair", "traction_motor", PAIR, "d_motor", "{ramp={from=-0.2, to=0.8, duration=\"1 s\"}}", 0.2),
    (
        "gear_pair",
        "induction_motor",
        PAIR,
        "Tb_motor",
        "{table=[{at=0, value=\"50 kN*m\"}, {at=\"1 s\", value=\"25 kN*m\"}]}",
        40e3,
    ),
    (
        "gear_pair",
        "fan_load",
        PAIR,
        "cf_load",
        "{mean=\"1e-3 kg*m^2\", harmonics=[{amplitude=\"5e-4 kg*m^2\", frequency=\"1.25 Hz\"}]}",
        5e-4,
    ),
    ("friction_oscillator", "dry_friction", OSCILLATOR, "Tc", "{ramp={to=\"5 N*m\", duration=\"1 s\"}}", 2.0),
    (
        "freewheel",
        "overrunning_clutch",
        FREEWHEEL,
        "Tmax",
        "{table=[{at=\"0.2 s\", value=\"10 N*m\"}, {at=\"0.6 s\", value=\"50 N*m\"}]}",
        30.0,
    ),
];

/// A scene with such a parameter, and the scene with its value at 0.4 s.
fn scenes((model, effect, numbers, parameter, history, value): (&str, &str, &str, &str, &str, f64)) -> [Scene; 2] {
    let laws = if model == "gear_pair" { "laws.k={steps=[{value=\"2 kN*m\"}]}" } else { "output.rate=\"1 kHz\"" };
    let start = if model == "gear_pair" { "start.theta_dot=\"1000 rad/s\"" } else { "run.t_end=\"1 s\"" };
    let text = format!("model = \"{model}\"\n[run]\nt_end = \"1 s\"\n[output]\nrate = \"1 kHz\"\n");
    let torques = if effect.ends_with("load") || effect.ends_with("motor") { ", \"torques\"" } else { "" };
    let effects = format!("effects=[\"{effect}\"{torques}]");
    let varies = format!("parameters.{parameter}={history}");
    let scene = parse(&text, &[&effects, numbers, laws, start, &varies]);
    let mut present = scene.clone();
    present.time_histories.clear();
    present.parameters[scene.model.parameters.iter().position(|p| p.name == parameter).unwrap()] = value;
    [scene, present]
}

fn derived(model: &str) -> DerivedModel {
    match model {
        "gear_pair" => DerivedModel::of::<GearPair>(),
        "freewheel" => DerivedModel::of::<Freewheel>(),
        _ => DerivedModel::of::<FrictionOscillator>(),
    }
}

/// All numbers that may depend on such a parameter.
fn numbers(scene: &Scene, e: &dyn Equations, k: &[f64]) -> Vec<(String, f64)> {
    let n = e.coordinates();
    let q = Vector::from_fn(n, |i| 0.3 - 0.02 * i as f64);
    let q_dot = Vector::from_fn(n, |i| if i == 0 { 290.0 } else { 35.0 });
    let (dk, ddk) = (vec![0.5; k.len()], vec![0.25; k.len()]);
    let mut all = vec![];
    let mut note = |what: &str, numbers: &[f64]| all.extend(numbers.iter().map(|x| (what.to_string(), *x)));
    note("force", &e.force(&q, &q_dot, k, &dk));
    e.jacobian(&q, &q_dot, k, &dk, &ddk).iter().for_each(|part| note("jacobian", part.as_slice()));
    note("load", &e.load(k));
    for &i in &scene.torques() {
        note("power", &[e.torque_power(i, &q, &q_dot, k)]);
    }
    let active = |with: Option<&str>| with.is_none_or(|effect| scene.effects.has(effect, scene.model));
    for (i, output) in scene.model.outputs.iter().enumerate().filter(|(_, output)| active(output.with)) {
        note(output.name, &[e.output(i, &q, &q_dot, k, &Known::default())]);
    }
    for (i, switch) in scene.model.switches.iter().enumerate().filter(|(_, switch)| active(Some(switch.with))) {
        for mode in 0..switch.modes.len() {
            for Exit { guard, .. } in e.exits(i, mode, &q, k) {
                note("guard", &[guard.constant, guard.on_reaction]);
                note("guard", &guard.on_q);
                note("guard", &guard.on_speed);
            }
        }
        note("loss", &e.lost(i, k));
    }
    all
}

#[test]
fn varying_equations_equal_those_with_the_present_value() {
    for case in VARYING {
        let [scene, present] = scenes(case);
        let (derived, parameter) = (derived(case.0), case.3);
        let mut forcing = Forcing::of(&derived, &scene).unwrap();
        forcing.enter(0.4);
        assert_eq!(forcing.moves_guards(), parameter.starts_with("T") && parameter != "Tb_motor", "{parameter}");
        let mut k = scene.model.in_contact(scene.mids());
        // The symbols of switches are 1, so that none of them removes a term.
        k[scene.model.laws.len()..].fill(1.0);
        k.push(0.0);
        let varying = derived.equations(&scene).unwrap();
        let start = numbers(&scene, &*varying, &k);
        forcing.write_shares(0.4, &mut k);
        let now = numbers(&scene, &*varying, &k);
        let expected = numbers(&present, &*derived.equations(&present).unwrap(), &k);
        assert_eq!(now.len(), expected.len());
        let mut changed = vec![];
        for ((start, now), expected) in start.iter().zip(&now).zip(&expected) {
            let size = start.1.abs().max(expected.1.abs());
            assert!((now.1 - expected.1).abs() <= 2e-15 * size, "{parameter}: {now:?}, not {expected:?}");
            changed.extend((now.1 != start.1).then_some(&*now.0));
        }
        let some: &[&str] = match parameter {
            "Tc" => &["force", "load", "friction_torque", "guard", "loss"],
            "Tmax" => &["guard"],
            _ => &["force", "jacobian", "power"],
        };
        assert!(some.iter().all(|what| changed.contains(what)), "{parameter} changes {changed:?}");
    }
}

/// Without the effect of the parameter, its time history changes nothing, and the cells are exact.
#[test]
fn parameters_of_absent_effects_do_not_matter() {
    let scene = parse(TRAIN, &["effects=[]"]);
    assert!(Forcing::of(&DerivedModel::of::<Freewheel>(), &scene).is_none());
    for case in VARYING {
        let [mut scene, _] = scenes(case);
        assert_eq!(varying_by_steps(&scene).count(), 1, "{}", case.3);
        scene.effects = Effects::from_names([], scene.model).unwrap();
        assert_eq!(varying_by_steps(&scene).count(), 0, "{}", case.3);
    }
    let outcome = run_of(TRAIN, &["effects=[]"]);
    assert_eq!(outcome.solver.method, "exact", "{}", outcome.solver.why);
}

/// A train with a clutch that engages while its capacity rises: the slip is 30 rad/s - (1 N*m t + 5 N*m/s t²) (1/I1 + 1/I2).
#[test]
fn a_clutch_of_a_train_may_have_a_varying_capacity() {
    let outcome = run_of(TRAIN, &[]);
    let t = &outcome.trajectory;
    for (i, time) in t.t.iter().enumerate() {
        let impulse = (time + 5.0 * time * time).min(20.0);
        let (found, expected) = ([t.q_dot[0][i], t.q_dot[1][i]], [30.0 - impulse, 0.5 * impulse]);
        assert!((0..2).all(|j| (found[j] - expected[j]).abs() < 1e-8), "{time} s: {found:?}, not {expected:?}");
    }
    assert!((t.dissipated[t.len() - 1] - 300.0).abs() < 1e-8 && residual(&outcome) < 1e-12);
}

const TRAIN: &str = r#"
model = "train"
effects = ["overrunning_clutch"]
[rotors]
1 = "1 kg*m^2"
2 = "2 kg*m^2"
[clutches.c]
between = ["1", "2"]
capacity = { ramp = { from = "1 N*m", to = "31 N*m", duration = "3 s" } }
[start]
theta1_dot = "30 rad/s"
[run]
t_end = "3 s"
[output]
rate = "100 Hz"
"#;
