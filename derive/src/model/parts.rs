//! The parts of a model, as its author declares them.

use crate::expr::Expr;

/// The initial value of a coordinate, unless a scene gives another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Start {
    /// At this value \[SI\].
    At(f64),
    /// The static equilibrium of this coordinate.
    Static,
}

/// Admissible values of a parameter \[SI\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Range {
    /// Any number.
    Any,
    /// Greater than zero.
    Positive,
    /// Zero or greater.
    NotNegative,
}

pub(crate) struct Coordinate {
    pub name: String,
    pub unit: String,
    pub start: Start,
    pub doc: String,
}

pub(crate) struct Parameter {
    pub name: String,
    pub unit: String,
    pub default: Option<f64>,
    /// The effect in whose closure it was declared: only scenes with this effect need it.
    pub with: Option<String>,
    pub range: Range,
    pub doc: String,
}

pub(crate) struct Deflection {
    pub name: String,
    pub value: Expr,
}

pub(crate) struct Motion {
    pub name: String,
    pub unit: String,
    pub speeds: Vec<(Expr, Expr)>,
    pub doc: String,
}
