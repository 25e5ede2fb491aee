//! From energies to equations of motion, jump rules and their proofs.
//!
//! A [`Model`] collects the kinetic energy T, the potential energy V, the dissipation function D and torques; [`derive`](fn@derive) turns
//! them into a [`Derivation`]. The text of [`Derivation::file`] is committed under `gearsim/generated/src/`.
//!
//! The stages, in order: `expr` (expressions), `model` (what an author declares), `check` (errors in a model, `slip`), `symbols`
//! (derivatives), `lagrange` and `mobility` (equations of motion, M⁻¹), `cell` (linearity), `jump` (jump rules), `proof` and
//! `squares` (identities, definiteness of M; `trigonometry`), `tree` and `print` (sorted expressions as text), `text` and `file` (the
//! generated file). `program` derives the models of a crate. `wrong` makes deliberate mistakes, to test that the proofs find them.

mod cell;
mod check;
mod derivation;
mod expr;
mod file;
mod home;
mod jump;
mod lagrange;
mod markers;
mod mobility;
mod model;
mod print;
mod program;
mod proof;
mod refute;
mod slip;
mod squares;
mod symbols;
mod text;
mod tree;
mod trigonometry;
mod wrong;

pub use derivation::{Derivation, derive};
pub use expr::{Expr, half};
pub use home::Home;
pub use model::{Boundary, Describing, Factor, GearData, Model, Range, Start, Stiffness, Switching};
pub use program::{Entry, program};
pub use slip::Slip;
pub use wrong::{Wrong, derive_wrong};
