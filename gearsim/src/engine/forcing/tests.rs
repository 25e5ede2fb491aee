//! Torques that vary in time, against an independent integration; and scenes that are refused.

use crate::engine::Refusal;
use crate::engine::equations::DerivedModel;
use crate::engine::simulate::Simulation;
use crate::engine::start;
use crate::known::MODELS;
use crate::model::Model;
use crate::run::Entry;
use crate::run::Outcome;
use crate::scene::Scene;
use gearsim_generated::gear_pair::GearPair;

use super::Forcing;

mod by_steps;
mod closed_forms;
mod contacts;

/// The gear pair of Oh, Grosh & Barber (2005) with a constant stiffness: phi'' + 2 zeta w phi' + w² phi = M2 T0(t).
const SCENE: &str = r#"
model = "gear_pair"
effects = ["torques"]
[parameters]
I1 = "2890 kg*mm^2"
I2 = "740200 kg*mm^2"
T0 = "10 N*m"
[laws.k]
steps = [{ value = "2 kN*m" }]
[start]
theta_dot = "1000 rad/s"
phi = 0
[run]
t_end = "0.02 s"
[output]
rate = "20 kHz"
"#;

fn scene(overrides: &[&str]) -> Scene {
    parse(SCENE, overrides)
}

fn parse(text: &str, overrides: &[&str]) -> Scene {
    let overrides: Vec<_> = overrides.iter().map(|text| text.to_string()).collect();
    let models: Vec<&'static Model> = MODELS.iter().map(|m| m.model).collect();
    Scene::parse("test", "test", text, &overrides, &models).unwrap_or_else(|e| panic!("{}", e.render(100, false)))
}

fn entry(scene: &Scene) -> &'static Entry {
    MODELS.iter().find(|m| m.model.name == scene.model.name).unwrap()
}

fn run(overrides: &[&str]) -> Outcome {
    run_of(SCENE, overrides)
}

fn run_of(text: &str, overrides: &[&str]) -> Outcome {
    let scene = parse(text, overrides);
    let outcome = entry(&scene).run(&scene, &mut |_| {}).unwrap();
    assert!(outcome.stopped_by.is_none(), "{:?}", outcome.stopped_by);
    outcome
}

/// The largest residual of the energy account, relative to the largest energy.
fn residual(outcome: &Outcome) -> f64 {
    let t = &outcome.trajectory;
    let size = t.kinetic.iter().chain(&t.work).fold(0.0f64, |m, x| m.max(x.abs()));
    t.residual.iter().fold(0.0f64, |m, x| m.max(x.abs())) / size
}

/// Steps of the stiffness with their jumps, damping, and a torque from a table with harmonics.
const ALL: [&str; 4] = [
    "effects=[\"stiffness_step\", \"torques\", \"damping\"]",
    "parameters.zeta=0.05",
    "laws.k.steps=[{value=\"1.43 kN*m\", width=\"1.73 rad\"}, {value=\"2.78 kN*m\"}]",
    "parameters.T0={table=[{at=\"2 ms\", value=\"5 N*m\"}, {at=\"7 ms\", value=\"25 N*m\"}, {at=\"7.5 ms\", value=\"8 N*m\"}], \
     harmonics=[{amplitude=\"3 N*m\", frequency=\"4 kHz\", phase=\"20 deg\"}, {amplitude=\"2 N*m\", frequency=\"130 Hz\"}]}",
];

