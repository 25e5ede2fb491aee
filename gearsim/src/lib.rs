//! gearsim: energy-conserving simulation of gear systems.
//!
//! A [`Scene`] names a model of a drivetrain, the effects that it has, and its numbers. It is read from a file, or built in code. A run
//! gives [`Results`]: named columns, an energy account, plots, files.
//!
//! ```
//! use gearsim::Scene;
//!
//! # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))?;
//! let scene = Scene::load("models/scenes/two_stage.toml")?;
//! let results = scene.with("run.t_end", "0.02 s")?.run()?;
//! let force = results.column("mesh_force_12")?;
//! println!("{} rows, the last force is {:?} N", force.len(), force.last());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | to | use |
//! | --- | --- |
//! | read a scene, build one, change a value | [`Scene::load`], [`Scene::of_model`], [`Scene::with`], [`starter`] |
//! | run it; columns, summary, plots, files, page | [`Scene::run`], [`Results`] |
//! | run it at many values | [`Scene::vary`], [`Variation::run`], [`Variation::response`] |
//! | find out how results scatter, and why | [`Variation::design`], [`Job::statistics`], [`Job::sensitivity`] |
//! | natural frequencies, stability | [`Scene::modes`], [`Scene::floquet`] |
//! | find out which effects matter | [`Scene::advise`], [`advice`] |
//! | evaluate a run: spectra, orders, load cycles, sound | [`analysis`] |
//! | write tables, read them again; draw data of your own | [`output`], [`plot`] |
//! | use models of your own | [`add_models`], [`equations!`], [`cli::run`] |
//!
//! Complete programs are in [`examples`].
//!
//! All numbers are in SI units, unless a name or a text states another unit.

// The code of `equations!` names this crate `::gearsim`, here as in every other crate.
extern crate self as gearsim;

#[doc(hidden)]
pub mod __private;
/// What [`Scene::advise`] finds: which effects a scene needs.
///
/// The scene is compared with the same scene without one effect, or without some terms ([`Candidate`](advice::Candidate)). The deviation is
/// estimated from the settled motion or from short runs ([`Estimate`](advice::Estimate)). Then it is measured by full runs with and without
/// the effect. An effect is negligible if its deviations are at most [`LIMITS`](advice::LIMITS). [`Groups`](advice::Groups) are the
/// dimensionless numbers of the scene that indicate which effects matter.
///
/// ```no_run
/// let scene = gearsim::Scene::load("models/scenes/two_stage.toml")?;
/// for (without, estimated, measured) in scene.advise()?.negligible() {
///     println!("{without}: negligible by the estimate: {estimated:?}, by runs: {measured:?}");
/// }
/// # Ok::<(), gearsim::Error>(())
/// ```
pub mod advice {
    pub use crate::analysis::advise::groups::{Groups, Mesh};
    pub use crate::analysis::advise::{Apart, Bands, Candidate, LIMITS, Way};
    pub use crate::library::advise::{Advice, Estimate, Verdict};
}
pub mod analysis;
pub mod cli;
mod engine;
mod ensemble;
// Only for the documentation: the module contains no code.
#[cfg(any(doc, doctest))]
pub mod examples;
#[cfg(feature = "html")]
mod explore;
mod gear;
mod known;
mod library;
mod methods;
pub mod output;
#[cfg(feature = "html")]
mod page;
pub mod plot;
mod profile;
pub mod run;
pub mod scene;
pub mod sweep;
mod tolerance;
mod train;
pub mod trajectory;

#[doc(inline)]
pub use gearsim_equations::{equations, model};
pub use known::{add as add_models, models};
pub use library::{Comparison, Error, Gathering, Job, Results, Rows, SceneBuilder, Value, Variation, starter};
pub use run::{Entry, Outcome, Prospect};
pub use scene::Scene;
pub use sweep::Design;
