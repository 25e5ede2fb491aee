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

/// A named function of one position, or of several.
pub(crate) struct Function {
    pub name: String,
    /// The positions: coordinates or named deflections that are linear.
    pub of: Vec<Expr>,
    /// The function, in the symbols of the positions.
    pub value: Expr,
    /// Its derivatives by the positions, if there are several.
    pub gradient: Vec<Expr>,
    /// The effect without which it is zero.
    pub with: Option<String>,
}

/// A named function, or a derivative of it.
pub(crate) struct Derivative {
    pub name: String,
    /// In the symbols of the positions.
    pub value: Atom,
    /// Its own derivatives by the positions: indices in the list of all; empty for those of the highest order.
    pub next: Vec<usize>,
}

impl Function {
    /// Derivatives of a function of one position: those of T in the Jacobian of the forces are of the third order.
    const ORDERS: usize = 4;

    /// Whether it is one of several positions: V and D may contain it, T may not.
    pub fn is_of_several(&self) -> bool {
        self.of.len() > 1
    }

    /// The function and its derivatives: of one position up to the third, of several up to the second.
    pub fn derivatives(&self) -> Vec<Derivative> {
        let by = |of: &Expr| symbols(&of.atom()).into_iter().next();
        if !self.is_of_several() {
            let name = |order: usize| format!("{}{}", "d".repeat(order), self.name);
            let mut values = vec![self.value.atom()];
            for _ in 1..Function::ORDERS {
                let last = values.last().cloned().unwrap_or_default();
                let slope = |(kind, name): (Kind, String)| last.derivative(symbol(kind, &name));
                let slope = self.of.first().and_then(by).map_or_else(Atom::default, slope);
                values.push(crate::trigonometry::shorter(&slope));
            }
            let next = |order: usize| if order + 1 < Function::ORDERS { vec![order + 1] } else { vec![] };
            return values
                .into_iter()
                .enumerate()
                .map(|(i, value)| Derivative { name: name(i), value, next: next(i) })
                .collect();
        }
        let (n, positions) = (self.of.len(), self.of.iter().filter_map(by).collect::<Vec<_>>());
        let pairs: Vec<(usize, usize)> = (0..n).flat_map(|i| (i..n).map(move |j| (i, j))).collect();
        let second = |i: usize, j: usize| 1 + n + pairs.iter().position(|p| *p == (i.min(j), i.max(j))).unwrap_or(0);
        let name = |by: &[usize]| {
            let by: String =
                by.iter().filter_map(|i| positions.get(*i)).map(|(_, name)| format!("_by_{name}")).collect();
            format!("{}{by}", self.name)
        };
        let mut all = vec![Derivative { name: name(&[]), value: self.value.atom(), next: (1..=n).collect() }];
        for (i, slope) in self.gradient.iter().enumerate() {
            let next = (0..n).map(|j| second(i, j)).collect();
            all.push(Derivative { name: name(&[i]), value: slope.atom(), next });
        }
        for &(i, j) in &pairs {
            let slope = self.gradient.get(i).map(|slope| slope.atom()).unwrap_or_default();
            let by = positions.get(j).map(|(kind, name)| symbol(*kind, name));
            let value = by.map_or_else(Atom::default, |by| slope.derivative(by));
            all.push(Derivative { name: name(&[i, j]), value, next: vec![] });
        }
        all
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
