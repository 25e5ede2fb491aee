//! Geometry of an involute gear pair, spur or helical, and the mesh stiffness and friction laws that follow from it. Pure functions, SI
//! units.
//!
//! - `involute`: the involute function and its inverse;
//! - `pair`: [`Gears`], the data of a drawing;
//! - `contact`: [`Contact`], the path of contact and the contact ratio;
//! - `iso6336`: the mesh stiffness by ISO 6336-1, method B; `internal_dynamics`: its dynamic factor;
//! - `tooth`, `foundation`, `energy`: the stiffness of one tooth pair from its strain energy, along the path of contact;
//! - `mesh_stiffness`: the stiffness of the mesh as a law over the phase, by one of the two methods;
//! - `outline`: the outlines of the teeth, for drawings in pages;
//! - `friction`: the friction laws, from the points of contact and the shares of the force;
//! - `recent`: a cache of the laws that were computed last.

mod contact;
mod energy;
mod foundation;
mod friction;
mod internal_dynamics;
pub mod involute;
mod iso6336;
mod mesh_stiffness;
#[cfg(feature = "html")]
mod outline;
mod pair;
mod recent;
mod tooth;

pub use contact::Contact;
pub use friction::FrictionLaw;
pub use internal_dynamics::InternalDynamics;
pub use iso6336::{Iso6336, LINE_LOADS};
pub use mesh_stiffness::{CellShape, StiffnessMethod, of_section};
#[cfg(feature = "html")]
pub use outline::Outlines;
pub use pair::{GearError, Gears, Material};
pub use recent::{friction, stiffness};
