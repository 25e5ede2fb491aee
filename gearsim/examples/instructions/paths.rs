//! What is counted: one line each.

use gearsim::engine::equations::{Derived, Equations};
use gearsim::engine::simulate::Simulation;
use gearsim::ensemble;
use gearsim::generated::gear_pair::GearPair;
use gearsim::scene::Scene;
use gearsim_tests::oh2005;

use crate::bare::BarePair;
use crate::written::{Exact, Free, Pair, RightHandSide, Rigid, Undamped};

/// One path.
pub struct Path {
    pub name: &'static str,
    pub what: &'static str,
    /// The path that it is held to.
    pub beside: Option<&'static str>,
    /// Sets it up; what comes back is counted, and gives its number of items.
    pub prepare: fn() -> Job,
}

/// Code to count.
pub type Job = Box<dyn FnMut() -> u64>;

const fn path(name: &'static str, what: &'static str, beside: Option<&'static str>, prepare: fn() -> Job) -> Path {
    Path { name, what, beside, prepare }
}

/// All paths.
pub const PATHS: &[Path] = &[
    path("cell_by_hand", "a cell change at 4500 rpm, by a program for this pair alone, without account", None, by_hand),
    path("cell_4500rpm", "the same by the engine, guarantee and account included", Some("cell_by_hand"), || {
        cells("spectrum_4500rpm_exact", &[])
    }),
    path("cell_unwatched", "the same, where nothing is recorded", Some("cell_by_hand"), unwatched),
    path("cell_undamped", "the same without damping", None, || {
        cells("spectrum_4500rpm_exact", &["effects=[\"stiffness_step\", \"torques\"]"])
    }),
    path("cell_600rpm", "a cell change at 600 rpm", None, || cells("spectrum_600rpm_exact", &[])),
    path("cell_compensated", "a cell change at 4500 rpm in twice the digits", None, || {
        cells("spectrum_4500rpm_exact", &["run.precision=compensated"])
    }),
    path("cell_in_a_lane", "a cell change at 4500 rpm, one of eight side by side", Some("cell_4500rpm"), lanes),
    path("exact_by_hand", "right-hand side, Eqs. (2), (3), damped", None, || written(Exact(PAIR))),
    path("exact_generated", "the same, generated", Some("exact_by_hand"), || {
        generated("stiffness_step damping torques")
    }),
    path("rigid_by_hand", "right-hand side, Eqs. (4), (5), damped", None, || written(Rigid(PAIR))),
    path("rigid_generated", "the same, generated", Some("rigid_by_hand"), || {
        generated("stiffness_step rigid_kinematics damping torques")
    }),
    path("free_by_hand", "right-hand side, no effects", None, || written(Free(PAIR))),
    path("free_generated", "the same, generated", Some("free_by_hand"), || generated("")),
    path("undamped_by_hand", "right-hand side, Eqs. (2), (3), without damping", None, || written(Undamped(PAIR))),
    path("undamped_generated", "the same, generated: damping not named", Some("undamped_by_hand"), || {
        generated("stiffness_step torques")
    }),
    path("undamped_undeclared", "the same, of a model that never declared damping", Some("undamped_generated"), || {
        right_hand_side(BarePair::equations(0b11, &[24.0, 96.0, 2.89e-3, 0.7402, 10.0], &[2105.0]))
    }),
];

/// The pair of the paper, zeta 0.05, 10 N m.
const PAIR: Pair = Pair { m1: 93_429.0, m2: 105_881.0, c: 0.0141, t0: 10.0 };
/// Evaluations of a right-hand side.
const EVALUATIONS: u64 = 10_000;

fn scene(name: &str, overrides: &[&str]) -> Scene {
    let path = format!("{}/../models/scenes/oh2005/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let mut all = vec!["run.t_end=0.3 s".to_string()];
    all.extend(overrides.iter().map(|text| text.to_string()));
    Scene::load(path.as_ref(), &all, &[&GearPair::MODEL]).unwrap_or_else(|e| panic!("{}", e.render(100, false)))
}

fn equations(scene: &Scene) -> &'static dyn Equations<2> {
    let equations = GearPair::equations(scene.effects.0, &scene.parameters, &[scene.laws[0].mid()]);
    Box::leak(equations.expect("the scene was checked"))
}

fn simulation(scene: &Scene) -> Simulation<'static, 2> {
    let mut simulation = Simulation::new(scene.model, equations(scene), scene).expect("the scene is sound");
    if scene.solver.precision == gearsim::scene::Precision::Compensated {
        gearsim::engine::outcome::compensate::<GearPair, 2>(&mut simulation, scene).expect("its damping is modal");
    }
    simulation
}

fn cells(name: &str, overrides: &[&str]) -> Job {
    let mut simulation = simulation(&scene(name, overrides));
    Box::new(move || {
        simulation.run(None, &mut |_| {}).expect("the run ends");
        simulation.counts.cell_changes
    })
}

/// The hand-written solver that `benches/cell_change.rs` measures against, on the scene of `cell_4500rpm`.
fn by_hand() -> Job {
    let pair = oh2005::GearPair::paper(0.05, 10.0);
    let start = pair.start(4500.0);
    Box::new(move || pair.solve_fast(start.theta, start.theta_dot, start.phi, start.phi_dot, 0.3).cell_changes)
}

fn unwatched() -> Job {
    let mut simulation = [simulation(&scene("spectrum_4500rpm_exact", &[]))];
    Box::new(move || {
        assert!(ensemble::run(&mut simulation).iter().all(Result::is_ok));
        simulation[0].counts.cell_changes
    })
}

fn lanes() -> Job {
    let torques =
        (0..32).map(|i| scene("spectrum_4500rpm_exact", &[&format!("parameters.T0={} N*m", 5.0 + 0.2 * f64::from(i))]));
    let mut all: Vec<_> = torques.map(|scene| simulation(&scene)).collect();
    Box::new(move || {
        assert!(ensemble::run(&mut all).iter().all(Result::is_ok));
        all.iter().map(|simulation| simulation.counts.cell_changes).sum()
    })
}

fn generated(effects: &str) -> Job {
    let names: Vec<_> = effects.split_whitespace().map(|name| format!("\"{name}\"")).collect();
    let scene = scene("spectrum_4500rpm_exact", &[&format!("effects=[{}]", names.join(", "))]);
    right_hand_side(GearPair::equations(scene.effects.0, &scene.parameters, &[scene.laws[0].mid()]))
}

fn right_hand_side(equations: Option<Box<dyn Equations<2>>>) -> Job {
    let equations = equations.expect("effects that go together");
    evaluated(move |q, v, k, dk| equations.acceleration(q, v, k, dk))
}

fn written(by_hand: impl RightHandSide + 'static) -> Job {
    // Behind a pointer, as the generated ones are.
    let by_hand: Box<dyn RightHandSide> = Box::new(by_hand);
    evaluated(move |q, v, k, dk| by_hand.acceleration(q, v, k, dk))
}

fn evaluated(f: impl Fn(&[f64; 2], &[f64; 2], &[f64], &[f64]) -> [f64; 2] + 'static) -> Job {
    Box::new(move || {
        let (mut q, mut v) = ([0.1, 7e-3], [1800.0, 0.3]);
        let (k, dk) = (std::hint::black_box(vec![1430.0]), std::hint::black_box(vec![7.0]));
        for _ in 0..EVALUATIONS {
            let a = f(&q, &v, &k, &dk);
            (q[1], v[1]) = (q[1] + 1e-12 * a[0], v[1] + 1e-12 * a[1]);
        }
        std::hint::black_box((q, v));
        EVALUATIONS
    })
}
