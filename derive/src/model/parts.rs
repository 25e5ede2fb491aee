//! The parts of a model, as its author declares them.

use crate::expr::{Expr, Kind, symbols};

/// The initial value of a coordinate, unless a scene gives another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Start {
    /// At this value \[SI\].
    At(f64),
    /// The static equilibrium of this coordinate.
    Static,
}

/// Admissible values of a parameter \[SI\].
#[derive(Clone, Copy, Debug)]
pub enum Range {
    /// Any number.
    Any,
    /// Greater than zero.
    Positive,
    /// Zero or greater.
    NotNegative,
    /// Greater than another parameter, which must be positive.
    Above(Expr),
}

impl Range {
    /// The name of the parameter that a value must exceed.
    pub(crate) fn above(self) -> Option<String> {
        let Range::Above(lesser) = self else { return None };
        match symbols(&lesser.atom()).as_slice() {
            [(Kind::Parameter, name)] if lesser.atom() == Expr::var(Kind::Parameter, name).atom() => Some(name.clone()),
            _ => Some(lesser.atom().to_string()),
        }
    }
}

/// The quantity of a gear that a parameter gives. Scenes check such parameters, and compare them with the teeth from which laws are
/// computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GearData {
    /// A number of teeth, a whole number.
    Teeth,
    /// A base radius \[m\].
    BaseRadius,
    /// A working pressure angle \[rad\].
    PressureAngle,
    /// The torsional stiffness \[N m/rad\] of the support of a gear. A scene may give it per squared base radius.
    Support,
}

impl GearData {
    fn unit(self) -> &'static str {
        match self {
            GearData::Teeth => "1",
            GearData::BaseRadius => "m",
            GearData::PressureAngle => "rad",
            GearData::Support => "N*m/rad",
        }
    }

    fn range(self) -> Range {
        if self == GearData::Support { Range::NotNegative } else { Range::Positive }
    }
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
    /// The effect in whose closure it was declared: only scenes with this effect use it.
    pub with: Option<String>,
    pub gear_data: Option<GearData>,
    pub range: Range,
    pub doc: String,
}

impl Parameter {
    /// A quantity of a gear, with its unit and range.
    pub fn of_gear(gear_data: GearData, name: &str, default: Option<f64>, with: Option<String>, doc: &str) -> Self {
        Parameter {
            name: name.into(),
            unit: gear_data.unit().into(),
            default,
            with,
            gear_data: Some(gear_data),
            range: gear_data.range(),
            doc: doc.into(),
        }
    }
}

pub(crate) struct Deflection {
    pub name: String,
    pub value: Expr,
}

pub(crate) struct RigidMotion {
    pub name: String,
    pub unit: String,
    pub speeds: Vec<(Expr, Expr)>,
    pub doc: String,
}
