//! A train and the derived model of the same drivetrain have the same motion, except for rounding errors.

use gearsim::run::Outcome;
use gearsim::scene::Scene;
use gearsim_tests::trains::{BRANCHES, CHAIN, PLANETARY, Pair, SHAFTS, TWO_STAGE};

use crate::common;

/// Runs of both drivetrains of a pair.
pub(crate) trait Compared {
    /// Both scenes with the same overrides.
    fn scenes(&self, overrides: &[&str]) -> [Scene; 2];
    /// Both scenes, each with its overrides.
    fn scenes_of(&self, overrides: [&[&str]; 2]) -> [Scene; 2];
    /// Runs both, and returns the largest difference of an output or an energy, relative to its largest value.
    fn compare(&self, overrides: &[&str]) -> f64;
    /// The same for these two scenes. `overrides` only appear in the printed line.
    fn apart(&self, scenes: [Scene; 2], overrides: &[&str]) -> f64;
}

impl Compared for Pair<'_> {
    fn scenes(&self, overrides: &[&str]) -> [Scene; 2] {
        self.scenes_of([overrides; 2])
    }

    fn scenes_of(&self, overrides: [&[&str]; 2]) -> [Scene; 2] {
        let path = common::root().join(format!("models/scenes/{}.toml", self.scene));
        let text = std::fs::read_to_string(path).expect("a scene");
        let listed = self.listed(&text);
        let [derived, of_train] = overrides.map(|all| all.iter().map(|text| text.to_string()).collect::<Vec<_>>());
        [(text, derived), (listed, of_train)].map(|(text, overrides)| {
            Scene::parse("both", "both.toml", &text, &overrides, &common::models())
                .unwrap_or_else(|mistakes| panic!("{}", mistakes.render(100, false)))
        })
    }

    fn compare(&self, overrides: &[&str]) -> f64 {
        self.apart(self.scenes(overrides), overrides)
    }

    fn apart(&self, scenes: [Scene; 2], overrides: &[&str]) -> f64 {
        let [derived, listed] = scenes.map(|scene| common::run(&scene));
        assert_eq!(events(&derived), events(&listed), "{}: events", self.scene);
        assert_eq!(derived.solver.method, listed.solver.method, "{}", self.scene);
        let mut worst: (f64, &str) = (0.0, "");
        let mut compared = 0;
        for (name, a) in columns(&derived) {
            let Some((_, b)) = columns(&listed).into_iter().find(|column| column.0 == name) else { continue };
            compared += 1;
            let off = difference(&a, &b);
            if off > worst.0 {
                worst = (off, name);
            }
        }
        assert!(compared >= 5, "{}: only {compared} columns are in both", self.scene);
        println!("{} {overrides:?}: {compared} columns, at most {:.1e} apart ({})", self.scene, worst.0, worst.1);
        worst.0
    }
}

/// Largest difference of two columns, relative to the largest value of the first.
pub(crate) fn difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len(), "numbers of rows");
    let size = a.iter().fold(1e-300, |most: f64, x| most.max(x.abs()));
    a.iter().zip(b).map(|(a, b)| (a - b).abs() / size).fold(0.0, f64::max)
}

/// The counts of events.
pub(crate) fn events(run: &Outcome) -> [u64; 5] {
    let counts = &run.counts;
    [counts.cell_changes, counts.reflections, counts.holds, counts.impacts, counts.sticks]
}

/// Energies and outputs of a run, except losses, which are near zero.
fn columns(run: &Outcome) -> Vec<(&'static str, Vec<f64>)> {
    let outputs = run.trajectory.outputs.iter().map(|(output, values)| (output.name, values.clone()));
    let energies = [("kinetic", &run.trajectory.kinetic), ("strain", &run.trajectory.strain)];
    outputs
        .chain(energies.map(|(name, values)| (name, values.clone())))
        .filter(|(name, _)| !name.contains("loss"))
        .collect()
}

#[test]
fn chains_and_branches() {
    assert!(CHAIN.compare(&[]) < 1e-12);
    assert!(CHAIN.compare(&["run.method=\"dop853\""]) < 1e-9);
    assert!(BRANCHES.compare(&[]) < 1e-11);
}

