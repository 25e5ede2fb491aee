//! gearsim: energy-conserving simulation of gear systems.
//!
//! A scene ([`scene`]) names a derived model ([`generated`], described by [`model`]) and the effects it has; the
//! [`engine`] runs it exactly from step to step, one of the numerical [`methods`] where cells are not linear, and
//! [`ensemble`] many scenes at once; [`run`] chooses among them; [`trajectory`] holds what was recorded, [`analysis`] and [`plot`] make
//! pictures of it, [`output`] writes files. The program in `cli` joins them.

// Units in square brackets are not links.
#![allow(rustdoc::broken_intra_doc_links)]

pub mod analysis;
pub mod cli;
pub mod engine;
pub mod ensemble;
pub mod gear;
pub mod generated;
pub mod methods;
pub mod model;
pub mod output;
pub mod plot;
pub mod profile;
pub mod run;
pub mod scene;
pub mod sweep;
pub mod trajectory;
