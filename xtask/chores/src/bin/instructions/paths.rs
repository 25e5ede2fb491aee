//! The paths that are counted: an entry each.

use gearsim::__private::equations::{Derived, Equations};
use gearsim::__private::models::{GearPair, GearPairBearings, TwoStage};
use gearsim::__private::{Inside, Simulation, ensemble};
use gearsim::run::Entry;
use gearsim::scene::Scene;
use gearsim_tests::oh2005;
use gearsim_tests::trains::{PLANETARY, Pair, SHAFTS, TWO_STAGE};

use crate::bare::{BarePair, WatchedPair};
use crate::sides;

/// One path.
pub struct Path {
    pub name: &'static str,
    pub what: &'static str,
    /// The path that it is compared with.
    pub compared_with: Option<&'static str>,
    /// Largest ratio to that path that is allowed.
    pub at_most: Option<f64>,
    /// Prepares the path. Only the returned job is counted; it returns its number of items.
    pub prepare: fn() -> Job,
}

/// A job to count; returns its number of items.
pub type Job = Box<dyn FnMut() -> u64>;

const fn path(
    name: &'static str,
    what: &'static str,
    compared_with: Option<&'static str>,
    prepare: fn() -> Job,
) -> Path {
    Path { name, what, compared_with, at_most: None, prepare }
}

/// A path of a train, compared with the derived model of the same drivetrain.
const fn as_train(name: &'static str, what: &'static str, derived: &'static str, prepare: fn() -> Job) -> Path {
    Path { name, what, compared_with: Some(derived), at_most: Some(1.5), prepare }
}

