//! Complete programs of fewer than 40 lines each, in the folder `examples` of gearsim. They read scenes of the repository, so run them from
//! its root: `cargo run --release --example run_a_scene`.
//!
//! # Run a scene
//!
#![doc = "```no_run"]
#![doc = include_str!("../examples/run_a_scene.rs")]
#![doc = "```"]
//!
//! # Build a scene in code
//!
#![doc = "```no_run"]
#![doc = include_str!("../examples/build_a_scene.rs")]
#![doc = "```"]
//!
//! # Vary a parameter
//!
#![doc = "```no_run"]
#![doc = include_str!("../examples/vary_a_parameter.rs")]
#![doc = "```"]
//!
//! # Tolerances: how forces scatter
//!
#![doc = "```no_run"]
#![doc = include_str!("../examples/tolerances.rs")]
#![doc = "```"]
//!
//! # A response curve
//!
#![doc = "```no_run"]
#![doc = include_str!("../examples/response_curve.rs")]
#![doc = "```"]
//!
//! # Natural frequencies
//!
#![doc = "```no_run"]
#![doc = include_str!("../examples/natural_frequencies.rs")]
#![doc = "```"]
//!
//! # Stability of a steady rotation
//!
#![doc = "```no_run"]
#![doc = include_str!("../examples/stability.rs")]
#![doc = "```"]
//!
//! # What an effect changes, and what it costs
//!
#![doc = "```no_run"]
#![doc = include_str!("../examples/effects_and_time.rs")]
#![doc = "```"]
//!
//! # Accuracy against time
//!
#![doc = "```no_run"]
#![doc = include_str!("../examples/accuracy_and_time.rs")]
#![doc = "```"]
//!
//! # A spectrum
//!
#![doc = "```no_run"]
#![doc = include_str!("../examples/spectrum.rs")]
#![doc = "```"]
//!
//! # Write tables and plots
//!
#![doc = "```no_run"]
#![doc = include_str!("../examples/write_a_table.rs")]
#![doc = "```"]
