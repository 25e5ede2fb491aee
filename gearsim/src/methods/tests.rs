//! Numerical methods against the exact engine on scenes with linear cells: orders, events, energy accounts, and errors.

use crate::engine::equations::DerivedModel;
use crate::engine::equations::Equations;
use crate::engine::hybrid::Hybrid;
use crate::engine::record::Recorder;
use crate::engine::simulate::Simulation;
use crate::engine::start;
use crate::engine::{Refusal, Stop};
use crate::known::MODELS;
use crate::model::Model;
use crate::run::Outcome;
use crate::scene::Scene;
use crate::trajectory::{Moment, Trajectory};
use gearsim_generated::gear_pair::GearPair;

mod nonlinear;
mod play;
mod smooth;

use super::Method;
use super::control::Steps;
use super::dop853::DOP853;
use super::dopri5::DOPRI5;
use super::explicit::Explicit;
use super::radau::Radau;
use super::rk4::RK4;
use super::steps::{BySteps, Events, Settings};

/// The gear pair of the paper, for 0.02 s.
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
speed = "600 rpm"
[run]
t_end = "0.02 s"
[output]
rate = "5 kHz"
"#;

pub(super) fn scene(overrides: &[&str]) -> Scene {
    let overrides: Vec<_> = overrides.iter().map(|text| text.to_string()).collect();
    let models: Vec<&'static Model> = MODELS.iter().map(|m| m.model).collect();
    Scene::parse("test", "test", SCENE, &overrides, &models).unwrap_or_else(|e| panic!("{}", e.render(100, false)))
}

pub(super) fn run(overrides: &[&str]) -> Outcome {
    let outcome = try_run(overrides).unwrap();
    assert!(outcome.stopped_by.is_none(), "{:?}", outcome.stopped_by);
    outcome
}

fn try_run(overrides: &[&str]) -> Result<Outcome, Refusal> {
    let scene = scene(overrides);
    let entry = MODELS.iter().find(|m| m.model.name == scene.model.name).unwrap();
    entry.run(&scene, &mut |_| {})
}

/// The largest difference between the rows of two trajectories. Each column is scaled by its largest value, or by a millionth of the
/// largest speed if this is larger, because a coordinate at rest has only rounding errors.
pub(crate) fn difference(a: &Trajectory, b: &Trajectory) -> f64 {
    assert_eq!(a.moment, b.moment);
    let largest = b.q_dot.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    let columns = a.q.iter().zip(&b.q).chain(a.q_dot.iter().zip(&b.q_dot));
    let columns = columns.chain([(&a.dissipated, &b.dissipated)]);
    let mut most = 0.0f64;
    for (a, b) in columns {
        let size = b.iter().fold(1e-6 * largest, |m, x| m.max(x.abs()));
        most = a.iter().zip(b).fold(most, |m, (a, b)| m.max((a - b).abs() / size));
    }
    most
}

fn methods() -> Vec<(Box<dyn Method>, u32)> {
    vec![
        (Box::new(Explicit::new(RK4)), 4),
        (Box::new(Explicit::new(DOPRI5)), 5),
        (Box::new(Explicit::new(DOP853)), 8),
        (Box::new(Radau::new(1e-13)), 5),
    ]
}

/// A simulation of a scene by a method.
pub(super) fn by_steps<'a>(
    equations: &'a dyn Equations,
    scene: &Scene,
    method: Box<dyn Method>,
    settings: Settings,
) -> Simulation<'a> {
    let now = Hybrid::new(equations, scene, start::begin(equations, scene).unwrap(), None);
    let solver = BySteps::new(&now, method, settings);
    Simulation::with(now, Box::new(solver)).unwrap()
}

/// A run by `method` in steps of length `h`.
fn fixed(equations: &dyn Equations, scene: &Scene, method: Box<dyn Method>, h: f64) -> Trajectory {
    let (steps, events) = (Steps::Fixed(h), Events::Located);
    let settings = Settings { steps, events, give_way: false, most_steps: u64::MAX };
    let mut simulation = by_steps(equations, scene, method, settings);
    let (lengths, now) = (simulation.turn_lengths(), &simulation.now);
    let mut recorder = Recorder::new(scene, equations, lengths, now.state.clone(), &now.k);
    simulation.run(Some((&mut recorder, scene.output.rate, scene.output.events)), &mut |_| {}).unwrap();
    recorder.trajectory
}