/// All paths.
pub const PATHS: &[Path] = &[
    path(
        "cell_by_hand",
        "a cell change at 4500 rpm, by a program for this pair alone, without energy account",
        None,
        by_hand,
    ),
    path(
        "cell_4500rpm",
        "the same by the engine, with guaranteed crossings and energy account",
        Some("cell_by_hand"),
        || cells("spectrum_4500rpm_exact", &[]),
    ),
    path("cell_unwatched", "the same, if nothing is recorded", Some("cell_by_hand"), unwatched),
    path(
        "row_of_no_outputs",
        "a row of the pair at 4500 rpm by exact cells, whose model declares no outputs",
        None,
        || recorded::<BarePair>(None),
    ),
    // The difference that remains is the preparation of a model that declares outputs.
    Path {
        at_most: Some(1.002),
        ..path(
            "row_of_outputs_not_asked",
            "the same, from a model that declares five, of which the scene records none",
            Some("row_of_no_outputs"),
            || recorded::<WatchedPair>(Some("[]")),
        )
    },
    path("row_of_outputs", "the same, where the scene records all five", Some("row_of_no_outputs"), || {
        recorded::<WatchedPair>(None)
    }),
    path("cell_undamped", "the same without damping", None, || {
        cells("spectrum_4500rpm_exact", &["effects=[\"stiffness_step\", \"torques\"]"])
    }),
    path("cell_600rpm", "a cell change at 600 rpm", None, || cells("spectrum_600rpm_exact", &[])),
    path(
        "event_of_a_stall",
        "an event of the pair at 600 rpm under 50 N m, which stalls: 34 of 176 events are reflections",
        None,
        stall,
    ),
    path("cell_compensated", "a cell change at 4500 rpm in double-double arithmetic", None, || {
        cells("spectrum_4500rpm_exact", &["run.precision=compensated"])
    }),
    path("cell_in_a_lane", "a cell change at 4500 rpm, one of eight in SIMD lanes", Some("cell_4500rpm"), lanes),
    path("exact_by_hand", "right-hand side, Eqs. (2), (3), damped", None, || sides::exact().by_hand()),
    path("exact_generated", "the same, generated", Some("exact_by_hand"), || sides::exact().generated()),
    path("rigid_by_hand", "right-hand side, Eqs. (4), (5), damped", None, || sides::rigid().by_hand()),
    path("rigid_generated", "the same, generated", Some("rigid_by_hand"), || sides::rigid().generated()),
    path("free_by_hand", "right-hand side, no effects", None, || sides::free().by_hand()),
    path("free_generated", "the same, generated", Some("free_by_hand"), || sides::free().generated()),
    path("undamped_by_hand", "right-hand side, Eqs. (2), (3), without damping", None, || sides::undamped().by_hand()),
    path(
        "undamped_generated",
        "the same, generated: the scene does not name damping",
        Some("undamped_by_hand"),
        || sides::undamped().generated(),
    ),
    path(
        "undamped_undeclared",
        "the same, from a model that does not declare damping, transmission errors, play and friction",
        Some("undamped_generated"),
        || sides::undeclared().generated(),
    ),
    path("error_by_hand", "right-hand side, Eqs. (2), (3) with a transmission error", None, || {
        sides::with_error().by_hand()
    }),
    path("error_generated", "the same, generated", Some("error_by_hand"), || sides::with_error().generated()),
    path("play_by_hand", "right-hand side, Eqs. (2), (3) with backlash, damped", None, || sides::with_play().by_hand()),
    path("play_generated", "the same, generated", Some("play_by_hand"), || sides::with_play().generated()),
    path("friction_by_hand", "right-hand side, Eqs. (2), (3) with sliding friction", None, || {
        sides::with_friction().by_hand()
    }),
    path("friction_generated", "the same, generated", Some("friction_by_hand"), || sides::with_friction().generated()),
    path("chain_5_by_hand", "forces on a chain of 5 discs, damped", None, || sides::chain().by_hand()),
    path("chain_5_generated", "the same, generated", Some("chain_5_by_hand"), || sides::chain().generated()),
    path("idler_by_hand", "forces on an idler train, damped", None, || sides::idler().by_hand()),
    path("idler_generated", "the same, generated", Some("idler_by_hand"), || sides::idler().generated()),
    path("planetary_3_by_hand", "forces on a planetary stage with 3 planets", None, || sides::planetary().by_hand()),
    path("planetary_3_generated", "the same, generated", Some("planetary_3_by_hand"), || {
        sides::planetary().generated()
    }),
    path("method_pair", "a step of dop853, the pair at 4500 rpm, with energy account", None, || {
        steps::<GearPair>(
            "oh2005/spectrum_4500rpm_exact",
            &["run.method=dop853", "output.rate=1 kHz", "output.events=false"],
        )
    }),
    path("method_two_stage", "a step of dop853, two stages", None, || {
        steps::<TwoStage>("two_stage", &["run.method=dop853", "output.rate=1 kHz", "output.events=false"])
    }),
    path("method_friction", "a step of dop853, a pair on bearings with sliding friction", None, || {
        steps::<GearPairBearings>("sliding_friction", &["output.rate=1 kHz", "output.events=false"])
    }),
    path("derived_shafts", "a row of a pair between shafts, 20 ms by exact cells with all outputs", None, || {
        derived(&SHAFTS, "exact")
    }),
    as_train(
        "train_shafts",
        "the same as a train, whose equations are put together from those of its parts",
        "derived_shafts",
        || train(&SHAFTS, "exact"),
    ),
    path("derived_two_stage", "a row of two stages, 20 ms by exact cells with all outputs", None, || {
        derived(&TWO_STAGE, "exact")
    }),
    as_train("train_two_stage", "the same as a train", "derived_two_stage", || train(&TWO_STAGE, "exact")),
    path("derived_planets", "a row of a planetary stage, 20 ms by exact cells with all outputs", None, || {
        derived(&PLANETARY, "exact")
    }),
    as_train("train_planets", "the same as a train", "derived_planets", || train(&PLANETARY, "exact")),
    path("derived_two_stage_by_steps", "a row of two stages, 20 ms by dop853 with all outputs", None, || {
        derived(&TWO_STAGE, "dop853")
    }),
    as_train("train_two_stage_by_steps", "the same as a train", "derived_two_stage_by_steps", || {
        train(&TWO_STAGE, "dop853")
    }),
    path("derived_planets_by_steps", "a row of a planetary stage, 20 ms by dop853 with all outputs", None, || {
        derived(&PLANETARY, "dop853")
    }),
    as_train("train_planets_by_steps", "the same as a train", "derived_planets_by_steps", || {
        train(&PLANETARY, "dop853")
    }),
];

fn scene(name: &str, overrides: &[&str]) -> Scene {
    of_model::<GearPair>(&format!("oh2005/{name}"), "0.3 s", overrides)
}

