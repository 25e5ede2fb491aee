//! The engine: exact propagation in linear cells, guaranteed crossings, jumps that conserve energy.
//!
//! From the inside out, one file each: `mode` (one degree of freedom, exact), `cell` (matrices to modes), `crossing`
//! (the first boundary met), `jump` (what speeds do there), `phase` and `clock` (angles and times without loss of
//! digits), `start`, `record` (rows and the energy account), `simulate` (the loop), `outcome` (a scene, run).

pub mod cell;
pub mod clock;
pub mod crossing;
pub mod equations;
pub mod error;
pub mod jump;
pub mod mode;
pub mod outcome;
pub mod phase;
pub mod record;
pub mod simulate;
mod start;

pub use error::{Refusal, Stop};
pub use outcome::{Entry, Outcome};
