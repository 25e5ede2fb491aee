//! A scene: a model, its active effects, values for its parameters and laws, an initial state and an end time. SI units throughout.
//!
//! A scene is a TOML file:
//!
//! ```toml
//! about = "A gear pair at 300 rpm"
//! model = "gear_pair"
//! effects = ["stiffness_step", "damping", "torques"]
//!
//! [parameters]
//! I1 = "2890 kg*mm^2"
//! I2 = "740200 kg*mm^2"
//! zeta = 0.1
//! T0 = "10 N*m"
//!
//! [laws.k]
//! steps = [{ value = "1.43 kN*m", width = "1.73 rad" }, { value = "2.78 kN*m" }]
//!
//! [start]
//! speed = "300 rpm"
//!
//! [run]
//! t_end = "0.1 s"
//! ```
//!
//! All keys, with units, defaults and meaning: `gearsim scene --keys`. Programs read a scene by [`Scene::load`], or build one by
//! [`Scene::of_model`].

// Each reader has the keys that it reads as a constant beside it (`KEYS`, `keys`). It refuses others, and the reference and the JSON
// schema are written from the same constants.

mod assembly;
mod check;
mod damage;
pub(crate) mod dimension;
pub(crate) mod document;
mod effects;
mod field;
mod friction;
mod gear_data;
mod inert;
mod key_unit;
mod keys;
mod laws;
mod mesh_phase;
mod meshes;
pub(crate) mod mistake;
mod output;
pub(crate) mod overrides;
mod parameters;
mod per_radius;
pub(crate) mod quantity;
mod read;
mod smooth;
pub mod solver;
mod sound;
mod spectrum;
mod start;
mod symbol;
mod teeth;
pub(crate) mod template;
#[cfg(test)]
mod tests;
pub(crate) mod text;
pub mod time_history;
mod train;
mod transmission_error;
pub(crate) mod unit;
mod unknown_effect;
mod unknown_law;

pub use crate::gear::{Contact, GearError, Gears, Material};
pub use crate::profile::{Curve, Profile, Step};
#[cfg(feature = "html")]
pub(crate) use gear_data::of_mesh;
#[doc(inline)]
pub use gearsim_equations::Effects;
pub(crate) use key_unit::unit_of;
pub(crate) use keys::{reference, schema};
pub use mistake::{Mistake, SceneMistakes};
pub(crate) use mistake::{did_you_mean, list, shown};
pub use solver::{Precision, Solver};
pub use sound::Sound;
pub use spectrum::{Reference, Spectrum, SpectrumKind};
pub(crate) use template::Template;
pub use time_history::TimeHistory;
pub(crate) use train::in_place_of;

use std::sync::Arc;
use std::time::Duration;

use crate::model::{Law, Model, Start};
use crate::train::Train;

/// Plots that a scene may ask for.
pub const PLOTS: &[&str] = &[
    "outputs",
    "orders",
    "energy",
    "spectrum",
    "motion",
    "order_cuts",
    "order_waterfall",
    "run_up",
    "rainflow",
    "load_duration",
];

/// A scene, checked and ready to run.
#[derive(Debug, Clone)]
pub struct Scene {
    /// Name: the file's stem.
    pub name: String,
    /// What the scene shows, in the author's words.
    pub about: String,
    /// The model it simulates.
    pub model: &'static Model,
    /// How the model is put together, if the scene lists its parts.
    #[doc(hidden)]
    pub train: Option<Arc<Train>>,
    /// Active effects.
    pub effects: Effects,
    /// Parameter values \[SI\], in the order of `model.parameters`; for a parameter that varies in time, its value at t = 0.
    pub parameters: Vec<f64>,
    /// Parameters that vary in time: index into `model.parameters`, and the value over time.
    pub time_histories: Vec<(usize, TimeHistory)>,
    /// Mesh stiffnesses, transmission errors and friction laws, in the order of `model.laws`; 0 for a law whose effect is not active.
    pub laws: Vec<Profile>,
    /// The gears of each law that is computed from teeth, in the order of `model.laws`.
    pub gears: Vec<Option<Gears>>,
    /// Module of the gears of the mesh of each law \[m\], in the order of `model.laws`: that of the teeth, else from base radius and number
    /// of teeth at 20 deg; `None` if the scene states neither.
    pub modules: Vec<Option<f64>>,
    /// State at t = 0.
    pub start: InitialState,
    /// End time of the run \[s\]; infinite in a scene without `[run]`, which has modes and multipliers, but no run.
    pub t_end: f64,
    /// Method, tolerance and precision.
    pub solver: Solver,
    /// What is recorded and drawn.
    pub output: Output,
    /// SHA-256 of the scene's text and overrides, in hexadecimal. It identifies the scene in every output.
    pub hash: String,
    /// Its text in TOML, as read, without overrides.
    pub text: Arc<str>,
    /// What messages call this text: the path of its file.
    pub source: Arc<str>,
    /// The values set on top of the text, each as `KEY=VALUE`.
    pub overrides: Vec<String>,
    /// One sentence for each value that was given over the square of a radius, as in papers: its conversion to SI.
    pub conversions: Vec<String>,
    /// Warnings of values that are allowed but unusual, a sentence each.
    pub warnings: Vec<String>,
}

