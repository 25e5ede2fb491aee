//! The scenes that all tools run, as changes of files in models/scenes/oh2005, and the same systems for the references.

use anyhow::{Context, anyhow};
use gearsim::__private::equations::Derived;
use gearsim::__private::models;
use gearsim::scene::Scene;
use gearsim_tests::oh2005::{GearPair, State};

/// A scene.
pub struct Case {
    /// Name in the table.
    pub name: &'static str,
    /// What it tests.
    pub about: &'static str,
    /// Stem of the file in models/scenes/oh2005.
    file: &'static str,
    /// Changes of the file, as for `--set`.
    set: &'static [&'static str],
    /// Further changes for a quick run.
    quick: &'static [&'static str],
}

/// All scenes.
pub const CASES: &[Case] = &[
    Case {
        name: "4500 rpm",
        about: "as in the paper: fast, nearly even rotation, no hard cases",
        file: "spectrum_4500rpm_exact",
        set: &[],
        quick: &["run.t_end=0.05 s"],
    },
    Case {
        name: "600 rpm",
        about: "the paper's slow case with three times the torque: strong jumps",
        file: "spectrum_600rpm_exact",
        set: &["parameters.T0=30 N*m"],
        quick: &["run.t_end=0.05 s"],
    },
    Case {
        name: "stall",
        about: "loses speed, can climb the steps no more, and is caught between two of them: reflected again and again",
        file: "spectrum_600rpm_exact",
        set: &["parameters.T0=50 N*m", "run.t_end=0.8 s"],
        quick: &["start.speed=200 rpm", "run.t_end=0.2 s"],
    },
];

/// The scene called `name`.
///
/// # Errors
/// If there is none.
pub fn named(name: &str) -> anyhow::Result<&'static Case> {
    let names = || CASES.iter().map(|case| case.name).collect::<Vec<_>>().join(", ");
    CASES
        .iter()
        .find(|case| case.name == name)
        .with_context(|| format!("there is no scene `{name}`; the scenes are: {}", names()))
}

impl Case {
    /// The scene, read and checked.
    ///
    /// # Errors
    /// If the file or a change of it is not valid.
    pub fn scene(&self, quick: bool) -> anyhow::Result<Scene> {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/scenes/oh2005");
        let path = std::path::Path::new(folder).join(self.file).with_extension("toml");
        let set: Vec<_> = self.changes(quick).map(str::to_string).collect();
        Scene::load_with(&path, &set, &[&models::GearPair::MODEL]).map_err(|e| anyhow!(e.render(100, false)))
    }

    /// All changes of the file.
    fn changes(&self, quick: bool) -> impl Iterator<Item = &'static str> {
        let more = if quick { self.quick } else { &[] };
        self.set.iter().chain(more).copied()
    }

    /// The command that runs the scene with gearsim.
    pub fn command(&self, quick: bool) -> String {
        let set = self.changes(quick).map(|s| format!(" --set \"{s}\""));
        format!("gearsim run models/scenes/oh2005/{}.toml{}", self.file, set.collect::<String>())
    }
}

/// The gear pair of a scene, for the references.
pub fn pair(scene: &Scene) -> GearPair {
    let value = |name: &str| {
        let place = scene.model.parameters.iter().position(|p| p.name == name);
        place.map_or(f64::NAN, |i| scene.parameters[i])
    };
    let steps = &scene.laws[0].steps;
    GearPair {
        i1: value("I1"),
        i2: value("I2"),
        n1: value("N1"),
        n2: value("N2"),
        k1: steps[0].value,
        k2: steps[1].value,
        width1: steps[0].width,
        zeta: value("zeta"),
        t0: value("T0"),
    }
}

/// The state of the gear pair at the start: theta = 0, the speed of the scene, and phi in equilibrium under T0 in the first cell.
pub fn start(scene: &Scene, pair: &GearPair) -> State {
    let theta_dot = pair.n1 * scene.start.motions[0];
    State { theta: 0.0, theta_dot, phi: pair.t0 / pair.k1, phi_dot: 0.0 }
}
