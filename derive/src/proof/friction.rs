//! Friction takes energy or none.
//!
//! The friction of a mesh has two torques: `roll` = -arm F through psi and `slide` = -side F through tau, with F = c psi_dot. Their
//! power is -c psi_dot (arm psi_dot + side tau_dot).

use symbolica::atom::{Atom, AtomCore};

use super::Proof;
use crate::check::never_negative;
use crate::expr::{Kind, symbol, symbols};
use crate::markers::all_present;
use crate::model::{Factor, Law, Role, Torque};
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
        let power = all_present(&p.model.written_out(&roll.power()));
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
        let weight = all_present(&p.model.written_out(&(-&force * psi.atom())));
        if !never_negative(p.model, &weight) {
            return Err(p.unproved(&what, &weight));
        }
        let [arm, side] = [arm, side].map(|law| Atom::var(symbol(Kind::Friction, &law.name)));
        let sliding = arm * psi.atom() + side * tau.atom();
        let power = slide.power() + roll.power();
        p.claim(&what, [power - force * sliding])?;
    }
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
