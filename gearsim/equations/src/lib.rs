//! The interface between gearsim and the equations of a drivetrain model.
//!
//! - [`model`]: the description of a model; [`Effects`]: a set of its effects;
//! - [`interface`]: the trait of its equations, and the types of their arguments and results;
//! - [`vector`], [`real`]: the types of its vectors and numbers.
//!
//! Derived models need nothing else from gearsim. They are in the separate crate `gearsim-generated`, so they are compiled in parallel with
//! the engine, and not again when the engine changes.

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

/// Not part of the public interface: the items that the code of `equations!` uses. In other crates this code uses the same items of
/// `gearsim`.
pub mod __private {
    pub use crate::effects::Effects;
    pub use crate::model;
    pub use crate::vector::{Matrix, Vector};

    /// The trait of a model's equations, and the types of its arguments and results.
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
