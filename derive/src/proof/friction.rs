//! Friction takes energy or none.
//!
//! The friction of a mesh has two torques: `roll` = -arm F through psi and `slide` = -side F through tau, with F = c psi_dot. Their
//! power is -c psi_dot (arm psi_dot + side tau_dot).
//!
//! A switch with modes that hold may change F. With it F is c in a mode that lasts while arm psi_dot + side tau_dot >= 0, -c in one that lasts while
//! it is <= 0, and zero in one that holds: the two torques together then always take energy or none.

use symbolica::atom::{Atom, AtomCore};

use super::Proof;
use crate::check::never_negative;
use crate::expr::{Kind, number, symbol, symbols};
use crate::markers::{all_present, without};
use crate::model::{Factor, Law, Role, Switch, Torque};
use crate::slip::Slip;

/// Proves the sign of the power of each friction.
pub(super) fn prove(p: &mut Proof) -> Result<(), Slip> {
    let of = |what: Factor| {
        let laws: Vec<(&Law, &Torque)> = p.model.torques.iter().filter_map(|t| Some((law(p, t, what)?, t))).collect();
        laws
    };
    let (rolls, slides) = (of(Factor::Arm), of(Factor::Side));
    for (_, roll) in &rolls {
        let what = format!("the friction `{}` takes energy or none: its power is never positive", roll.name);
        let power = smooth(p, &roll.power());
        if !never_negative(p.model, &-power.clone()) {
            return Err(p.unproved(&what, &power));
        }
        p.proved.push(what);
    }
    for (side, slide) in slides {
        let factor = |law: &Law, torque: &Torque| torque.value.atom().derivative(symbol(Kind::Friction, &law.name));
        let force = factor(side, slide);
        let Some((arm, roll)) = rolls.iter().find(|(arm, roll)| factor(arm, roll) == force) else {
            let what = format!("the friction `{}` has the force of a friction with an arm", slide.name);
            return Err(p.unproved(&what, &slide.power()));
        };
        let (psi, tau) = (roll.through.dot(), slide.through.dot());
        let what = format!(
            "the friction `{}` takes with `{}` energy or none where {psi} and {} {psi} + {} {tau} have one sign: where flanks \
             slide as rolling makes them",
            slide.name, roll.name, arm.name, side.name
        );
        // -F psi_dot, which must never be negative for the power -F psi_dot (..)/psi_dot to have the sign said.
        let weight = smooth(p, &(-&force * psi.atom()));
        if !never_negative(p.model, &weight) {
            return Err(p.unproved(&what, &weight));
        }
        let [arm, side] = [arm, side].map(|law| Atom::var(symbol(Kind::Friction, &law.name)));
        let sliding = arm * psi.atom() + side * tau.atom();
        let power = slide.power() + roll.power();
        p.claim(&what, [power - &force * &sliding])?;
        if let Some(switch) = changed_by(p, &force) {
            sticking(p, switch, [&slide.name, &roll.name], &-force, &sliding)?;
        }
    }
    Ok(())
}

/// An expression without the effect of the switch that makes friction stick, all other effects present.
fn smooth(p: &Proof<'_>, e: &Atom) -> Atom {
    let e = p.model.written_out(e);
    let changed = changed_by(p, &e).map_or_else(|| e.clone(), |switch| switch.neutral(&without(&e, &switch.effect)));
    all_present(&changed)
}

/// The switch with modes that hold whose symbols are in an expression.
fn changed_by<'a>(p: &Proof<'a>, e: &Atom) -> Option<&'a Switch> {
    let names = symbols(&p.model.written_out(e));
    let mut switches = p.model.switches.iter().filter(|switch| switch.modes.iter().any(|mode| mode.held));
    switches.find(|switch| {
        switch.symbols.iter().any(|s| names.iter().any(|(kind, name)| *kind == s.kind && *name == s.name))
    })
}

/// The friction -F v, with v = `sliding`, takes energy or none in every mode of `switch`: F v is a guard of the mode times a factor that is
/// never negative, or F is zero.
fn sticking(
    p: &mut Proof,
    switch: &Switch,
    [slide, roll]: [&str; 2],
    force: &Atom,
    sliding: &Atom,
) -> Result<(), Slip> {
    let what = format!(
        "the friction `{slide}` takes with `{roll}` energy or none in every mode of {}, in scenes with {}: from the guards that hold in the mode",
        switch.over, switch.effect
    );
    let force = all_present(&p.model.written_out(force)).expand();
    for mode in &switch.modes {
        let force = switch.within(mode, &force).expand();
        let takes = |sign: i64| {
            let guard = number(sign) * sliding;
            never_negative(p.model, &(number(sign) * &force).expand())
                && mode.exits.iter().any(|exit| (exit.guard.atom() - &guard).expand().is_zero())
        };
        if !(force.is_zero() || takes(1) || takes(-1)) {
            return Err(p.unproved(&what, &-(force * sliding)));
        }
    }
    p.proved.push(what);
    Ok(())
}

/// The law of this kind that is in a torque. A torque with an arm is rolling friction, even if it has other laws.
fn law<'a>(p: &Proof<'a>, torque: &Torque, what: Factor) -> Option<&'a Law> {
    let value = p.model.written_out(&torque.value.atom());
    let found = |what| {
        let role = Role::Factor(what);
        let mut laws = p.model.laws.iter().filter(move |law| law.role == role);
        laws.find(|law| symbols(&value).iter().any(|(kind, name)| *kind == Kind::Friction && *name == law.name))
    };
    match what {
        Factor::Side if found(Factor::Arm).is_some() => None,
        what => found(what),
    }
}
