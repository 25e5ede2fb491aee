//! Proves that friction never adds energy.
//!
//! The friction of a mesh has two torques: `roll` = -arm F through psi and `slide` = -side f F through tau, with F = c psi_dot, and with f
//! between -1 and 1: the sign of the flank. Their power is -c psi_dot (arm psi_dot + side f tau_dot).
//!
//! A switch with modes that hold may change F. Let v = arm psi_dot + side f tau_dot. F is then >= 0 in a mode that lasts while v >= 0, <= 0
//! in a mode that lasts while v <= 0, and zero in a mode that holds. So the power -F v of both torques together is never positive. f is 1
//! in a mode with a guard of its sign, and -1 in a mode with the opposite guard.

use symbolica::atom::{Atom, AtomCore};

use super::Proof;
use crate::check::never_negative;
use crate::expr::{Kind, number, set, symbol, symbols};
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
        let along_tau = by_force(p, &factor(side, slide));
        let named = |e: &Atom| symbols(e).into_iter().find(|(kind, _)| *kind == Kind::Force);
        let of_same = |(arm, roll): &&(&Law, &Torque)| {
            let force = named(&factor(arm, roll));
            force.is_some() && force == named(&along_tau)
        };
        let Some((arm, roll)) = rolls.iter().find(of_same) else {
            let what = format!("the friction `{}` has the force of a friction with an arm", slide.name);
            return Err(p.unproved(&what, &slide.power()));
        };
        let force = factor(arm, roll);
        let flank = (&along_tau / &force).expand();
        let what = format!(
            "the friction `{}` is the force of `{}` times at most 1, along its sign or against it",
            slide.name, roll.name
        );
        let room = number(1) - &flank * &flank;
        if !never_negative(p.model, &room.together()) {
            return Err(p.unproved(&what, &room));
        }
        p.proved.push(what);
        let (psi, tau) = (roll.through.dot(), slide.through.dot());
        let what = format!(
            "the friction `{}` takes with `{}` energy or none where {psi} and {} {psi} + {} {tau} have one sign, on the coast flank with \
             -{}: where flanks slide as rolling makes them",
            slide.name, roll.name, arm.name, side.name, side.name
        );
        // F psi_dot, because `force` is -F. It must never be negative: then the power -F psi_dot (..)/psi_dot has the stated sign.
        let weight = smooth(p, &(-&force * psi.atom()));
        if !never_negative(p.model, &weight) {
            return Err(p.unproved(&what, &weight));
        }
        let [arm, side] = [arm, side].map(|law| Atom::var(symbol(Kind::Friction, &law.name)));
        let [rolling, sliding] = [arm * psi.atom(), side * tau.atom()];
        let power = by_force(p, &slide.power()) + roll.power();
        p.claim(&what, [power - &force * (&rolling + &sliding * &flank)])?;
        if let Some(switch) = changed_by(p, &force) {
            sticking(p, switch, [&slide.name, &roll.name], &-force, [&rolling, &sliding, &flank])?;
        }
    }
    Ok(())
}

/// The expression with each named force replaced by its value, if this value contains another named force.
fn by_force(p: &Proof<'_>, e: &Atom) -> Atom {
    let is_multiple = |name: &str| {
        let force = p.model.forces.iter().find(|force| force.name == name)?;
        let value = force.value.atom();
        symbols(&value).iter().any(|(kind, _)| *kind == Kind::Force).then_some(value)
    };
    symbols(e).iter().filter(|(kind, _)| *kind == Kind::Force).fold(e.clone(), |e, (kind, name)| {
        match is_multiple(name) {
            Some(value) => set(&e, symbol(*kind, name), &value),
            None => e,
        }
    })
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

/// Proves that the power -F v of the friction, with v = `rolling` + f `sliding`, is never positive in any mode of `switch`: F v is a guard
/// of the mode times a factor that is never negative, or F is zero. Another guard of the mode gives the sign of the `flank` f, and |f| = 1.
fn sticking(
    p: &mut Proof,
    switch: &Switch,
    [slide, roll]: [&str; 2],
    force: &Atom,
    [rolling, sliding, flank]: [&Atom; 3],
) -> Result<(), Slip> {
    let what = format!(
        "the friction `{slide}` takes with `{roll}` energy or none in every mode of {}, in scenes with {}: from the guards that hold in the mode",
        switch.over, switch.effect
    );
    let force = all_present(&p.model.written_out(force)).expand();
    for mode in &switch.modes {
        let force = switch.within(mode, &force).expand();
        let is_on = |sign: i64| {
            mode.exits.iter().any(|exit| never_negative(p.model, &(number(sign) * flank / exit.guard.atom()).expand()))
        };
        // One line of action for both flanks: f is 1 in every mode.
        let on = if flank == &number(1) { Some(1) } else { None };
        let Some(on) = on.or_else(|| [1, -1].into_iter().find(|sign| is_on(*sign))) else {
            return Err(p.unproved(&format!("{what}; the mode {} lasts on one flank", mode.name), flank));
        };
        let speed = rolling + number(on) * sliding;
        let takes = |sign: i64| {
            let guard = number(sign) * &speed;
            never_negative(p.model, &(number(sign) * &force).expand())
                && mode.exits.iter().any(|exit| (exit.guard.atom() - &guard).expand().is_zero())
        };
        if !(force.is_zero() || takes(1) || takes(-1)) {
            return Err(p.unproved(&what, &-(force * &speed)));
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
