//! What a model is made of, as its author said it.

use symbolica::atom::Atom;

use crate::expr::{Expr, Kind};

/// Where a coordinate starts unless a scene says otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Start {
    /// At this value [SI].
    At(f64),
    /// Where the forces on it balance.
    Static,
}

/// Admissible values of a parameter [SI].
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
    /// The effect in whose closure it was declared, which alone needs it.
    pub with: Option<String>,
    pub range: Range,
    pub doc: String,
}

pub(crate) struct Law {
    pub name: String,
    pub unit: String,
    pub phase: Expr,
    pub period: f64,
    /// Without this effect it is zero. `None`: a stiffness, which is always there.
    pub with: Option<String>,
    pub role: Role,
    pub doc: String,
}

/// What a law says of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// Stiffness, never negative.
    Stiffness,
    /// Transmission error: an offset of deflections, of any sign.
    Error,
    /// Friction, of any sign or never negative: a factor of torques.
    Friction(Friction),
}

/// What a law of friction says of the pairs of teeth in contact, the pair i with the share s_i of the force at the place xi_i
/// along the line of action, from the pitch point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Friction {
    /// sum s_i sgn(xi_i): which side of the pitch point bears the force. Of any sign.
    Side,
    /// sum s_i |xi_i|: the arm of the friction about it. Never negative.
    Arm,
}

impl Law {
    /// What its value is in expressions.
    pub fn kind(&self) -> Kind {
        match self.role {
            Role::Stiffness => Kind::Law,
            Role::Error => Kind::Error,
            Role::Friction(_) => Kind::Friction,
        }
    }
}

pub(crate) struct Deflection {
    pub name: String,
    pub value: Expr,
}

/// V and D of a spring with play, by its cells: touch, damp, clip and the edge are constants of a cell.
pub(crate) struct DeadBand {
    /// The deflection beyond the band.
    pub over: String,
    pub touch: String,
    pub edge: String,
    pub damp: String,
    pub clip: String,
    pub unit: String,
    /// Half its width.
    pub half: Expr,
    /// Without this effect the band is not there: touch = damp = 1, edge = clip = 0.
    pub effect: String,
    pub doc: String,
}

impl DeadBand {
    /// Its symbols besides the deflection.
    pub fn symbols(&self) -> [(Kind, String); 4] {
        [(Kind::Touch, &self.touch), (Kind::Edge, &self.edge), (Kind::Damp, &self.damp), (Kind::Clip, &self.clip)]
            .map(|(kind, name)| (kind, name.clone()))
    }
}

pub(crate) struct Motion {
    pub name: String,
    pub unit: String,
    pub speeds: Vec<(Expr, Expr)>,
    pub doc: String,
}

pub(crate) struct Effect {
    pub name: String,
    pub requires: Vec<String>,
    pub excludes: Vec<String>,
    pub doc: String,
}

impl Effect {
    pub fn new(name: &str, requires: &[&str], excludes: &[&str], doc: &str) -> Effect {
        let owned = |names: &[&str]| names.iter().map(|name| name.to_string()).collect();
        Effect { name: name.into(), requires: owned(requires), excludes: owned(excludes), doc: doc.into() }
    }
}

/// A name for what torques are made of.
pub(crate) struct Force {
    pub name: String,
    pub value: Expr,
    /// The effect in whose closure it was named.
    pub with: Option<String>,
}

pub(crate) struct Torque {
    pub name: String,
    pub value: Expr,
    pub through: Expr,
    pub doc: String,
}

impl Torque {
    /// Its power.
    pub fn power(&self) -> Atom {
        (self.value * self.through.dot()).atom()
    }
}
