//! Outputs: what can be observed of a model besides its coordinates, such as forces and losses.

use symbolica::atom::{Atom, AtomCore, Symbol};

use super::Model;
use crate::expr::{Expr, Kind, power_name, reaction_name, set, speed_name, symbol, symbols, total};
use crate::markers::{markers, terms};

/// A quantity that a run can record.
pub(crate) struct Output {
    pub name: String,
    pub unit: String,
    /// Its value, with the markers of effects.
    pub value: Expr,
    /// The effect in whose closure it was declared: scenes without it do not have the output.
    pub with: Option<String>,
    pub doc: String,
}

impl Output {
    /// The terms of its value, each with the markers of its effects as factors. A value without effects is not expanded.
    pub fn terms(&self) -> Vec<Atom> {
        let value = self.value.atom();
        if markers(&value).is_empty() { terms(&value) } else { terms(&value.expand()) }
    }
}

impl Model {
    /// Declares a quantity with its SI unit that scenes can record. It may depend on the state, on the laws and on the symbols of
    /// switches. No equation of motion depends on it. Inside the closure of an effect: only scenes with the effect have it.
    /// Returns its symbol, in which later outputs may be written.
    pub fn output(&mut self, name: &str, unit: &str, value: Expr, doc: &str) -> Expr {
        let with = self.innermost();
        self.outputs.push(Output { name: name.into(), unit: unit.into(), value, with, doc: doc.into() });
        Expr::var(Kind::Output, name)
    }

    /// As [`Model::output`], for scenes with `effect` only.
    pub fn output_with(&mut self, effect: &str, name: &str, unit: &str, value: Expr, doc: &str) -> Expr {
        let outer = std::mem::replace(&mut self.within, vec![effect.into()]);
        let output = self.output(name, unit, value, doc);
        self.within = outer;
        output
    }

    /// The kinetic energy declared so far, without the terms that depend on coordinates: the terms that [`Model::rayleigh`] uses.
    pub fn kinetic_energy(&self) -> Expr {
        let constant = self.kinetic.iter().filter(|piece| !super::energies::depends_on_positions(piece));
        Expr::new(total(constant.map(|piece| piece.atom()).collect()))
    }

    /// For outputs: the force of the springs along the named deflection `x`, dV/dx. It contains the terms of the complete model, also those
    /// that are declared later.
    pub fn spring(&self, x: Expr) -> Expr {
        of(Kind::Spring, x)
    }

    /// dV/dx of the named deflection `x`.
    pub(super) fn spring_force(&self, x: &str) -> Atom {
        slope(&self.potential, symbol(Kind::Deflection, x))
    }

    /// dD/dx' of the named deflection `x`.
    pub(super) fn damper_force(&self, x: &str) -> Atom {
        slope(&self.dissipation, symbol(Kind::Rate, &speed_name(x)))
    }

    /// For outputs: the force along the deflection `x` of a switch that its hold resists, zero in modes that do not hold. If several holds
    /// prevent the same motion, the whole reaction is assigned to the first.
    pub fn reaction(&self, x: Expr) -> Expr {
        match symbols(&x.atom()).as_slice() {
            [(Kind::Deflection, name)] => Expr::var(Kind::Known, &reaction_name(name)),
            _ => Expr::symbol("the reaction along an expression that is not the deflection of a switch"),
        }
    }

    /// For outputs: the power \[W\] of the external torque `name`, at its present value if it varies in time.
    pub fn power(&self, name: &str) -> Expr {
        Expr::var(Kind::Known, &power_name(name))
    }

    /// For outputs: the dissipative force along the named deflection `x`: that of dampers, dD/dx', and that of a switch.
    pub fn damper(&self, x: Expr) -> Expr {
        of(Kind::Damper, x)
    }
}

/// The derivative of a sum of energies by a symbol.
fn slope(pieces: &[Expr], by: Symbol) -> Atom {
    total(pieces.iter().map(|piece| piece.atom().derivative(by)).collect()).expand()
}

/// The symbol of a force along a deflection. For any other expression it is undeclared, and is refused.
fn of(kind: Kind, x: Expr) -> Expr {
    match symbols(&x.atom()).as_slice() {
        [(Kind::Deflection, name)] if x.atom() == Expr::var(Kind::Deflection, name).atom() => Expr::var(kind, name),
        _ => Expr::symbol("the force along an expression that is not a named deflection"),
    }
}

/// Replaces the forces of springs and dampers in outputs by the derivatives of V and D.
pub(super) fn complete(model: &mut Model) {
    let written = |value: Expr| {
        let mut value = value.atom();
        for (kind, name) in symbols(&value) {
            let lost = model.switches.iter().filter(|switch| switch.over == name).map(|switch| switch.lost());
            let force = match kind {
                Kind::Spring => model.spring_force(&name),
                Kind::Damper => model.damper_force(&name) + total(lost.collect()),
                _ => continue,
            };
            value = set(&value, symbol(kind, &name), &force);
        }
        Expr::new(value)
    };
    let values: Vec<Expr> = model.outputs.iter().map(|output| written(output.value)).collect();
    model.outputs.iter_mut().zip(values).for_each(|(output, value)| output.value = value);
}