impl Scene {
    /// The laws that the equations of the scene need, each with its profile: all laws of the model up to the last one that is a stiffness
    /// or has an active effect. A law before that one whose effect is not active is included as zero, so that indices are those of the model.
    pub fn present(&self) -> impl Iterator<Item = (&'static Law, &Profile)> {
        let present = |law: &Law| self.effects.activate(law.with, self.model);
        let last = self.model.laws.iter().rposition(present);
        self.model.laws.iter().zip(&self.laws).take(last.map_or(0, |last| last + 1))
    }

    /// The external torques that the scene has, by their numbers.
    pub fn torques(&self) -> Vec<usize> {
        self.effects.torques(self.model)
    }

    /// What linear analyses leave out: the switches of the scene's effects, each in words. There every play is closed, every clutch is
    /// open, and dry friction is absent.
    pub fn left_out_if_linear(&self) -> Vec<&'static str> {
        let active = self.model.switches.iter().filter(|switch| self.effects.has(switch.with, self.model));
        active.map(|switch| switch.doc).collect()
    }

    /// The stiffnesses among the laws of [`Scene::present`].
    pub fn stiffnesses(&self) -> impl Iterator<Item = (&'static Law, &Profile)> {
        self.present().filter(|(law, _)| law.with.is_none())
    }

    /// The mid value (max + min)/2 of each law, in the units of the laws.
    pub fn mids(&self) -> Vec<f64> {
        self.laws.iter().map(Profile::mid).collect()
    }

    /// The mid value (max + min)/2 of each of [`Scene::stiffnesses`], in their units.
    pub fn mid_stiffnesses(&self) -> Vec<f64> {
        self.stiffnesses().map(|(_, law)| law.mid()).collect()
    }
}

/// The state at t = 0, as the scene states it.
#[derive(Debug, Clone, PartialEq)]
pub struct InitialState {
    /// Coordinates, in the order of `model.coordinates`.
    pub q: Vec<Start>,
    /// Speeds \[SI\]; `None` where the scene states none: the speed is then that of the rigid motions, which may be 0.
    pub q_dot: Vec<Option<f64>>,
    /// Speeds of the rigid motions \[SI\], in the order of `model.motions`; 0 where the scene states none.
    pub motions: Vec<f64>,
}

/// What a run records and draws.
#[derive(Debug, Clone, PartialEq)]
pub struct Output {
    /// Samples per second of model time [1/s]; the default gives 10000 samples over the run. 0 in a scene without `[run]`.
    pub rate: f64,
    /// Whether the left and right limits at every event are recorded as well.
    pub events: bool,
    /// Plots to draw, by name.
    pub plots: Vec<String>,
    /// Whether these are the default plots. Some of them are replaced if the speed varies during the run.
    pub default_plots: bool,
    /// The outputs of the model that are recorded, by their numbers.
    pub record: Vec<usize>,
    /// Start of the time span of statistics, load spectra and transforms \[s\].
    pub from: f64,
    /// Which spectra are drawn, and their scale.
    pub spectrum: Spectrum,
    /// Names of the recorded signals whose load spectra are counted.
    pub rainflow: Vec<&'static str>,
    /// What is written as sound.
    pub sound: Option<Sound>,
    /// Whether the trajectory is also written as CSV.
    pub csv: bool,
    /// Largest number of rows. A run that reaches it stops and keeps its rows.
    pub most_rows: u64,
    /// Elapsed time after which a run stops and keeps its rows; no key of a scene sets it.
    pub most_time: Option<Duration>,
}
