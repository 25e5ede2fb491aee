//! A scene: a model, its active effects, values for its parameters and laws, an initial state and an end time. SI units throughout.
//!
//! Format of a scene file:
//!
//! ```toml
//! about = "What it shows"                     # optional, like every key with a default below
//! model = "gear_pair"
//! effects = ["stiffness_step", "damping"]     # names of effects of the model; [] for none
//!
//! [parameters]                                # the parameters of the model; one with a default may be left out
//! I1 = "2890 kg*mm^2"
//! # A torque may vary in time: levels, a ramp, or lines between points. Harmonics a cos(2 pi f t + phase) can be added.
//! # T0 = { steps = [{ value = "0 N*m", until = "0.1 s" }, { value = "10 N*m" }] }
//! # T0 = { ramp = { from = "0 N*m", to = "10 N*m", start = "0.1 s", duration = "2 s" } }
//! # T0 = { table = [{ at = "0 s", value = "0 N*m" }, { at = "1 s", value = "8 N*m" }, { at = "4 s", value = "10 N*m" }] }
//! # T0 = { mean = "10 N*m", harmonics = [{ amplitude = "1 N*m", frequency = "120 Hz", phase = "30 deg" }] }
//!
//! [laws.k]                                    # one table for each law of the model
//! steps = [                                   # levels over one pitch; a single level is a constant
//!     { value = "1.43 kN*m", width = "1.73 rad" },
//!     { value = "2.78 kN*m" },                # the last level may omit its width: it takes the rest of the pitch
//! ]
//! # ramp = "0.01 rad"                         # replaces each step by a straight ramp of this width, centred on the step
//! # Instead of steps, a law that is smooth over the pitch: a Fourier series, mean + sum a cos(order 2 pi s/pitch + phase),
//! # mean = "2.1 kN*m"
//! # harmonics = [{ order = 1, amplitude = "0.6 kN*m", phase = "30 deg" }]
//! # or a periodic cubic spline through points:
//! # table = [{ at = "0 rad", value = "1.5 kN*m" }, { at = "2 rad", value = "2.7 kN*m" }, { at = "4 rad", value = "2.2 kN*m" }]
//! # or computed from the teeth, driving gear first; the phase is then 0 where a tooth pair touches at the pitch point:
//! # teeth = [24, 96]
//! # module = "6.35 mm"
//! # face_width = "7 mm"
//! # pressure_angle = "20 deg"                 # default, as are the values below where no other default is stated
//! # addendum = 1                              # in modules; two numbers where the gears differ: [1.0, 0.8]
//! #                                           # likewise dedendum = 1.25, profile_shift = 0, young, poisson and bore; fillet = 0.38 is one number
//! # centre_distance = "381 mm"                # default: the distance without backlash
//! # internal = false                          # true: the second gear is a ring gear
//! # young = "206 GPa"                         # and poisson = 0.3
//! # bore = "60 mm"                            # diameter; default: half the diameter of the root circle
//! # method = "iso6336"                        # or "energy": bending, shear and compression of the teeth, contact, gear bodies
//! # course = "levels"                         # or "curves": the stiffness varies between the steps, method "energy" only
//! # line_load = "60 N/mm"                     # tangential force per face width; ISO 6336-1 lowers the stiffness below 100 N/mm
//! # Every law may be shifted within its pitch, k(s) = k0(s + phase):
//! # phase = 0.25                              # in pitches, or an angle: "90 deg"; for planets, from tooth numbers and position:
//! # phase = { sun = 27, at = "120 deg" }      # or { ring = 99, at = "120 deg", planet = 36 }
//!
//! # [laws.e]                                  # a transmission error, for the effect transmission_error: any sign, all forms but teeth;
//! # pitch_errors = ["0 um", "3 um", "-2 um"]  # or the pitch errors of the teeth: one level a pitch
//! # pitches = 24                              # number of pitches that steps, series or table cover; default 1
//!
//! # [laws.side]                               # a friction law, for the effect sliding_friction; [laws.arm] likewise
//! # teeth_of = "k"                            # computed from the teeth of that law; or teeth, module, ... as above (external gears);
//! # steps = [{ value = -1, width = "1 rad" }, { value = 1 }]      # or any other form
//!
//! [start]
//! theta = "0.1 rad"                           # a coordinate; default: set by the model. "static": static equilibrium;
//!                                             # "static near 0.1 rad": of several equilibria, the one found from this value
//! phi_dot = "1 rad/s"                         # speed of a coordinate; default: its speed in the rigid motions below
//! speed = "300 rpm"                           # a rigid motion of the model; default: 0
//!
//! [run]
//! t_end = "0.1 s"
//! precision = "plain"                         # default; or "compensated": the exact method with twice the digits
//! method = "dop853"                           # or exact, dopri5, radau, rk4, rk4_grid; default: exact where cells are linear
//! tolerance = 1e-9                            # relative error of a step, for adaptive methods; default 1e-9
//! # step = "1 us"                             # fixed step length of rk4 and rk4_grid
//!
//! [output]
//! rate = "20 kHz"                             # samples per second; default: 10000 samples over the run
//! events = true                               # record both sides of each event; default
//! record = ["mesh_force_12", "dte_12"]        # outputs of the model; default: all that the effects of the scene have
//! plots = ["outputs", "orders", "spectrum"]   # default: the plots for which the scene records something, without order_cuts and run_up
//! spectrum = { of = ["mesh_force_12"], kind = "amplitude", scale = "dB", reference = "1 N", from = "0.1 s" }
//! # of: recorded outputs and coordinates; kind: "psd" (default), "amplitude" (peak) or "rms"; scale: "log" (default) or "dB";
//! # reference: of levels in dB, one or several: ["1 N", "1 um"]; from: where the transformed record begins, default 0
//! rainflow = ["mesh_force_12"]                # load spectra of these recorded outputs and coordinates; default: none
//! sound = { of = ["mesh_force_12"], stretch = 10 }     # WAV files of them, ten times as slow; default: none; stretch: 1
//! csv = false                                 # default
//! most_rows = 1e7                             # the run stops when this many rows are recorded; default: as many as fit in 1 GB
//! ```

