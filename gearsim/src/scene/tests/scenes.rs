//! Scenes without mistakes: the values that are read.

use std::f64::consts::{PI, TAU};

use super::fixture::{GEAR_PAIR, SCENE, parse};
use crate::model::Start;
use crate::profile::{Profile, Step};
use crate::scene::{Effects, Scene};

#[test]
fn a_scene_is_read_in_si() {
    let scene = parse(SCENE, &[]).unwrap();
    assert_eq!(scene.name, "energy");
    assert_eq!(scene.about, "Gear pair at 300 rpm");
    assert_eq!(scene.effects.names(&GEAR_PAIR), ["stiffness_step", "damping", "torques"]);
    assert_eq!(scene.parameters, [2.89e-3, 0.7402, 24.0, 96.0, 0.1, 10.0]);
    assert_eq!(scene.parameter("N2"), Some(96.0));
    assert_eq!(scene.parameter("N3"), None);
    let steps = vec![Step { value: 1430.0, width: 1.73 }, Step { value: 2780.0, width: TAU - 1.73 }];
    let none = vec![Step { value: 0.0, width: TAU }];
    assert_eq!(scene.laws, [steps, none.clone(), none.clone(), none].map(Profile::stepping));
    assert_eq!(scene.present().map(|(law, _)| law.name).collect::<Vec<_>>(), ["k"]);
    assert_eq!(scene.start.q, [Start::At(0.0), Start::Static]);
    assert_eq!(scene.start.q_dot, [None, None]);
    assert_eq!(scene.start.motions, [300.0 * PI / 30.0]);
    assert_eq!(scene.t_end, 0.1);
    assert_eq!(scene.output.rate, 20e3);
    assert_eq!(scene.output.plots, ["energy", "spectrum", "motion"]);
    assert!(scene.output.events && !scene.output.csv);
}

#[test]
fn a_minimal_scene_gets_the_defaults() {
    let text = r#"
        model = "gear_pair"
        effects = []
        parameters = { I1 = "1 kg*m^2", I2 = "1 kg*m^2" }
        laws.k.steps = [{ value = "0 N*m" }]
        run.t_end = "2 s"
    "#;
    let scene = parse(text, &[]).unwrap();
    assert_eq!(scene.effects, Effects::none(scene.model));
    assert_eq!(scene.laws[0].steps, [Step { value: 0.0, width: TAU }]);
    assert_eq!(scene.start.q, [Start::At(0.0), Start::Static]);
    assert_eq!(scene.output.rate, 5e3);
}

#[test]
fn overrides_replace_values_add_keys_and_index_arrays() {
    let overrides = [
        "parameters.T0=20 N*m",
        r#"run.t_end="1 s""#,
        r#"effects=["stiffness_step"]"#,
        "start.speed=600 rpm",
        "start.theta_dot = 1 rad/s",
        "laws.k.steps.0.value=2 kN*m",
        "output.csv=true",
    ];
    let scene = parse(SCENE, &overrides).unwrap();
    assert_eq!(scene.parameter("T0"), Some(20.0));
    assert_eq!(scene.t_end, 1.0);
    assert_eq!(scene.effects, Effects::numbered(scene.model, [0]));
    assert_eq!(scene.start.motions, [600.0 * PI / 30.0]);
    assert_eq!(scene.start.q_dot, [Some(1.0), None]);
    assert_eq!(scene.laws[0].steps[0].value, 2000.0);
    assert!(scene.output.csv);
    let scene = parse(SCENE, &[r#"laws.k.steps=[{value="3 N*m"}]"#]).unwrap();
    assert_eq!(scene.laws[0].steps, [Step { value: 3.0, width: TAU }]);
}

#[test]
fn the_hash_depends_on_text_and_overrides() {
    let hash = |overrides: &[&str]| parse(SCENE, overrides).unwrap().hash;
    assert_eq!(hash(&[]).len(), 64);
    assert_eq!(hash(&["run.t_end=1 s"]), hash(&["run.t_end=1 s"]));
    assert_ne!(hash(&["run.t_end=1 s"]), hash(&["run.t_end=2 s"]));
    assert_ne!(hash(&["run.t_end=1 s"]), hash(&[]));
}

#[test]
fn effect_sets_come_from_names() {
    let set = Effects::from_names(["torques", "stiffness_step"], &GEAR_PAIR).unwrap();
    assert_eq!(set, Effects::numbered(&GEAR_PAIR, [0, 4]));
    assert!(set.contains(4) && !set.contains(3) && !set.contains(99));
    assert_eq!(Effects::from_names(["friction"], &GEAR_PAIR), None);
}

#[test]
fn a_scene_file_gives_its_stem_as_name_and_a_missing_file_is_reported() {
    let path = std::env::temp_dir().join(format!("gearsim-{}.scene.toml", std::process::id()));
    std::fs::write(&path, SCENE).unwrap();
    let scene = Scene::load_with(&path, &[], &[&GEAR_PAIR]);
    std::fs::remove_file(&path).unwrap();
    assert!(scene.unwrap().name.ends_with(".scene"));
    let error = Scene::load_with(&path, &[], &[&GEAR_PAIR]).unwrap_err();
    assert!(error.render(80, false).contains("cannot read"));
}

/// Torques that vary in time, set from the command line; a later override changes one key of an earlier one.
#[test]
fn torques_vary_in_time() {
    let at = |overrides: &[&str], t: f64| {
        let scene = parse(SCENE, overrides).unwrap_or_else(|e| panic!("{}", e.render(100, false)));
        let (p, history) = &scene.time_histories[0];
        assert_eq!((*p, scene.parameters[5]), (5, history.at(0, 0.0)));
        history.at(history.piece(t), t)
    };
    let steps = "parameters.T0={steps=[{value=\"1 kN*m\", until=\"100 ms\"}, {value=\"5 N*m\"}]}";
    assert_eq!((at(&[steps], 0.05), at(&[steps], 0.1)), (1000.0, 5.0));
    let ramp = "parameters.T0={ramp={from=\"1 N*m\", to=\"3 N*m\", start=\"1 s\", duration=\"2 s\"}}";
    assert_eq!([0.5, 2.0, 9.0].map(|t| at(&[ramp], t)), [1.0, 2.0, 3.0]);
    assert_eq!(at(&[ramp, "parameters.T0.ramp.to=\"5 N*m\""], 2.0), 3.0);
    let table = "parameters.T0={table=[{at=0, value=0}, {at=\"1 s\", value=\"4 N*m\"}], harmonics=[{amplitude=\"1 N*m\", \
                 frequency=\"1 Hz\", phase=\"180 deg\"}]}";
    assert!((at(&[table], 0.5) - 3.0).abs() < 1e-14);
}
