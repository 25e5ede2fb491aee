//! The profile of a law: its values over the phase, constant between steps or smooth between kinks.
//!
//! What a scene says of a stiffness, a transmission error or the friction of a mesh, what tooth geometry gives, and what the engine
//! follows from cell to cell.

mod curve;

pub use curve::Curve;

/// A law, a stiffness, a transmission error or one of friction, over one pitch: constant between its steps, or smooth between its kinks.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// The levels over one pitch, in the order in which a positive phase meets them; means, where it follows curves.
    pub steps: Vec<Step>,
    /// What it follows in each cell; empty where it is constant there.
    pub curves: Vec<Curve>,
    /// Phase at which the first level begins, once a pitch [unit of the phase].
    pub origin: f64,
    /// Pitches after which it repeats itself: 1, of a transmission error also more, over which the levels then go.
    pub pitches: u32,
}

/// One level of a [`Profile`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// Value [unit of the law].
    pub value: f64,
    /// Phase over which it holds [unit of the phase]; the widths add up to the pitch, or the pitches.
    pub width: f64,
}
