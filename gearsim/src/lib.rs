//! gearsim: energy-conserving simulation of gear systems.
//!
//! A scene ([`scene`]) names a derived model ([`generated`], described by [`model`]) and its effects. Three solvers run scenes, and
//! [`run`] chooses among them: the [`engine`] solves linear cells exactly from event to event, the [`methods`] integrate nonlinear
//! cells numerically, and [`ensemble`] runs many scenes at once. A [`trajectory`] holds the recorded rows. [`analysis`] and [`plot`]
//! evaluate and draw it, [`output`] writes files, `page` (with the feature `html`) writes
//! interactive pages, [`sweep`] runs a scene at many parameter values. `cli` is the command-line program.
//! `tolerance` is the table of all numerical tolerances.

// Units in square brackets are not links.
#![allow(rustdoc::broken_intra_doc_links)]

// The code of `equations!` names this crate `::gearsim`, here as in every other crate.
extern crate self as gearsim;

pub mod analysis;
pub mod cli;
pub mod engine;
pub mod ensemble;
pub mod gear;
pub mod generated;
pub mod methods;
pub mod model;
pub mod output;
#[cfg(feature = "html")]
pub mod page;
pub mod plot;
pub mod profile;
pub mod run;
pub mod scene;
pub mod sweep;
mod tolerance;
pub mod trajectory;

pub use gearsim_macros::equations;
