//! A scene: a model, the effects it has, numbers for everything, a start and an end. SI units throughout.
//!
//! Its file:
//!
//! ```toml
//! about = "What it shows"                     # may be left out, as may all with a default below
//! model = "gear_pair"
//! effects = ["stiffness_step", "damping"]     # names out of the model; [] for none
//!
//! [parameters]                                # those of the model, each with its default if it has one
//! I1 = "2890 kg*mm^2"
//! # A torque may vary in time: levels, a ramp, or straight lines between points; and harmonics on top, a cos(2 pi f t + phase).
//! # T0 = { steps = [{ value = "0 N*m", until = "0.1 s" }, { value = "10 N*m" }] }
//! # T0 = { ramp = { from = "0 N*m", to = "10 N*m", start = "0.1 s", duration = "2 s" } }
//! # T0 = { table = [{ at = "0 s", value = "0 N*m" }, { at = "1 s", value = "8 N*m" }, { at = "4 s", value = "10 N*m" }] }
//! # T0 = { mean = "10 N*m", harmonics = [{ amplitude = "1 N*m", frequency = "120 Hz", phase = "30 deg" }] }
//!
//! [laws.k]                                    # every law of the model
//! steps = [                                   # levels over one pitch; a single one is a constant
//!     { value = "1.43 kN*m", width = "1.73 rad" },
//!     { value = "2.78 kN*m" },                # the last without a width: the rest of the pitch
//! ]
//! # ramp = "0.01 rad"                         # straight ramps of this width in place of the steps, about them
//! # In place of steps, smooth over the pitch: a Fourier series, sum a cos(order 2 pi s/pitch + phase),
//! # mean = "2.1 kN*m"
//! # harmonics = [{ order = 1, amplitude = "0.6 kN*m", phase = "30 deg" }]
//! # or a periodic cubic spline through points:
//! # table = [{ at = "0 rad", value = "1.5 kN*m" }, { at = "2 rad", value = "2.7 kN*m" }, { at = "4 rad", value = "2.2 kN*m" }]
//! # or by the teeth, the driving gear first; the phase is then 0 where a pair touches at the pitch point:
//! # teeth = [24, 96]
//! # module = "6.35 mm"
//! # face_width = "7 mm"
//! # pressure_angle = "20 deg"                 # these are the defaults; two numbers where the gears differ: [1.0, 0.8]
//! # addendum = 1                              # in modules; so dedendum = 1.25, fillet = 0.38, profile_shift = 0
//! # centre_distance = "381 mm"                # default: without backlash
//! # internal = false                          # true: the second gear is a ring
//! # young = "206 GPa"                         # and poisson = 0.3
//! # bore = "60 mm"                            # diameter; default: half the root circle
//! # method = "iso6336"                        # or "energy": bending, shear, compression, contact and body of the teeth
//! # course = "levels"                         # or "curves", what "energy" gives between the steps
//! # line_load = "60 N/mm"                     # ISO 6336-1 has less stiffness below 100 N/mm
//! # Any of them may be ahead in its pitch, k(s) = k0(s + phase):
//! # phase = 0.25                              # in pitches, or "90 deg"; of planets by teeth and place:
//! # phase = { sun = 27, at = "120 deg" }      # or { ring = 99, at = "120 deg", planet = 36 }
//!
//! # [laws.e]                                  # a transmission error, with the effect of that name: all but teeth as above, of
//! # pitch_errors = ["0 um", "3 um", "-2 um"]  # any sign; or the pitch errors of the teeth, a step each, one a pitch
//! # pitches = 24                              # default 1: steps, series or table go over so many pitches
//!
//! # [laws.side]                               # how the mesh rubs, with the effect sliding_friction; so [laws.arm]
//! # teeth_of = "k"                            # by the teeth of that law; or teeth, module, .. as above, of external gears;
//! # steps = [{ value = -1, width = "1 rad" }, { value = 1 }]      # or as any law
//!
//! [start]
//! theta = "0.1 rad"                           # a coordinate; default: the model's. "static": where the forces on it balance;
//!                                             # "static near 0.1 rad": of several such places the one found from there
//! phi_dot = "1 rad/s"                         # its speed; default: what the motions give it
//! speed = "300 rpm"                           # a motion of the model; default: 0
//!
//! [run]
//! t_end = "0.1 s"
//! precision = "plain"                         # default; or "compensated": exact cells in twice the digits
//! method = "dop853"                           # or exact, dopri5, radau, rk4, rk4_grid; default: exact where cells are linear
//! tolerance = 1e-9                            # of an adaptive method; this is the default
//! # step = "1 us"                             # of rk4, which has steps of one length
//!
//! [output]
//! rate = "20 kHz"                             # default: 10000 samples in the whole run
//! events = true                               # default
//! plots = ["energy", "motion", "spectrum"]    # default
//! csv = false                                 # default
//! most_rows = 1e7                             # a run stops when it has recorded so many; default: what 4 GB hold
//! ```