fn of_model<D: Derived>(name: &str, t_end: &str, overrides: &[&str]) -> Scene {
    let path = format!("{}/../../models/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let mut all = vec![format!("run.t_end={t_end}")];
    all.extend(overrides.iter().map(|text| text.to_string()));
    Scene::load_with(path.as_ref(), &all, &[&D::MODEL]).unwrap_or_else(|e| panic!("{}", e.render(100, false)))
}

/// A run by a method by steps; its items are the steps, accepted and rejected.
fn steps<D: Derived>(name: &str, overrides: &[&str]) -> Job {
    let scene = of_model::<D>(name, "0.02 s", overrides);
    Box::new(move || {
        let outcome = Entry::new::<D>().run(&scene, &mut |_| {}).expect("the scene is sound");
        outcome.solver.steps + outcome.solver.rejected
    })
}

/// A run by exact cells of a pair with stiffness steps and torques alone, at 4500 rpm; its items are the rows. It is long, so that
/// the preparation of the run counts little.
fn recorded<D: Derived>(record: Option<&str>) -> Job {
    let entry = Entry::new::<D>();
    gearsim::add_models(&[entry]);
    let scene = Scene::of_model(D::MODEL.name).effects(&["stiffness_step", "torques"]);
    let scene = scene.set("parameters.I1", "2890 kg*mm^2").set("parameters.I2", "740200 kg*mm^2");
    let scene = scene.set("parameters.T0", "10 N*m").set("start.theta_dot", "11310 rad/s").set("run.t_end", "1 s");
    let steps = "[{ value = \"1.43 kN*m\", width = \"1.73 rad\" }, { value = \"2.78 kN*m\" }]";
    let scene = scene.set("laws.k.steps", steps).set("output.rate", "20 kHz").set("output.events", false);
    let scene = record.into_iter().fold(scene, |scene, record| scene.set("output.record", record)).build();
    let scene = scene.expect("the scene is sound");
    Box::new(move || {
        let outcome = entry.run(&scene, &mut |_| {}).expect("the scene is sound");
        outcome.trajectory.len() as u64
    })
}

/// Runs of a drivetrain as a derived model, and as a train, with their preparation; their items are the rows.
fn derived(pair: &Pair<'_>, method: &'static str) -> Job {
    rows(text(pair), method)
}

fn train(pair: &Pair<'_>, method: &'static str) -> Job {
    rows(pair.listed(&text(pair)), method)
}

fn text(pair: &Pair<'_>) -> String {
    let path = format!("{}/../../models/scenes/{}.toml", env!("CARGO_MANIFEST_DIR"), pair.scene);
    std::fs::read_to_string(path).expect("the scene is there")
}

fn rows(text: String, method: &'static str) -> Job {
    let scene = gearsim::Scene::from_toml("counted", &text).and_then(|scene| scene.with("run.method", method));
    let scene = scene.and_then(|scene| scene.with("run.t_end", "20 ms")).expect("the scene is sound");
    Box::new(move || scene.run().expect("the run ends").outcome.trajectory.len() as u64)
}

fn equations(scene: &Scene) -> &'static dyn Equations {
    let equations = GearPair::equations(&scene.effects, &scene.parameters, &[scene.laws[0].mid()]);
    Box::leak(equations.expect("the scene was checked"))
}

fn simulation(scene: Scene) -> Simulation<'static> {
    // The scene is kept to the end of the program, like its equations: the compensated solver looks up its laws.
    let scene: &'static Scene = Box::leak(Box::new(scene));
    let mut simulation = Simulation::new(equations(scene), scene).expect("the scene is sound");
    if scene.solver.precision == gearsim::scene::Precision::Compensated {
        simulation = Entry::new::<GearPair>().compensate(simulation, scene).expect("its damping is modal");
    }
    simulation
}

fn cells(name: &str, overrides: &[&str]) -> Job {
    let mut simulation = simulation(scene(name, overrides));
    Box::new(move || {
        simulation.run(None, &mut |_| {}).expect("the run ends");
        simulation.now.counts.cell_changes
    })
}

fn stall() -> Job {
    let mut simulation = simulation(scene("spectrum_600rpm_exact", &["parameters.T0=50 N*m", "run.t_end=0.8 s"]));
    Box::new(move || {
        simulation.run(None, &mut |_| {}).expect("the run ends");
        simulation.now.counts.events()
    })
}

/// The hand-written solver of `benches/cell_change.rs`, on the scene of `cell_4500rpm`.
fn by_hand() -> Job {
    let pair = oh2005::GearPair::paper(0.05, 10.0);
    let start = pair.start(4500.0);
    Box::new(move || pair.solve_fast(start.theta, start.theta_dot, start.phi, start.phi_dot, 0.3).cell_changes)
}

fn unwatched() -> Job {
    let mut simulation = [simulation(scene("spectrum_4500rpm_exact", &[]))];
    Box::new(move || {
        assert!(ensemble::run(&mut simulation).iter().all(Result::is_ok));
        simulation[0].now.counts.cell_changes
    })
}

fn lanes() -> Job {
    let torques =
        (0..32).map(|i| scene("spectrum_4500rpm_exact", &[&format!("parameters.T0={} N*m", 5.0 + 0.2 * f64::from(i))]));
    let mut all: Vec<_> = torques.map(simulation).collect();
    Box::new(move || {
        assert!(ensemble::run(&mut all).iter().all(Result::is_ok));
        all.iter().map(|simulation| simulation.now.counts.cell_changes).sum()
    })
}
