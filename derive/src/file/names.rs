//! The names in which the equations are written: constants, deflections, forces, and the switches.

use symbolica::atom::{Atom, AtomCore};

use super::block::Block;
use crate::derivation::Derivation;
use crate::expr::{Expr, Kind, kind_and_name, number, set, symbol, symbols};
use crate::markers::{all_present, terms};
use crate::model::Switch;
use crate::print::{Style, print};
use crate::tree::Tree;

/// Writes the blocks `constants`, `deflections`, `functions`, `rates`, `forces`, `partials` and `switches`, except those that would be
/// empty.
pub(super) fn write(b: &mut Block, d: &Derivation) {
    let (m, constants) = (d.model, &d.motion.constants);
    if !constants.is_empty() {
        b.braces(1, "constants", |b| {
            for (name, value) in constants {
                b.line(2, &format!("{name} = {};", print(&Tree::new(value), Style::Rust)));
            }
        });
    }
    if !m.deflections.is_empty() {
        b.braces(1, "deflections", |b| {
            for deflection in &m.deflections {
                let value = Tree::new(&deflection.value.atom());
                b.line(2, &format!("{} = {};", deflection.name, print(&value, Style::Rust)));
            }
        });
    }
    if !m.functions.is_empty() {
        b.braces(1, "functions", |b| {
            for function in &m.functions {
                let with = function.with.as_ref().map_or(String::new(), |effect| format!(" with {effect}"));
                for derivative in function.derivatives() {
                    let value = print(&Tree::new(&derivative.value), Style::Rust);
                    b.line(2, &format!("{}{with} = {value};", derivative.name));
                }
            }
        });
    }
    let bent: Vec<_> = d.symbols.deflections.iter().filter(|d| d.bends).collect();
    if !bent.is_empty() {
        b.braces(1, "rates", |b| {
            for deflection in bent {
                let rate = all_present(&deflection.rate(&d.symbols.v)).expand();
                let name = kind_and_name(deflection.rate_symbol).1;
                b.line(2, &format!("{name} = {};", print(&Tree::new(&rate), Style::Rust)));
            }
        });
    }
    if !m.forces.is_empty() {
        b.braces(1, "forces", |b| {
            m.forces.iter().for_each(|force| with_effect(b, &force.name, force.with.as_deref(), &force.value.atom()));
        });
    }
    if !d.partials.is_empty() {
        b.braces(1, "partials", |b| {
            d.partials.iter().for_each(|(name, effect, value)| with_effect(b, name, effect.as_deref(), value));
        });
    }
    if !m.switches.is_empty() {
        b.braces(1, "switches", |b| m.switches.iter().for_each(|s| switch(b, s)));
    }
}

/// Writes a force of an effect, or a partial derivative of such a force, with the terms by which another effect changes it.
fn with_effect(b: &mut Block, name: &str, effect: Option<&str>, value: &Atom) {
    let mut groups = b.not_expanded(&terms(value));
    let always = groups.iter_mut().filter(|group| group.effects.is_empty());
    always.for_each(|group| group.effects.extend(effect.map(String::from)));
    b.sum(2, name, &groups);
}

fn switch(b: &mut Block, switch: &Switch) {
    let Switch { over, unit, symbols, modes, effect, doc, .. } = switch;
    let rust = |e: &Expr| print(&Tree::new(&e.atom()), Style::Rust);
    let symbols = symbols.iter().map(|s| format!("{} {:?}", s.name, s.neutral as f64)).collect::<Vec<_>>().join(", ");
    b.braces(2, &format!("{over} {unit:?} ({symbols}) with {effect}, {doc:?}"), |b| {
        for mode in modes {
            let values = mode.values.iter().map(rust).collect::<Vec<_>>().join(", ");
            let word = |is: bool, word: &'static str| if is { word } else { "" };
            let counts = mode.counts.as_ref().map_or(String::new(), |what| format!(" counts {what:?}"));
            let words = [word(mode.held, " holds"), word(mode.rests, " rests")].concat();
            b.braces(3, &format!("{} ({values}){words}{counts}", mode.name), |b| {
                for exit in &mode.exits {
                    let how = if exit.sudden { "unless" } else { "until" };
                    b.braces(4, &format!("{how} {}", exit.to), |b| linear(b, 5, &exit.guard.atom()));
                }
            });
        }
        if !switch.loss.atom().is_zero() {
            b.braces(3, "loss", |b| linear(b, 4, &switch.loss.atom()));
        }
    });
}

/// Writes a linear form: the coefficient of each deflection, rate and reaction, and the constant under the name `one`.
fn linear(b: &mut Block, depth: usize, e: &Atom) {
    let e = e.expand();
    let mut rest = e.clone();
    for (kind, name) in symbols(&e) {
        if matches!(kind, Kind::Deflection | Kind::Rate | Kind::Reaction) {
            let symbol = symbol(kind, &name);
            b.sum(depth, &name, &b.grouped(&e.derivative(symbol).expand()));
            rest = set(&rest, symbol, &number(0));
        }
    }
    b.sum(depth, "one", &b.grouped(&rest.expand()));
}
