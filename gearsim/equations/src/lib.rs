//! What gearsim asks of the equations of a drivetrain model.
//!
//! - [`model`]: the description of a model; [`Effects`]: a set of its effects;
//! - [`interface`]: the trait of its equations, and what their functions take and return;
//! - [`vector`], [`real`]: their numbers.
//!
//! Derived models need nothing else of gearsim. They are a crate of their own, `gearsim-generated`, so that they are compiled beside the
//! engine, and not again when the engine changes.

mod effects;
pub mod interface;
mod known;
mod linear_forces;
pub mod model;
pub mod real;
pub mod vector;

pub use effects::Effects;
pub use gearsim_macros::equations;
pub use known::Known;
pub use linear_forces::LinearForces;

/// No part of the interface: what the code of `equations!` uses. In other crates it finds the same in `gearsim`.
pub mod __private {
    pub use crate::effects::Effects;
    pub use crate::model;
    pub use crate::vector::{Matrix, Vector};

    /// The trait of a model's equations, and what its functions take and return.
    pub mod equations {
        pub use crate::interface::{
            Affine, Deflection, Derived, Equations, ExactCells, Exit, Matrices, On, Switching, accelerated, add_force,
            add_product, add_square, add_through, array, array_mut, compliance, direction, exits, gradient, matrix,
            mobility, mode, no_such, numbers, values, vector,
        };
        pub use crate::known::Known;
    }

    /// Types of numbers.
    pub mod real {
        pub use crate::real::{Df64, Double, Real};
    }
}
