//! The definitions of names: constants, deflections, forces, and the symbols that the engine sets.

use symbolica::atom::Atom;

use super::Writer;
use crate::derivation::Derivation;
use crate::expr::Expr;
use crate::markers::{all_present, as_written, terms};
use crate::model::{Exit, Law, Role, Switch, SwitchMode};
use crate::print::{Style, print};
use crate::tree::Tree;

/// Constants, deflections and forces, and the symbols that the engine sets.
pub(super) fn write(d: &Derivation, w: &Writer) -> Vec<String> {
    let m = d.model;
    let is = |name: &str, value: &Atom| format!("{} = {}", w.name(name), w.print(value));
    let mut lines: Vec<String> = d.motion.constants.iter().map(|(name, value)| is(name, value)).collect();
    lines.extend(m.deflections.iter().map(|d| is(&d.name, &d.value.atom())));
    for function in &m.functions {
        let without = function.with.as_ref().filter(|_| w.plain());
        let without = without.map_or(String::new(), |effect| format!("; 0 without {}", effect.replace('_', " ")));
        lines.push(is(&function.name, &function.value.atom()) + without.as_str());
        if w.plain() {
            let names = function.derivatives().into_iter().skip(1).map(|d| d.name).collect::<Vec<_>>().join(", ");
            let of = function.of.iter().map(|of| of.to_string()).collect::<Vec<_>>().join(", ");
            lines.push(format!("{names}: the derivatives of {} by {of}", function.name));
        }
    }
    for force in &m.forces {
        let mut groups = as_written(&terms(&force.value.atom()), &w.order);
        let always = groups.iter_mut().filter(|group| group.effects.is_empty() && w.plain());
        always.for_each(|group| group.effects.extend(force.with.clone()));
        lines.extend(w.equation(&w.name(&force.name), &groups));
    }
    if w.plain() {
        lines.extend(idle_texts(&m.laws));
        lines.extend(m.switches.iter().flat_map(switch_text));
    }
    lines
}

/// The values of laws in scenes without their effects, one line for each effect.
fn idle_texts(laws: &[Law]) -> Vec<String> {
    let of = |laws: &[Law]| {
        let names = laws.iter().map(|law| law.name.as_str()).collect::<Vec<_>>().join(", ");
        let without = laws[0].with.as_ref()?.replace('_', " ");
        let rates = match laws[0].role {
            Role::Offset => "; the rates of deflections do not contain the rates of these errors",
            _ => "",
        };
        Some(format!("{names} = 0 without {without}{rates}"))
    };
    laws.chunk_by(|a, b| a.with == b.with).filter_map(of).collect()
}

/// The modes of a switch: the values of the symbols in each, and the guards that end it.
fn switch_text(switch: &Switch) -> Vec<String> {
    let plain = |e: &Expr| print(&Tree::new(&all_present(&e.atom())), Style::Plain);
    let list = |values: &mut dyn Iterator<Item = String>| {
        let named = switch.symbols.iter().zip(values).map(|(s, value)| format!("{} = {value}", s.name));
        named.collect::<Vec<_>>().join(", ")
    };
    let neutral = list(&mut switch.symbols.iter().map(|s| s.neutral.to_string()));
    let mut lines = vec![format!("{}: without {} {neutral}; its modes:", switch.doc, switch.effect.replace('_', " "))];
    for mode in &switch.modes {
        let values = list(&mut mode.values.iter().map(plain));
        let held = match held_rate(switch, mode).map(|rate| [plain(&rate), plain(&-rate)]) {
            _ if !mode.held => String::new(),
            Some([rate, back]) => format!(", {} = 0", if rate.starts_with('-') { back } else { rate }),
            None => format!(", {}_dot = 0", switch.over),
        };
        let exits = mode.exits.iter().filter(|exit| !exit.sudden);
        let exits = exits.map(|exit| format!("{} once {} < 0", exit.to, plain(&exit.guard))).collect::<Vec<_>>();
        lines.push(format!("  {}: {values}{held}; {}", mode.name, exits.join(", ")));
    }
    lines
}

/// The rate that a mode holds: the guard that leads from the next mode without a hold back to a hold. `None` if there is none.
fn held_rate(switch: &Switch, mode: &SwitchMode) -> Option<Expr> {
    let following =
        mode.exits.iter().filter_map(|exit| switch.modes.iter().find(|next| next.name == exit.to && !next.held));
    let holds = |exit: &&Exit| switch.modes.iter().any(|next| next.name == exit.to && next.held);
    following.flat_map(|next| &next.exits).find(holds).map(|exit| exit.guard)
}
