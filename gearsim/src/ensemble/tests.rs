//! An ensemble against the same simulations run one by one.

use super::*;
use crate::engine::equations::{Derived, Equations};
use crate::scene::Scene;
use gearsim_generated::gear_pair::GearPair;

const SCENE: &str = r#"
model = "gear_pair"
effects = ["stiffness_step", "damping", "torques"]
[parameters]
I1 = "2890 kg*mm^2"
I2 = "740200 kg*mm^2"
zeta = 0.05
T0 = "10 N*m"
[laws.k]
steps = [{ value = "1.43 kN*m", width = "1.73 rad" }, { value = "2.78 kN*m" }]
[start]
speed = "300 rpm"
[run]
t_end = "0.1 s"
"#;

type Prepared = (Scene, Box<dyn Equations>);

fn prepare(overrides: &[String]) -> Prepared {
    let scene = Scene::parse("ensemble", "a test", SCENE, overrides, &[&GearPair::MODEL]).unwrap();
    let equations = GearPair::equations(&scene.effects, &scene.parameters, &[scene.laws[0].mid()]).unwrap();
    (scene, equations)
}

fn simulations(scenes: &[Prepared]) -> Vec<Simulation<'_>> {
    scenes.iter().map(|(scene, e)| Simulation::new(&**e, scene).unwrap()).collect()
}

/// Runs scenes one by one and as an ensemble. The events must be the same, and the states may differ by at most `tolerance`, relative to
/// their sizes.
fn check(scenes: &[Prepared], tolerance: f64) {
    let (mut alone, mut together) = (simulations(scenes), simulations(scenes));
    let ended: Vec<_> = alone.iter_mut().map(|s| s.run(None, &mut |_| {})).collect();
    assert_eq!(run(&mut together), ended);
    for ((alone, together), (scene, _)) in alone.iter().zip(&together).zip(scenes) {
        let (a, b) = (&alone.now.counts, &together.now.counts);
        assert_eq!((a.cell_changes, a.reflections, a.holds), (b.cell_changes, b.reflections, b.holds), "{scene:?}");
        assert_eq!((&alone.now.state.turns, alone.now.clock), (&together.now.state.turns, together.now.clock));
        let speeds = alone.now.state.q_dot.amax();
        let apart = [
            (alone.now.state.q[0] - together.now.state.q[0]).abs(),
            (alone.now.state.q[1] - together.now.state.q[1]).abs() / 0.01,
            (&alone.now.state.q_dot - &together.now.state.q_dot).amax() / speeds,
            (alone.now.dissipated - together.now.dissipated).abs() / (alone.now.dissipated + 1.0),
        ];
        assert!(apart.iter().all(|x| *x <= tolerance), "{apart:?} of {scene:?}");
    }
}

#[test]
fn lanes_have_the_events_of_the_general_loop() {
    // Slow and fast runs in both directions, with reflections, of different lengths, and more of them than lanes. The rounding
    // errors differ, and the motion amplifies them by up to about 1e4.
    let scene = |i: u32| {
        let speed = [4500.0, -4000.0, 600.0, 1200.0, -300.0, 5123.0, 2000.0][i as usize % 7];
        prepare(&[
            format!("start.speed={speed} rpm"),
            format!("run.t_end={} s", 0.05 + 0.003 * f64::from(i)),
            format!("parameters.T0={} N*m", 2.0 + f64::from(i % 5)),
        ])
    };
    check(&(0..43).map(scene).collect::<Vec<_>>(), 1e-9);
}

#[test]
fn simulations_without_a_lane_are_run_by_the_general_loop() {
    let effects = |effects: &str| prepare(&[format!("effects=[{effects}]"), "start.speed=900 rpm".into()]);
    let overdamped = prepare(&["parameters.zeta=3".into()]);
    let scenes = [
        effects(r#""stiffness_step", "torques""#),
        effects(r#""stiffness_step", "frozen_phase", "damping", "torques""#),
        effects(r#""stiffness_step", "rigid_kinematics", "damping", "torques""#),
        effects(r#""torques""#),
        overdamped,
        effects(""),
    ];
    check(&scenes, 1e-11);
}

#[test]
fn a_lane_does_not_depend_on_the_others() {
    // To the last bit, so that sweeps do not depend on how they are divided.
    let speeds = [4500.0, 4321.0, 3999.0, 5000.0, 2500.0, 600.0, 700.0, 650.0, -800.0];
    let scenes: Vec<_> = speeds.iter().map(|s| prepare(&[format!("start.speed={s} rpm")])).collect();
    let mut all = simulations(&scenes);
    run(&mut all);
    for (i, together) in all.iter().enumerate() {
        let mut one = simulations(&scenes[i..=i]);
        run(&mut one);
        assert_eq!(
            (&one[0].now.state.q, &one[0].now.state.q_dot),
            (&together.now.state.q, &together.now.state.q_dot),
            "{} rpm",
            speeds[i]
        );
        assert_eq!((one[0].now.clock, one[0].now.dissipated), (together.now.clock, together.now.dissipated));
    }
}

#[test]
fn an_empty_ensemble_has_no_results() {
    assert!(run(&mut []).is_empty());
}
