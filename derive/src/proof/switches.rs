//! Proofs about switches. V does not step where a mode ends, so there is no impulse. The force of a switch never adds energy.

use symbolica::atom::{Atom, AtomCore, Symbol};

use super::Proof;
use crate::check::never_negative;
use crate::expr::{Expr, Kind, number, set, speed_name, symbol, symbols, total};
use crate::markers::{all_present, terms};
use crate::mobility::is_zero;
use crate::model::{Exit, Model, Switch, SwitchMode};
use crate::slip::Slip;

/// Proves both statements for every switch.
pub(super) fn prove(p: &mut Proof) -> Result<(), Slip> {
    for switch in &p.model.switches {
        let what = format!("V is the same on both sides of the exits of {}: no impulse there", switch.over);
        p.claim(&what, steps(p.model, switch))?;
        losses(p, switch)?;
    }
    Ok(())
}

/// The step of V at each exit: V in the next mode minus V in the mode that ends. If V depends on the mode, the two are compared at the
/// deflection at which the guard is zero.
fn steps(model: &Model, switch: &Switch) -> Vec<Atom> {
    let over = symbol(Kind::Deflection, &switch.over);
    // The deflection with all symbols of the switch set to zero.
    let x = symbol(Kind::Free, "x");
    let value = |name: &str| model.deflections.iter().find(|d| d.name == name).map_or(number(0), |d| d.value.atom());
    let zero = |e: &Atom| switch.symbols.iter().fold(e.clone(), |e, s| set(&e, symbol(s.kind, &s.name), &number(0)));
    let base = zero(&value(&switch.over));
    let of_motion = [Kind::Function, Kind::Coordinate, Kind::Constant, Kind::Parameter];
    let plain = |mode: &SwitchMode, e: &Atom| {
        let offset = (switch.within(mode, &value(&switch.over)) - &base).expand();
        let mut e = set(e, over, &(Atom::var(x) + offset));
        // Another deflection that depends only on the motion is written as x plus its difference from x, or written out if that is shorter.
        for (kind, name) in symbols(&e).into_iter().filter(|s| s.0 == Kind::Deflection) {
            let value = value(&name).expand();
            let apart = (&value - &base).expand();
            let written = if terms(&apart).len() < terms(&value).len() { Atom::var(x) + &apart } else { value };
            if symbols(&written).iter().all(|s| s.0 == Kind::Free || of_motion.contains(&s.0)) {
                e = set(&e, symbol(kind, &name), &written);
            }
        }
        switch.within(mode, &e)
    };
    // The other terms of V are the same in all modes.
    let changed: Vec<Symbol> = switch.symbols.iter().map(|s| symbol(s.kind, &s.name)).chain([over]).collect();
    let terms = model.potential.iter().map(|v| v.atom());
    let terms = terms.filter(|v| changed.iter().any(|symbol| v.contains_symbol(*symbol)));
    let v = all_present(&total(terms.collect()));
    let energies: Vec<(&SwitchMode, Atom)> = switch.modes.iter().map(|mode| (mode, plain(mode, &v))).collect();
    let step = |(mode, before): &(&SwitchMode, Atom), exit: &Exit| {
        let Some((_, beyond)) = energies.iter().find(|(mode, _)| mode.name == exit.to) else { return number(0) };
        let step = (beyond - before).expand();
        if step.is_zero() {
            return step;
        }
        let guard = plain(mode, &all_present(&exit.guard.atom())).expand();
        set(&step, x, &(-set(&guard, x, &number(0)) / guard.derivative(x)))
    };
    energies.iter().flat_map(|energy| energy.0.exits.iter().map(move |exit| step(energy, exit))).collect()
}

/// Proves that the force f of a switch never adds energy: f x' >= 0 in every mode in which f is not zero. Either f x' is a guard of the
/// mode, which is >= 0 in it, times a factor that is never negative; or f is the force of a clipped damper.
fn losses(p: &mut Proof, switch: &Switch) -> Result<(), Slip> {
    if switch.loss.atom().is_zero() {
        return Ok(());
    }
    let name = &switch.over;
    let mut what = format!(
        "the force of the switch {name} takes energy or none: f {name}_dot >= 0 in every mode, from the guards that hold in it"
    );
    let rate = symbol(Kind::Rate, &speed_name(name));
    let mut clipped = false;
    for mode in &switch.modes {
        let force = switch.within(mode, &all_present(&switch.loss.atom())).expand();
        let guards: Vec<Atom> = mode.exits.iter().map(|exit| all_present(&exit.guard.atom())).collect();
        // In a mode that holds x' = 0, and the force does no work.
        if force.is_zero() || mode.held || guards.iter().any(|guard| is_guard(p, &force, guard, rate)) {
            continue;
        }
        if !is_clipped(p, switch, mode, &force, &guards) {
            return Err(p.unproved(&what, &(force * Atom::var(rate))));
        }
        clipped = true;
    }
    if clipped {
        what += &format!(
            "; of a damper that is clipped to f = c F, where F = dV/d{name} and c = 1 or -1, since F {name} >= 0, \
             {name}_dot dD/d{name}_dot >= 0 and c {name} dD/d{name}_dot >= F {name}"
        );
    }
    p.proved.push(what);
    Ok(())
}

/// Whether f x' is a guard times a factor that is never negative.
fn is_guard(p: &Proof, force: &Atom, guard: &Atom, rate: Symbol) -> bool {
    let slope = guard.derivative(rate).expand();
    if slope.is_zero() {
        return false;
    }
    let factor = (force / slope).expand();
    never_negative(p.model, &factor) && is_zero(&(force * Atom::var(rate) - factor * guard))
}

/// Whether f is the force of a clipped damper. In contact, at x = over, its spring has the force F_s = dV/dx and its damper would
/// have the force F_d = dD/dx'. Where c F_d x > F_s x, with c = 1 or -1, it is clipped to the force f = c F_s. Now
///
/// ```text
/// (c F_s x') (c F_d x) = (F_s x) (F_d x')      since c² = 1
/// ```
///
/// and c F_d x > F_s x >= 0. Hence c F_s x' >= 0 follows from F_s x >= 0 and F_d x' >= 0, which follow from the forms of F_s and F_d. In
/// the mode, c F_d x >= F_s x holds because it is the product of two guards.
fn is_clipped(p: &Proof, switch: &Switch, mode: &SwitchMode, force: &Atom, guards: &[Atom]) -> bool {
    let [over, rate] = [(Kind::Deflection, switch.over.clone()), (Kind::Rate, speed_name(&switch.over))]
        .map(|(kind, name)| symbol(kind, &name));
    let by =
        |pieces: &[Expr], by| all_present(&total(pieces.iter().map(|e| e.atom().derivative(by)).collect()).expand());
    let spring = switch.within(mode, &by(&p.model.potential, over)).expand();
    let damper = switch.neutral(&by(&p.model.dissipation, rate)).expand();
    let Some(c) = [1, -1].into_iter().find(|c| is_zero(&(force - number(*c) * &spring))) else { return false };
    let (at, moving) = ((&spring * Atom::var(over)).expand(), (&damper * Atom::var(rate)).expand());
    let more = (number(c) * &damper - &spring) * Atom::var(over);
    never_negative(p.model, &at)
        && never_negative(p.model, &moving)
        && guards.iter().any(|a| guards.iter().any(|b| is_zero(&(a * b - &more))))
}
