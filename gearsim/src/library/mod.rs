//! What programs use: read or build a scene, change it, run it, analyse it, and write or draw its results.
//!
//! ```no_run
//! use gearsim::Scene;
//!
//! fn main() -> Result<(), gearsim::Error> {
//!     let scene = Scene::load("models/scenes/two_stage.toml")?;
//!     let results = scene.with("parameters.T_motor", "120 N*m")?.run()?;
//!     println!("{:?}", results.column("mesh_force_12"));
//!     results.write("out/two_stage")?;
//!     Ok(())
//! }
//! ```
//!
//! The methods of a [`Scene`] are here, not beside its definition, because they use all that is below: the engine, the analyses, the
//! plots. The command line is made of them too.

pub mod advise;
mod analyses;
mod build;
mod compare;
pub(crate) mod equation_sets;
mod error;
pub(crate) mod evaluate;
pub(crate) mod files;
#[cfg(test)]
mod gallery;
#[cfg(feature = "html")]
pub(crate) mod interrupt;
mod job;
mod packed;
pub(crate) mod provenance;
mod results;
mod starter;
mod value;
mod vary;

pub use build::SceneBuilder;
pub use compare::Comparison;
pub use error::Error;
pub use job::{Gathering, Job, Rows};
pub use results::Results;
pub(crate) use results::finish;
pub use starter::{starter, usual_levels, usual_value};
pub use value::Value;
pub use vary::Variation;
