//! Checks that every symbol is declared, and used only where its kind is allowed.

use std::collections::BTreeMap;

use symbolica::atom::{Atom, AtomCore};

use super::functions::functions;
use super::names::what_it_is;
use crate::expr::{Expr, Kind, number, set, symbol, symbols};
use crate::markers::{markers, without};
use crate::model::{Exit, Model, REACTION, Switch, SwitchMode};
use crate::slip::Slip;

use Kind::*;

/// Kinds of symbols that energies may contain; listed in messages.
const USABLE: [Kind; 12] =
    [Constant, Parameter, Mid, Law, Error, Friction, Switched, Function, Deflection, Coordinate, Rate, Speed];
/// Kinds of symbols that a torque may contain.
const TORQUE: [Kind; 6] = [Constant, Parameter, Mid, Force, Rate, Speed];
/// Further kinds of symbols for a torque with a friction law as a factor.
const FRICTION: [Kind; 4] = [Law, Friction, Switched, Deflection];
/// Kinds of symbols that an output may contain.
const OUTPUT: [Kind; 16] = [
    Constant, Parameter, Mid, Law, Error, Friction, Switched, Function, Edge, Deflection, Coordinate, Rate, Speed,
    Force, Output, Known,
];
/// Kinds of symbols that a constant may contain.
const CONSTANT: [Kind; 4] = [Constant, Parameter, Mid, Mobility];

/// A model and the names declared in it, each with its kind in words for messages.
struct Places<'a> {
    model: &'a Model,
    declared: BTreeMap<String, &'static str>,
}

/// Checks the symbols and functions of every expression of the model.
pub(super) fn places(model: &Model, declared: BTreeMap<String, &'static str>) -> Result<(), Slip> {
    let places = Places { model, declared };
    places.constants()?;
    places.deflections()?;
    places.functions()?;
    places.energies()?;
    places.torques()?;
    places.outputs()
}