mod check;
pub mod course;
mod courses;
pub mod dimension;
pub(crate) mod document;
mod effects;
pub(crate) mod error;
mod errors;
mod field;
mod friction;
mod keys;
mod laws;
mod measure;
mod measured;
mod offset;
mod output;
mod overrides;
mod parameters;
pub mod quantity;
mod read;
mod smooth;
pub mod solver;
mod start;
mod symbol;
mod teeth;
pub mod template;
#[cfg(test)]
mod tests;
pub mod unit;

pub use course::Course;
pub use error::{Problem, SceneErrors};
pub(crate) use error::{did_you_mean, list};
pub use measured::{time, unit_of};
pub use solver::{Precision, Solver};
pub use template::Template;

use crate::model::{Law, Model, Start};
use crate::profile::Profile;

/// Plots that a scene may ask for.
pub const PLOTS: &[&str] = &["energy", "motion", "spectrum"];

/// A scene, checked and ready to run.
#[derive(Debug, Clone)]
pub struct Scene {
    /// Name: the file's stem.
    pub name: String,
    /// What it shows, in the author's words.
    pub about: String,
    /// The model it simulates.
    pub model: &'static Model,
    /// Effects it has.
    pub effects: Effects,
    /// Parameter values [SI], in the order of `model.parameters`; at t = 0, where they vary in time.
    pub parameters: Vec<f64>,
    /// Parameters that vary in time, by their numbers, and how.
    pub courses: Vec<(usize, Course)>,
    /// Mesh stiffnesses, transmission errors and laws of friction, in the order of `model.laws`; 0 for those that the scene does not have.
    pub laws: Vec<Profile>,
    /// State at t = 0.
    pub start: Beginning,
    /// End of the run [s].
    pub t_end: f64,
    /// How it is solved.
    pub solver: Solver,
    /// What is recorded and drawn.
    pub output: Output,
    /// SHA-256 of the scene's text and overrides, in hexadecimal: names the scene in every output.
    pub hash: String,
}

impl Scene {
    /// The laws that the scene has, each with what it says of it: those of the model up to the last with one of its effects. Those
    /// before it that its effects do not have are zero.
    pub fn present(&self) -> impl Iterator<Item = (&'static Law, &Profile)> {
        let names = self.effects.names(self.model);
        let last = self.model.laws.iter().rposition(|law| law.with.is_none_or(|effect| names.contains(&effect)));
        self.model.laws.iter().zip(&self.laws).take(last.map_or(0, |last| last + 1))
    }

    /// Those of them that are stiffnesses.
    pub fn stiffnesses(&self) -> impl Iterator<Item = (&'static Law, &Profile)> {
        self.present().filter(|(law, _)| law.with.is_none())
    }
}

/// A set of effects: bit `i` is `model.effects[i]`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Effects(pub u32);

/// The state at t = 0, as the scene gives it.
#[derive(Debug, Clone, PartialEq)]
pub struct Beginning {
    /// Coordinates, in the order of `model.coordinates`.
    pub q: Vec<Start>,
    /// Speeds [SI]; `None` where a rigid motion gives it, or nothing does (then 0).
    pub q_dot: Vec<Option<f64>>,
    /// Rigid motions [SI], in the order of `model.motions`; 0 where the scene gives none.
    pub motions: Vec<f64>,
}

/// What a run records and draws.
#[derive(Debug, Clone, PartialEq)]
pub struct Output {
    /// Samples a second of model time [1/s]; 10000 in the whole run if the scene does not say.
    pub rate: f64,
    /// Whether the left and right limits at every event are recorded too.
    pub events: bool,
    /// Plots to draw, by name.
    pub plots: Vec<String>,
    /// Whether the trajectory is written as CSV too.
    pub csv: bool,
    /// Rows that may be recorded: a run that has more stops, with those it has.
    pub most_rows: u64,
}
