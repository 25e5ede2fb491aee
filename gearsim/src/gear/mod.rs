//! Gears by their teeth: the geometry of an involute pair, and the stiffness of its mesh. Pure functions, SI units.
//!
//! - `involute`: the involute function and its inverse;
//! - `pair`: [`Gears`], what a drawing says; [`Contact`], how they touch: path of contact, contact ratio, where pairs enter
//!   and leave;
//! - `iso6336`: the stiffness of ISO 6336-1, method B;
//! - `tooth`, `foundation`, `energy`: the stiffness of one pair of teeth from its strain energy, along the path of contact;
//! - `mesh_stiffness`: the stiffness of the mesh as a law over the phase, by either method;
//! - `friction`: the laws of friction, by where the pairs touch and how they share the force.

mod energy;
mod foundation;
mod friction;
pub mod involute;
mod iso6336;
mod mesh_stiffness;
mod pair;
mod tooth;

pub use energy::ToothPair;
pub use friction::{FrictionLaw, friction};
pub use iso6336::{Iso6336, LINE_LOADS};
pub use mesh_stiffness::{CellShape, StiffnessMethod, stiffness};
pub use pair::{Contact, GearError, Gears, Material};
