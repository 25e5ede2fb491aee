//! The engine: exact propagation in linear cells, guaranteed crossings, jumps that conserve energy.
//!
//! From the inside out, one file each: `mode` (one degree of freedom, exact), `modal` (matrices to modes), `cell` (a
//! motion along them), `coupling` (what more there is where damping couples them), `cells` (all of them), `signal` and `crossing` (the first boundary that a phase meets), `jump` (what speeds do there),
//! `watch` (any other linear function of the state), `contact` (a phase held at a step), `dead_band` (play), `forcing`
//! (torques that vary in time), `phase`, `clock` and `law` (angles and times without loss of digits, and where a
//! stiffness stands), `start`, `record` (rows and the energy account), `guard` (events too many or too close), `root` (the first root of a polynomial), `simulate` (the loop), `system` (equations of any number of coordinates, as analyses see them).

pub mod cascade;
pub mod cell;
pub mod cells;
pub mod clock;
pub mod compensated;
pub mod conserved;
pub mod contact;
pub mod coupling;
pub mod crossing;
pub mod dead_band;
pub mod equations;
pub mod error;
pub mod exact;
pub mod forcing;
pub mod hybrid;
pub mod jump;
pub mod lanes;
pub mod law;
pub mod modal;
pub mod mode;
pub mod motion;
pub mod order;
pub mod phase;
pub mod real;
pub mod record;
pub mod root;
pub mod signal;
pub mod simulate;
pub(crate) mod start;
pub mod system;
pub mod vector;
pub mod watch;

pub use error::{Refusal, Stop};
