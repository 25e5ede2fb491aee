//! The parts of a model, as its author declares them.

use symbolica::atom::{Atom, AtomCore};

use crate::expr::{Expr, Kind, symbol, symbols};

/// The initial value of a coordinate, unless a scene gives another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Start {
    /// At this value [SI].
    At(f64),
    /// The static equilibrium of this coordinate.
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
    /// The effect in whose closure it was declared: only scenes with this effect need it.
    pub with: Option<String>,
    pub range: Range,
    pub doc: String,
}

pub(crate) struct Law {
    pub name: String,
    pub unit: String,
    pub phase: Expr,
    pub period: f64,
    /// The law is zero without this effect. `None`: a stiffness, which is always present.
    pub with: Option<String>,
    pub role: Role,
    pub doc: String,
}

/// The quantity that a law gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// Stiffness, never negative.
    Stiffness,
    /// Transmission error: an offset of deflections, of any sign.
    Error,
    /// Friction law: a factor of torques.
    Friction(Friction),
}

/// The quantity that a friction law gives. Tooth pair i in contact carries the share s_i of the mesh force at the distance xi_i
/// from the pitch point along the line of action.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Friction {
    /// sum s_i sgn(xi_i): the share of the force beyond the pitch point minus the share before it. Of any sign.
    Side,
    /// sum s_i |xi_i|: the arm of the friction about the pitch point. Never negative.
    Arm,
}

impl Law {
    /// The kind of symbol that its value is.
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

pub(crate) struct Motion {
    pub name: String,
    pub unit: String,
    pub speeds: Vec<(Expr, Expr)>,
    pub doc: String,
}

pub(crate) struct Effect {
    pub name: String,
    /// The effect of which it is the one of a part: `backlash` of `backlash_12`.
    pub of: Option<String>,
    pub requires: Vec<String>,
    pub excludes: Vec<String>,
    pub doc: String,
}

impl Effect {
    pub fn new(name: &str, requires: &[&str], excludes: &[&str], doc: &str) -> Effect {
        let owned = |names: &[&str]| names.iter().map(|name| name.to_string()).collect();
        Effect { name: name.into(), of: None, requires: owned(requires), excludes: owned(excludes), doc: doc.into() }
    }
}

/// A named force, a factor in torques.
pub(crate) struct Force {
    pub name: String,
    pub value: Expr,
    /// The effect in whose closure it was declared.
    pub with: Option<String>,
}

pub(crate) struct Torque {
    pub name: String,
    pub value: Expr,
    pub through: Expr,
    /// The speed along which it works, if that is not the rate of `through`.
    pub along: Option<Expr>,
    pub doc: String,
}

impl Torque {
    /// Its power [W]: the value times the speed along which it works.
    pub fn power(&self) -> Atom {
        (self.value * self.along.unwrap_or_else(|| self.through.dot())).atom()
    }

    /// Whether it works through a displacement that is linear in the coordinates and deflections.
    pub fn is_linear(&self) -> bool {
        let moves = |e: &Atom| symbols(e).iter().any(|s| matches!(s.0, Kind::Coordinate | Kind::Deflection));
        let through = self.through.atom();
        if symbols(&through).iter().any(|s| s.0 == Kind::Function) {
            return false;
        }
        let by = |(kind, name): (Kind, String)| through.derivative(symbol(kind, &name)).expand();
        let moving = symbols(&through).into_iter().filter(|s| matches!(s.0, Kind::Coordinate | Kind::Deflection));
        self.along.is_none() && !moving.map(by).any(|slope| moves(&slope))
    }
}