/// With steps of fixed length, and a dozen steps of the stiffness in the run, the states at events and at the end converge to the exact
/// ones with the order of the method. If the error of the event location were larger, the observed order would be lower.
#[test]
fn methods_have_their_orders_across_jumps() {
    let exact = run(&["output.rate=\"50 Hz\""]).trajectory;
    let scene = scene(&["output.rate=\"50 Hz\""]);
    let equations = DerivedModel::of::<GearPair>().equations(&scene).unwrap();
    assert!(exact.moment.iter().filter(|m| **m == Moment::Before).count() >= 8);
    for i in 0..methods().len() {
        let (name, order) = (methods()[i].0.name(), methods()[i].1);
        let coarse = if order == 8 { 1e-4 } else { 1.5e-5 };
        let errors: Vec<f64> = [1.0, 0.5, 0.25]
            .map(|part| fixed(&*equations, &scene, methods().swap_remove(i).0, coarse * part))
            .iter()
            .map(|run| difference(run, &exact))
            .collect();
        let slope = (errors[0] / errors[2]).log2() / 2.0;
        println!("{name}: {errors:?}, slope {slope:.2}");
        // Over two halvings the next order changes the slope by a few per cent.
        assert!((slope - f64::from(order)).abs() < 0.5, "{name}: slope {slope} of {errors:?}");
    }
}

/// The error of the interpolated motion falls at least as h^(order of the dense output + 1), unless the order of the method is
/// lower.
#[test]
fn dense_output_has_its_order() {
    let overrides = ["output.events=false", "run.t_end=\"0.003 s\"", "output.rate=\"70 kHz\""];
    let exact = run(&overrides).trajectory;
    let scene = scene(&overrides);
    let equations = DerivedModel::of::<GearPair>().equations(&scene).unwrap();
    for (i, expected) in [4.0, 5.0, 8.0, 4.0].into_iter().enumerate() {
        let coarse = if i == 2 { 1e-4 } else { 1.5e-5 };
        let error = |part| difference(&fixed(&*equations, &scene, methods().swap_remove(i).0, coarse * part), &exact);
        let (coarse, fine) = (error(1.0), error(0.25));
        let slope = (coarse / fine).log2() / 2.0;
        println!("{}: {coarse:e}, {fine:e}, slope {slope:.2}", methods()[i].0.name());
        assert!(slope > expected - 0.5, "{}: slope {slope}", methods()[i].0.name());
    }
}

/// Adaptive methods in a run with a dozen events and two hundred oscillations: the error is below a hundred tolerances, and the events are
/// those of the exact run.
#[test]
fn adaptive_methods_meet_their_tolerance() {
    let exact = run(&[]);
    for method in ["dopri5", "dop853", "radau"] {
        for k in [6, 8, 10] {
            let overrides = [format!("run.method={method:?}"), format!("run.tolerance=1e-{k}")];
            let outcome = run(&[&overrides[0], &overrides[1]]);
            let error = difference(&outcome.trajectory, &exact.trajectory);
            println!("{method} 1e-{k}: {error:e}, {:?}, {}", outcome.solver, outcome.counts.cost.evaluations);
            assert!(error < 100.0 * 10f64.powi(-k), "{method} at 1e-{k}: {error:e}");
            assert_eq!(outcome.counts.cell_changes, exact.counts.cell_changes);
            assert_eq!((outcome.solver.method, outcome.counts.cost.grazes), (method, 0));
        }
    }
}