impl Places<'_> {
    fn constants(&self) -> Result<(), Slip> {
        for (name, value) in &self.model.constants {
            let why = "a constant may depend on parameters, constants and mid values only";
            self.check(*value, &format!("the constant `{name}`"), &CONSTANT, why)?;
        }
        for (q, speed) in self.model.motions.iter().flat_map(|m| &m.speeds) {
            self.check(*q, "a motion", &[Coordinate], "a motion gives speeds to coordinates")?;
            let why = "the speeds of a motion may depend on parameters and constants only";
            self.check(*speed, "a motion", &CONSTANT, why)?;
        }
        Ok(())
    }

    fn deflections(&self) -> Result<(), Slip> {
        self.model.deflections.iter().try_for_each(|d| {
            let why = "a deflection may depend on coordinates, transmission errors, and functions of positions with factors of switches";
            let allowed = [Constant, Parameter, Coordinate, Edge, Error, Function, Switched];
            self.check(d.value, &format!("the deflection `{}`", d.name), &allowed, why)
        })?;
        self.model.switches.iter().try_for_each(|switch| self.switch(switch))
    }

    /// A named function depends on coordinates, or on named deflections without transmission errors.
    fn functions(&self) -> Result<(), Slip> {
        self.model.functions.iter().try_for_each(|function| {
            let place = format!("the function `{}`", function.name);
            let mut positions = vec![];
            for of in &function.of {
                let why = "a function is one of a coordinate, or of a named deflection";
                self.check(*of, &place, &[Coordinate, Deflection], why)?;
                let why = "the position of a function depends on coordinates only, without transmission errors";
                self.check(self.model.position(*of), &place, &[Constant, Parameter, Coordinate], why)?;
                match symbols(&of.atom()).as_slice() {
                    [(kind, name)] if of.atom() == Atom::var(symbol(*kind, name)) => {
                        positions.push((*kind, name.clone()))
                    }
                    _ => {
                        let (model, symbol) = (self.model.name.clone(), of.to_string());
                        let why =
                            "its position must be a coordinate or a named deflection; name it with m.deflection(...)";
                        return Err(Slip::Misplaced { model, symbol, place, why });
                    }
                }
            }
            let why = "a function may depend on its position, parameters and constants only";
            let values: Vec<Expr> = [function.value].iter().chain(&function.gradient).copied().collect();
            let others = values.iter().flat_map(|value| symbols(&value.atom()));
            let mut others =
                others.filter(|s| matches!(s.0, Coordinate | Deflection | Function) && !positions.contains(s));
            if let Some((_, symbol)) = others.next() {
                return Err(Slip::Misplaced { model: self.model.name.clone(), symbol, place, why });
            }
            values
                .iter()
                .try_for_each(|value| self.check(*value, &place, &[Constant, Parameter, Coordinate, Deflection], why))
        })
    }

    /// The modes of a switch have one value for each symbol, and lead to modes that it has. Guards and the dissipative force are linear.
    fn switch(&self, switch: &Switch) -> Result<(), Slip> {
        let place = format!("the switch of `{}`", switch.over);
        let slip = |why: &'static str, mode: &str| {
            let (model, switch, mode) = (self.model.name.clone(), switch.over.clone(), mode.to_string());
            Err(Slip::Switch { model, switch, mode, why })
        };
        for mode in &switch.modes {
            if mode.values.len() != switch.symbols.len() {
                return slip("a mode gives one value to each symbol of the switch", &mode.name);
            }
            let why = "the values of a mode may depend on parameters and constants only";
            mode.values.iter().try_for_each(|value| self.check(*value, &place, &[Constant, Parameter], why))?;
        }
        for (mode, exit) in switch.exits() {
            if switch.mode(&exit.to).is_none() {
                return slip("an exit leads to a mode of the same switch", &exit.to);
            }
            let why = "a guard may depend on deflections, rates, stiffnesses, friction laws and constants, and on the reaction in a mode \
                       that holds";
            let mut allowed = vec![Constant, Parameter, Mid, Law, Friction, Switched, Deflection, Rate];
            allowed.extend(mode.held.then_some(Reaction));
            self.check(exit.guard, &place, &allowed, why)?;
            if !is_linear(&exit.guard.atom(), &[Deflection, Rate, Reaction]) {
                return slip("a guard is linear in deflections, rates and the reaction", &mode.name);
            }
        }
        let over = self.model.deflections.iter().find(|d| d.name == switch.over);
        let bends = over.is_some_and(|d| symbols(&d.value.atom()).iter().any(|s| s.0 == Function));
        if let Some(mode) = switch.modes.iter().find(|mode| mode.held).filter(|_| bends) {
            return slip("a mode that holds needs a deflection that is linear in the coordinates", &mode.name);
        }
        // The guard of an exit to a mode that holds must be the rate that is held, up to its sign. The hold then begins at rate zero, and
        // no energy is lost.
        let into = |mode: &SwitchMode, exit: &Exit| !mode.held && switch.mode(&exit.to).is_some_and(|to| to.held);
        let mut held: BTreeMap<&str, Atom> = BTreeMap::new();
        for (mode, exit) in switch.exits().filter(|(mode, exit)| into(mode, exit)) {
            let guard = exit.guard.atom().expand();
            let of_rates = symbols(&guard).into_iter().filter(|(kind, _)| *kind == Rate).map(|(kind, name)| {
                let rate = symbol(kind, &name);
                guard.derivative(rate) * Atom::var(rate)
            });
            let rest = of_rates.fold(guard.clone(), |rest, part| rest - part);
            let first = held.entry(&exit.to).or_insert_with(|| guard.clone());
            if !rest.expand().is_zero() || ![&guard - &*first, &guard + &*first].iter().any(|e| e.expand().is_zero()) {
                return slip("an exit to a mode that holds is the rate that is held, or its negative", &mode.name);
            }
        }
        let why = "the force of a switch may depend on its deflection, stiffnesses and constants";
        self.check(switch.loss, &place, &[Constant, Parameter, Mid, Law, Switched, Deflection], why)?;
        let others =
            symbols(&switch.loss.atom()).into_iter().any(|(kind, name)| kind == Deflection && name != switch.over);
        if others || !is_linear(&switch.loss.atom(), &[Deflection]) {
            return slip("the force of a switch is linear in its deflection", "loss");
        }
        Ok(())
    }

    fn energies(&self) -> Result<(), Slip> {
        let each = |pieces: &[Expr], what: &str, allowed: &[Kind], why| {
            pieces.iter().try_for_each(|piece| self.check(*piece, what, allowed, why))
        };
        let moving = [Constant, Parameter, Mid, Function, Coordinate, Speed];
        let why = "T may depend on speeds, coordinates and functions of them, not on the mesh or on named deflections: write those in the \
                   coordinates";
        each(&self.model.kinetic, "the kinetic energy", &moving, why)?;
        let several = self.model.functions.iter().filter(|function| function.is_of_several());
        for function in several {
            let all: Vec<_> = function.derivatives().into_iter().map(|d| (Function, d.name)).collect();
            let named = |t: &Expr| symbols(&t.atom()).iter().any(|s| all.contains(s));
            if self.model.kinetic.iter().any(named) {
                let (model, symbol, place) =
                    (self.model.name.clone(), function.name.clone(), "the kinetic energy".to_string());
                let why = "T may contain functions of one position only: it needs their third derivatives";
                return Err(Slip::Misplaced { model, symbol, place, why });
            }
        }
        let positions = [Constant, Parameter, Mid, Law, Switched, Function, Deflection, Coordinate];
        let why = "V may depend on positions, not on speeds, and on transmission errors only through deflections, \
                   m.deflection(...)";
        each(&self.model.potential, "the potential energy", &positions, why)?;
        let why = "D may depend on speeds, coordinates and functions of them, not on the mesh";
        let rates = [Constant, Parameter, Mid, Switched, Function, Coordinate, Rate, Speed];
        each(&self.model.dissipation, "the dissipation function", &rates, why)
    }

    fn torques(&self) -> Result<(), Slip> {
        for force in &self.model.forces {
            let why = "a force may depend only on what torques may depend on";
            self.check(force.value, &format!("the force `{}`", force.name), &[&TORQUE[..], &FRICTION].concat(), why)?;
        }
        for torque in &self.model.torques {
            let place = format!("the torque `{}`", torque.name);
            let value = self.model.written_out(&torque.value.atom());
            let (allowed, why) = match self.has_friction(&value) {
                true => (
                    [&TORQUE[..], &FRICTION].concat(),
                    "a friction torque may depend on friction laws, deflections, stiffnesses and speeds only",
                ),
                false => (
                    TORQUE.to_vec(),
                    "a torque may depend on speeds, and on deflections, stiffnesses and friction laws only if it has a friction \
                     law as a factor, inside the effect of that law; any other force that depends on positions must be a term of V",
                ),
            };
            self.check(Expr::new(value), &place, &allowed, why)?;
            let place = format!("the displacement of {place}");
            let why = "a displacement may depend on coordinates, deflections and functions of them only";
            self.check(torque.through, &place, &[Constant, Parameter, Function, Deflection, Coordinate], why)?;
            if let Some(along) = torque.along {
                let why = "the speed along which a torque works may depend on coordinates and speeds only";
                let place = format!("the speed of the torque `{}`", torque.name);
                self.check(along, &place, &[Constant, Parameter, Function, Coordinate, Speed], why)?;
            }
        }
        Ok(())
    }

    /// An output may depend on the state and on the outputs before it.
    fn outputs(&self) -> Result<(), Slip> {
        for (i, output) in self.model.outputs.iter().enumerate() {
            let place = format!("the output `{}`", output.name);
            let why =
                "an output may depend on the state, laws, symbols of switches, forces and outputs declared before it";
            self.check(output.value, &place, &OUTPUT, why)?;
            let later = |(kind, name): &(Kind, String)| {
                *kind == Output && !self.model.outputs[..i].iter().any(|before| before.name == *name)
            };
            // An effect must be a factor of its term, so that the whole term is zero without the effect.
            let inside = output.terms().into_iter().find_map(|term| {
                let stays = |effect: &String| !without(&term, effect).is_zero();
                markers(&term).into_iter().find(stays)
            });
            if let Some(symbol) = inside {
                let why = "the terms of an effect may not be inside a root or a function: name them as an output of their own";
                return Err(Slip::Misplaced { model: self.model.name.clone(), symbol, place, why });
            }
            if let Some((_, symbol)) = symbols(&output.value.atom()).into_iter().find(later) {
                return Err(Slip::Misplaced { model: self.model.name.clone(), symbol, place, why });
            }
        }
        Ok(())
    }

    /// Whether a friction law is a factor of the value of a torque. The effect of the law must be a factor too.
    fn has_friction(&self, value: &Atom) -> bool {
        let laws = self.model.laws.iter().filter(|law| law.kind() == Friction);
        let vanishes = |law: &crate::model::Law| {
            let at_zero = |kind, name: &str| {
                let symbol = symbol(kind, name);
                value.contains_symbol(symbol) && set(value, symbol, &number(0)).expand().is_zero()
            };
            at_zero(Friction, &law.name) && law.with.as_deref().is_some_and(|effect| at_zero(Marker, effect))
        };
        laws.into_iter().any(vanishes)
    }

    /// Refuses undeclared symbols, those of kinds that are not `allowed`, and functions that are not smooth.
    fn check(&self, e: Expr, place: &str, allowed: &[Kind], why: &'static str) -> Result<(), Slip> {
        let e: Atom = e.atom();
        functions(self.model, e.as_view(), place)?;
        let model = || self.model.name.clone();
        for (kind, symbol) in symbols(&e) {
            let place = place.to_string();
            let derived = matches!(kind, Marker | Mobility) || (kind == Reaction && symbol == REACTION);
            match self.declared.get(&symbol) {
                _ if derived => {}
                Some(what) if *what == what_it_is(kind) => {}
                Some(_) if kind != Free => {
                    let why = "in this model the name is declared as something else; is the symbol from another model?";
                    return Err(Slip::Misplaced { model: model(), symbol, place, why });
                }
                _ => return Err(Slip::Undeclared { model: model(), symbol, place, declared: self.usable() }),
            }
            if kind != Marker && !allowed.contains(&kind) {
                return Err(Slip::Misplaced { model: model(), symbol, place, why });
            }
        }
        Ok(())
    }

    /// The declared names that energies may contain.
    fn usable(&self) -> String {
        let usable = |what: &str| USABLE.iter().any(|kind| what_it_is(*kind) == what);
        let names = self.declared.iter().filter(|(_, what)| usable(what)).map(|(name, _)| name.as_str());
        names.collect::<Vec<_>>().join(", ")
    }
}

/// Whether an expression is linear in its symbols of some kinds.
fn is_linear(e: &Atom, kinds: &[Kind]) -> bool {
    let moving = |e: &Atom| symbols(e).into_iter().filter(|s| kinds.contains(&s.0)).collect::<Vec<_>>();
    moving(e).iter().all(|(kind, name)| moving(&e.derivative(symbol(*kind, name)).expand()).is_empty())
}