/// Torques in balance cancel exactly: the phase of the mesh is then not accelerated, and the fast kernel passes its steps, as in the derived
/// model.
#[test]
fn a_pair_in_balance_takes_as_many_evaluations_as_its_derived_model() {
    for numbers in [
        &[][..],
        &["parameters.N1=23", "parameters.N2=97", "parameters.T_motor=\"230 N*m\"", "parameters.T_load=\"970 N*m\""],
    ] {
        let overrides = [&["run.t_end=\"50 ms\""], numbers].concat();
        let [derived, listed] = SHAFTS.scenes(&overrides).map(|scene| common::run(&scene).counts);
        let [most, found] = [derived.cost.evaluations, listed.cost.evaluations].map(|n| n as f64);
        assert!(derived.cell_changes > 20 && found <= 1.1 * most, "{overrides:?}: {found} evaluations, derived {most}");
    }
}

const BACKLASH: &str = "parameters.b12=\"0.1 mm\"";
const ERROR: &str = "laws.e12={steps=[{value=\"8 um\",width=\"2 rad\"},{value=\"-3 um\"}]}";

#[test]
fn a_gear_pair_with_every_effect_of_a_mesh() {
    assert!(SHAFTS.compare(&["run.t_end=\"50 ms\""]) < 1e-9);
    let short = "run.t_end=\"20 ms\"";
    for effects in [
        "[\"torques\"]",
        "[\"stiffness_step\",\"rigid_kinematics\",\"torques\"]",
        "[\"stiffness_step\",\"frozen_phase\",\"torques\"]",
        "[\"stiffness_step\",\"torques\",\"backlash\"]",
        "[\"stiffness_step\",\"torques\",\"transmission_error_12\"]",
        "[\"stiffness_step\",\"torques\",\"transmission_error\",\"backlash_12\",\"damping\"]",
    ] {
        let effects = format!("effects={effects}");
        let beta = "parameters.beta_K=\"1 us\"";
        let off = SHAFTS.compare(&[&effects, short, BACKLASH, ERROR, beta]);
        assert!(off < 1e-8, "{effects}: {off:e}");
    }
}

#[test]
fn friction_of_flanks_by_a_numerical_method() {
    let effects = "effects=[\"stiffness_step\",\"torques\",\"sliding_friction\"]";
    let side = "laws.side12={steps=[{value=-1,width=\"3 rad\"},{value=1}]}";
    let arm = "laws.arm12={steps=[{value=\"5 mm\",width=\"3 rad\"},{value=\"6 mm\"}]}";
    let off = SHAFTS.compare(&[effects, "run.t_end=\"10 ms\"", side, arm, "parameters.mu12=0.05"]);
    assert!(off < 1e-6, "{off:e}");
}

#[test]
fn two_stages() {
    assert!(TWO_STAGE.compare(&["run.t_end=\"20 ms\""]) < 1e-8);
}

#[test]
fn planets() {
    assert!(PLANETARY.compare(&["run.t_end=\"20 ms\""]) < 1e-8);
}

/// Supports of sun and carrier are an effect of the derived model and tables of the train. Both have the same frequencies, and the same
/// motion from the static equilibrium under a torque that varies.
#[test]
fn planets_with_supports_of_sun_and_carrier() {
    let pair = Pair {
        tables: &format!("{}[supports.s]\nrotor='s'\n[supports.c]\nrotor='c'\n", PLANETARY.tables),
        renamed: &[PLANETARY.renamed, &[("speed = \"1500 rpm\"\n", "")]].concat(),
        ..PLANETARY
    };
    let both = [
        "parameters.k_s=\"80 kN*m/rad\"",
        "parameters.k_c=\"3 MN*m/rad\"",
        "parameters.T_motor={mean=\"300 N*m\",harmonics=[{amplitude=\"200 N*m\",frequency=\"700 Hz\"}]}",
        "run.t_end=\"20 ms\"",
    ];
    let held = "effects=[\"stiffness_step\",\"torques\",\"damping\",\"torsional_support\"]";
    let derived = [&both[..], &[held, "start.speed=\"0 rpm\"", "start.theta=\"static\""]].concat();
    let [derived, listed] = pair.scenes_of([&derived, &both]);
    let frequencies = |scene: &Scene| -> Vec<f64> {
        scene.modes().expect("linear cells").modes.iter().map(|mode| mode.natural).collect()
    };
    let (a, b) = (frequencies(&derived), frequencies(&listed));
    assert!(a.len() == 6 && a[0] > 10.0, "{a:?}");
    assert!(a.iter().zip(&b).all(|(a, b)| (a / b - 1.0).abs() < 1e-10), "{a:?} {b:?}");
    let off = pair.apart([derived, listed], &["supports"]);
    assert!(off < 1e-8, "{off:e}");
}

#[test]
fn compensated_precision() {
    assert!(SHAFTS.compare(&["run.t_end=\"20 ms\"", "run.precision=\"compensated\""]) < 1e-12);
}