/// The events are those of the exact engine: in a backward rotation, without damping, with simplified equations, and with a reflection.
#[test]
fn events_are_those_of_the_exact_engine() {
    let cases: &[&[&str]] = &[
        &["start.speed=\"-600 rpm\""],
        &["effects=[\"stiffness_step\"]", "start.phi=\"0.004 rad\""],
        &["effects=[\"stiffness_step\", \"rigid_kinematics\", \"torques\"]"],
        &["effects=[\"stiffness_step\", \"frozen_phase\", \"damping\", \"torques\"]"],
        &["effects=[\"torques\"]"],
        &["start.speed=\"60 rpm\"", "parameters.T0=\"40 N*m\""],
        &["start.speed=0", "start.theta=\"1.7 rad\"", "start.phi=\"0.02 rad\""],
        // A start one rounding error before a step, and a start exactly on it.
        &["start.theta=\"1.7299999999999998 rad\""],
        &["start.theta=\"1.73 rad\""],
    ];
    for case in cases {
        let exact = run(case);
        let events = exact.counts.events();
        for method in ["dopri5", "dop853", "radau"] {
            let method = format!("run.method={method:?}");
            let mut overrides = vec![&method[..], "run.tolerance=1e-11"];
            overrides.extend(*case);
            let outcome = run(&overrides);
            let found = (outcome.counts.cell_changes, outcome.counts.reflections);
            assert_eq!(found, (exact.counts.cell_changes, exact.counts.reflections), "{case:?} {method}");
            // Each event may amplify an error. These runs have at most 60 events.
            let error = difference(&outcome.trajectory, &exact.trajectory);
            println!("{case:?} {method}: {events} events, {error:e}");
            assert!(error < 1e-6, "{case:?} {method}: {error:e}");
            let account = outcome.trajectory.residual.iter().zip(&exact.trajectory.residual);
            let unaccounted = account.fold(0.0f64, |m, (a, b)| m.max((a - b).abs())) / exact.energy_at_start;
            assert!(unaccounted < 1e-8, "{case:?} {method}: {unaccounted:e} of the energy unaccounted for");
        }
    }
}

/// theta oscillates once towards a boundary, theta_0 + (M1/M2) phi_0 (cos wt - 1), and reverses 10^-k beyond it or before it.
/// Every method passes the boundary in the first case only. Values at samples alone would not show in which case the boundary is passed.
#[test]
fn a_crossing_shallower_than_a_step_is_found() {
    let (i1, i2): (f64, f64) = (2890e-6 / 576.0, 740200e-6 / 9216.0);
    let ratio = (1.0 / i1 - 1.0 / i2) / (1.0 / i1 + 1.0 / i2);
    let phi = 0.01;
    for method in ["dopri5", "dop853", "radau"] {
        for k in 3..9 {
            for (sign, passes) in [(1.0, true), (-1.0, false)] {
                let theta = 1.73 + 2.0 * ratio * phi - sign * 10f64.powi(-k);
                let overrides = [
                    "effects=[\"stiffness_step\"]".to_string(),
                    format!("run.method={method:?}"),
                    "run.tolerance=1e-12".to_string(),
                    format!("start.theta=\"{theta:?} rad\""),
                    "start.speed=0".to_string(),
                    format!("start.phi=\"{phi:?} rad\""),
                    // Slightly more than half a period of phi at the upper level, so that it reverses once.
                    "run.t_end=\"0.00025 s\"".to_string(),
                ];
                let outcome = run(&overrides.iter().map(String::as_str).collect::<Vec<_>>());
                assert_eq!(outcome.counts.cell_changes > 0, passes, "{method}: 1e-{k} {sign}");
            }
        }
    }
}

/// On a fixed grid without event location every method has order one, because a jump is late by up to a step.
#[test]
fn a_grid_without_events_has_order_one() {
    let end = |outcome: &Outcome| outcome.trajectory.q_dot[0].last().copied().unwrap();
    let exact = end(&run(&[]));
    let error = |h: f64| {
        let step = format!("run.step=\"{h:?} s\"");
        (end(&run(&["run.method=\"rk4_grid\"", &step])) - exact).abs() / exact
    };
    // The position of an event within a step is nearly random. So average over eight neighbouring step lengths.
    let mean = |h: f64| (0..8).map(|i| error(h * (1.0 + 0.01 * f64::from(i)))).sum::<f64>() / 8.0;
    let slope = (mean(4e-5) / mean(1e-6)).log2() / 40f64.log2();
    assert!((slope - 1.0).abs() < 0.35, "slope {slope}");
}

#[test]
fn the_step_limit_stops_a_run_and_overflow_is_refused() {
    let scene = scene(&["run.method=\"dop853\"", "run.tolerance=1e-12"]);
    let equations: Box<dyn Equations> = DerivedModel::of::<GearPair>().equations(&scene).unwrap();
    let settings = Settings { steps: Steps::Adaptive(1e-12), events: Events::Located, give_way: false, most_steps: 20 };
    let mut simulation = by_steps(&*equations, &scene, Box::new(Explicit::new(DOP853)), settings);
    let stop = simulation.run(None, &mut |_| {}).unwrap_err();
    assert!(matches!(stop, Stop::Steps { steps: 20, .. }), "{stop}");
    // The energy overflows.
    let refused = try_run(&["run.method=\"dop853\"", "start.phi_dot=\"1e300 rad/s\""]).map(|_| ());
    assert_eq!(refused, Err(Refusal::StartOverflow));
}
