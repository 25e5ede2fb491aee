//! Laws: periodic functions of a phase, whose values a scene gives. A law has a role: stiffness, offset of deflections, factor of torques.
//!
//! The effect of a step follows from the role of the law. A stiffness and an offset are in V: their step takes or gives energy, and the
//! speeds jump. A factor is in no energy: the speeds do not jump. [`Model::boundaries`] declares how laws switch.

use super::Model;
use crate::expr::{Expr, Kind};

/// A periodic law.
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
    /// An offset of deflections, of any sign.
    Offset,
    /// A factor of torques.
    Factor(Factor),
}

/// The quantity that a factor of torques gives. Tooth pair i in contact carries the share s_i of the mesh force at the distance xi_i
/// from the pitch point along the line of action.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Factor {
    /// sum s_i sgn(xi_i): the share of the force beyond the pitch point minus the share before it. Of any sign.
    Side,
    /// sum s_i |xi_i|: the arm of the force about the pitch point. Never negative.
    Arm,
}

/// The symbols of a stiffness.
#[derive(Clone, Copy, Debug)]
pub struct Stiffness {
    /// Its value at the present phase.
    pub value: Expr,
    /// Its derivative by the phase. The derived equations contain it, energies may not.
    pub slope: Expr,
    /// Its mid value, (max + min)/2 over one pitch.
    pub mid: Expr,
}

impl Law {
    /// The kind of the symbol of its value.
    pub fn kind(&self) -> Kind {
        match self.role {
            Role::Stiffness => Kind::Law,
            Role::Offset => Kind::Error,
            Role::Factor(_) => Kind::Friction,
        }
    }
}

impl Model {
    /// Declares a stiffness [unit]: a law that is periodic with `period` of `phase`, never negative, whose steps or curve the scene gives.
    pub fn stiffness_law(&mut self, name: &str, unit: &str, phase: Expr, period: f64, doc: &str) -> Stiffness {
        self.law(name, unit, (phase, period), None, Role::Stiffness, doc);
        Stiffness {
            value: Expr::var(Kind::Law, name),
            slope: Expr::var(Kind::Slope, &format!("d{name}")),
            mid: Expr::var(Kind::Mid, &mid_name(name)),
        }
    }

    /// Declares an offset e of deflections [their unit], of any sign: a law with the arguments of [`Model::stiffness_law`]. It belongs to
    /// the effect whose closure is running, and is zero in scenes without this effect. Subtract it from a deflection, so that V = k (delta
    /// - e)^2/2.
    ///
    /// Dampers act on the rate of delta, not of delta - e: the rate of e is infinite at a step.
    pub fn offset_law(&mut self, name: &str, unit: &str, phase: Expr, period: f64, doc: &str) -> Expr {
        let with = self.innermost();
        self.law(name, unit, (phase, period), with, Role::Offset, doc);
        Expr::var(Kind::Error, name)
    }

    /// Declares a factor of torques [unit]: a law with the arguments of [`Model::stiffness_law`]. It belongs to the effect whose closure is
    /// running, and is zero in scenes without this effect. Only torques of this effect may have it as a factor; they may then depend on
    /// deflections and stiffnesses too. It is in no energy, so the speeds are continuous where it steps.
    pub fn factor_law(&mut self, name: &str, unit: &str, phase: Expr, period: f64, what: Factor, doc: &str) -> Expr {
        let with = self.innermost();
        self.law(name, unit, (phase, period), with, Role::Factor(what), doc);
        Expr::var(Kind::Friction, name)
    }

    /// Inserts a law in the order of roles: stiffnesses, which are always present, then offsets, then factors.
    fn law(
        &mut self,
        name: &str,
        unit: &str,
        (phase, period): (Expr, f64),
        with: Option<String>,
        role: Role,
        doc: &str,
    ) {
        let order = |role: Role| match role {
            Role::Stiffness => 0,
            Role::Offset => 1,
            Role::Factor(_) => 2,
        };
        let place = self.laws.iter().take_while(|law| order(law.role) <= order(role)).count();
        let law = Law { name: name.into(), unit: unit.into(), phase, period, with, role, doc: doc.into() };
        self.laws.insert(place, law);
    }
}

pub(crate) fn mid_name(law: &str) -> String {
    format!("{law}_mid")
}
