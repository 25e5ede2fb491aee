//! From energies to equations of motion, jump rules and their proofs.
//!
//! A [`Model`] collects kinetic energy T, potential V, dissipation D and torques; [`derive`] turns them into a
//! [`Derivation`], whose [`Derivation::file`] is committed under `gearsim/src/generated/`. The way, one file each:
//! `expr` (symbols), `model` (what people declare), `check` (slips), `lagrange` and `mobility` (equations of motion),
//! `cell` (linearity), `jump` (jump rules), `proof` and `squares` (identities, definiteness), `tree` and `print` (readable output), `text` and
//! `file` (the generated file).

mod cell;
mod check;
mod derivation;
mod expr;
mod file;
mod jump;
mod lagrange;
mod markers;
mod mobility;
mod model;
mod print;
mod proof;
mod slip;
mod squares;
mod text;
mod tree;

pub use derivation::{Derivation, derive};
pub use expr::{Expr, half};
pub use model::{Friction, MeshError, MeshStiffness, Model, Play, Range, Start};
pub use slip::Slip;