#[test]
fn numerical_methods_find_the_same_motion() {
    let exact = run(&ALL);
    assert!(exact.counts.cell_changes > 4 && residual(&exact) < 1e-13, "{:e}", residual(&exact));
    for (method, tolerance, bound) in [("dop853", 1e-12, 3e-10), ("radau", 1e-9, 1e-5)] {
        let keys = [format!("run.method={method}"), format!("run.tolerance={tolerance:e}")];
        let by = [&ALL[..], &[&keys[0], &keys[1]]].concat();
        let steps = run(&by);
        assert_eq!(steps.counts.cell_changes, exact.counts.cell_changes);
        let off = crate::methods::tests::difference(&steps.trajectory, &exact.trajectory);
        assert!(off < bound, "{method}: {off:e}");
        assert!(residual(&steps) < bound, "{method}: {:e}", residual(&steps));
        let work = |o: &Outcome| o.trajectory.torque_work.iter().map(|(_, w)| w[w.len() - 1]).collect::<Vec<_>>();
        let (a, b) = (work(&steps), work(&exact));
        assert!(a.iter().zip(&b).all(|(a, b)| (a - b).abs() <= bound * b.abs()), "{method}: {a:?} {b:?}");
    }
}

/// A torque with levels: between its breakpoints the cells are those of a constant torque. One breakpoint is at a sample, one near an
/// event.
#[test]
fn levels_are_a_sequence_of_constant_torques() {
    let steps = "parameters.T0={steps=[{value=\"5 N*m\", until=\"3 ms\"}, {value=\"30 N*m\", until=\"9 ms\"}, {value=\"-2 N*m\"}]}";
    let exact = run(&[ALL[0], ALL[1], ALL[2], steps]);
    let by = run(&[ALL[0], ALL[1], ALL[2], steps, "run.method=dop853", "run.tolerance=1e-13"]);
    let off = crate::methods::tests::difference(&by.trajectory, &exact.trajectory);
    assert!(off < 1e-10 && residual(&exact) < 1e-13, "{off:e} {:e}", residual(&exact));
    // A time history with a mean only equals a constant torque, to the last bit.
    let [number, course] = ["parameters.T0=\"12 N*m\"", "parameters.T0={mean=\"12 N*m\"}"].map(|t0| run(&[t0]));
    assert_eq!(number.trajectory.q, course.trajectory.q);
    assert_eq!(number.trajectory.work, course.trajectory.work);
}

#[test]
fn a_run_in_parts_equals_the_whole_run() {
    let scene = scene(&ALL);
    let equations = DerivedModel::of::<GearPair>().equations(&scene).unwrap();
    let state = |splits: &[f64]| {
        let forcing = Forcing::of(&DerivedModel::of::<GearPair>(), &scene);
        let mut simulation =
            Simulation::exact(&*equations, &scene, start::begin(&*equations, &scene).unwrap(), forcing).unwrap();
        for t in splits.iter().chain([&scene.t_end]) {
            simulation.now.t_end = *t;
            simulation.run(None, &mut |_| {}).unwrap();
        }
        (
            simulation.now.state.q,
            simulation.now.state.q_dot,
            simulation.now.state.turns,
            simulation.now.counts.cell_changes,
        )
    };
    let whole = state(&[]);
    for splits in [&[0.007][..], &[0.002, 0.0075], &[1e-9, 0.00700001, 0.0199999]] {
        let split = state(splits);
        assert_eq!((&split.2, split.3), (&whole.2, whole.3));
        assert!((&split.0 - &whole.0).amax() < 1e-12 && (&split.1 - &whole.1).amax() < 1e-9, "{split:?} {whole:?}");
    }
}

/// Plain simulations refuse torques that vary. An ensemble runs such a scene alone.
#[test]
fn other_solvers_refuse_torques_that_vary() {
    let varying = scene(&ALL);
    let equations = DerivedModel::of::<GearPair>().equations(&varying).unwrap();
    let plain = Simulation::new(&*equations, &varying).err();
    assert_eq!(plain, Some(Refusal::Varying { torques: "`T0`".into() }));
    let scenes = [scene(&ALL), scene(&ALL[..3])];
    let together = entry(&scenes[0]).ends(&scenes);
    let alone = run(&ALL);
    let end = |o: &Outcome| o.trajectory.q.iter().map(|q| q[q.len() - 1]).collect::<Vec<_>>();
    assert_eq!(end(together[0].as_ref().unwrap()), end(&alone));
}