mod check;
mod damage;
pub mod dimension;
pub(crate) mod document;
mod effects;
mod field;
mod friction;
mod gear_data;
mod key_unit;
mod keys;
mod laws;
mod mesh_phase;
pub(crate) mod mistake;
mod output;
mod overrides;
mod parameters;
pub mod quantity;
mod read;
mod smooth;
pub mod solver;
mod sound;
mod spectrum;
mod start;
mod symbol;
mod teeth;
pub mod template;
#[cfg(test)]
mod tests;
pub mod time_history;
mod train;
mod transmission_error;
pub mod unit;

pub use key_unit::unit_of;
pub(crate) use keys::{reference, schema};
pub use mistake::{Mistake, SceneMistakes};
pub(crate) use mistake::{did_you_mean, list, shown};
pub use solver::{Precision, Solver};
pub use sound::Sound;
pub use spectrum::{Reference, Spectrum, SpectrumKind};
pub use template::Template;
pub use time_history::TimeHistory;

use std::sync::Arc;

use crate::gear::Gears;
use crate::model::{Law, Model, Start};
use crate::profile::Profile;
use crate::train::Train;

/// Plots that a scene may ask for.
pub const PLOTS: &[&str] =
    &["outputs", "orders", "energy", "spectrum", "motion", "order_cuts", "run_up", "rainflow", "load_duration"];

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
    pub train: Option<Arc<Train>>,
    /// Active effects.
    pub effects: Effects,
    /// Parameter values [SI], in the order of `model.parameters`; for a parameter that varies in time, its value at t = 0.
    pub parameters: Vec<f64>,
    /// Parameters that vary in time: index into `model.parameters`, and the value over time.
    pub time_histories: Vec<(usize, TimeHistory)>,
    /// Mesh stiffnesses, transmission errors and friction laws, in the order of `model.laws`; 0 for a law whose effect is not active.
    pub laws: Vec<Profile>,
    /// The gears of each law that is computed from teeth, in the order of `model.laws`.
    pub gears: Vec<Option<Gears>>,
    /// State at t = 0.
    pub start: InitialState,
    /// End time of the run [s].
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
    /// What is allowed, but odd: a sentence each.
    pub warnings: Vec<String>,
}

impl Scene {
    /// The laws that the equations of the scene need, each with its profile: all laws of the model up to the last one that is a stiffness
    /// or has an active effect. A law before that one whose effect is not active is included as zero, so that indices are those of the model.
    pub fn present(&self) -> impl Iterator<Item = (&'static Law, &Profile)> {
        let present = |law: &Law| law.with.is_none_or(|effect| self.effects.has(effect, self.model));
        let last = self.model.laws.iter().rposition(present);
        self.model.laws.iter().zip(&self.laws).take(last.map_or(0, |last| last + 1))
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
}

/// A set of effects: bit `i` is `model.effects[i]`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Effects(pub u64);

/// The state at t = 0, as the scene states it.
#[derive(Debug, Clone, PartialEq)]
pub struct InitialState {
    /// Coordinates, in the order of `model.coordinates`.
    pub q: Vec<Start>,
    /// Speeds [SI]; `None` where the scene states none: the speed is then that of the rigid motions, which may be 0.
    pub q_dot: Vec<Option<f64>>,
    /// Speeds of the rigid motions [SI], in the order of `model.motions`; 0 where the scene states none.
    pub motions: Vec<f64>,
}

/// What a run records and draws.
#[derive(Debug, Clone, PartialEq)]
pub struct Output {
    /// Samples per second of model time [1/s]; the default gives 10000 samples over the run.
    pub rate: f64,
    /// Whether the left and right limits at every event are recorded as well.
    pub events: bool,
    /// Plots to draw, by name.
    pub plots: Vec<String>,
    /// The outputs of the model that are recorded, by their numbers.
    pub record: Vec<usize>,
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
}
