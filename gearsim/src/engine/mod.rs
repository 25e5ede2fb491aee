//! The engine: exact propagation in linear cells, guaranteed crossings, and jumps that conserve energy.
//!
//! The modules:
//! - `mode`: one degree of freedom, exact; `modal`: the modes of given matrices; `cell`: the motion in modes; `coupling`: modes coupled by
//!   damping; `conserved`: corrected momenta of rigid motions; `cells`: all cells of a scene;
//! - `signal` and `crossing`: the first boundary that a phase reaches; `root`: the first root of a polynomial; `jump`: the change of the
//!   speeds at a step; `watch`: zeros of other linear functions of the state;
//! - `contact`: a phase held at a step; `switch`: modes of a deflection; `forcing`: torques that vary in time;
//! - `phase`, `clock` and `law`: angles, times and the cells of laws, without loss of digits;
//! - `equations`: the equations of a scene; `train`: those of a train, from its parts; `hybrid`: the state of a run, continuous and
//!   discrete; `start`: the initial state; `record`: rows and the energy account; `known`: reactions and powers for outputs;
//! - `motion`: the interface of solvers, which compute the motion between two events; `exact`: the solver of linear cells; `compensated`:
//!   the same in double-double numbers; `lanes`: the kernel of plain events;
//! - `cascade`: events at ever shorter intervals; `order`: simultaneous steps whose order matters; `simulate`: the hybrid loop; `system`:
//!   the equations as analyses use them; `flanks`: whether a steady motion meets both flanks.
//!
//! Shapes: (n) is a vector and (n x n) a matrix of that size, where n is the number of coordinates of the model.

pub mod cascade;
pub mod cell;
pub mod cells;
pub mod clock;
pub mod compensated;
pub mod conserved;
pub mod contact;
pub mod coupling;
pub mod crossing;
pub mod equations;
pub mod error;
pub mod exact;
mod flanks;
pub mod forcing;
pub mod hybrid;
pub mod jump;
pub mod known;
pub mod lanes;
pub mod law;
pub mod modal;
pub mod mode;
pub mod motion;
pub mod order;
pub mod phase;
pub mod record;
pub mod root;
pub mod signal;
pub mod simulate;
pub(crate) mod start;
pub mod switch;
pub mod system;
pub mod train;
pub mod watch;

pub use error::{Refusal, Stop};
pub use gearsim_equations::{real, vector};
