//! Proofs: identities that the derived equations must satisfy, decided symbolically.

mod balance;
mod dampers;
mod friction;
mod inertia;
mod step;
mod switches;

use symbolica::atom::{Atom, AtomCore};

use crate::expr::{Expr, Kind, set, symbol, symbols};
use crate::jump::Jump;
use crate::lagrange::EquationsOfMotion;
use crate::mobility::is_zero;
use crate::model::{Function, Model};
use crate::print::{Style, print};
use crate::slip::Slip;
use crate::symbols::Symbols;
use crate::tree::Tree;

/// The formulas to prove, and the statements proved so far.
pub(crate) struct Proof<'a> {
    model: &'a Model,
    s: &'a Symbols,
    motion: &'a EquationsOfMotion,
    jumps: &'a [Jump],
    proved: Vec<String>,
}

/// Proves all identities. Each line returned states what was proved.
///
/// # Errors
/// [`Slip::Unproved`] with the first identity that fails and its remainder; [`Slip::Singular`] if M is singular.
pub(crate) fn prove(
    model: &Model,
    s: &Symbols,
    motion: &EquationsOfMotion,
    jumps: &[Jump],
) -> Result<Vec<String>, Slip> {
    let mut p = Proof { model, s, motion, jumps, proved: vec![] };
    balance::prove(&mut p)?;
    inertia::prove(&mut p)?;
    step::prove(&mut p)?;
    switches::prove(&mut p)?;
    dampers::prove(&mut p)?;
    friction::prove(&mut p)?;
    let straight = model.deflections.iter().zip(&s.deflections).filter(|(_, linear)| !linear.bends);
    p.claim(
        "every deflection equals the linear form by which the equations differentiate it",
        straight.map(|(d, linear)| d.value.atom() - linear.of(&s.q)),
    )?;
    let bent = model.deflections.iter().zip(&s.deflections).filter(|(_, linear)| linear.bends);
    p.claim(
        "every deflection that bends has the rate by which the equations differentiate it",
        bent.map(|(d, linear)| d.value.dot().atom() - linear.rate(&s.v)),
    )?;
    p.claim(
        "every function of several positions has the gradient that is written",
        model.functions.iter().filter(|f| f.is_of_several()).flat_map(gradient).map(|rest| exact(motion, &rest)),
    )?;
    p.proved.extend(balance::without_jump_terms(model, s));
    Ok(p.proved)
}

/// The derivatives of a function of several positions minus those that the author wrote.
fn gradient(f: &Function) -> Vec<Atom> {
    let by = |(of, slope): (&Expr, &Expr)| {
        let (kind, name) = symbols(&of.atom()).into_iter().next()?;
        Some(f.value.atom().derivative(symbol(kind, &name)) - slope.atom())
    };
    f.of.iter().zip(&f.gradient).filter_map(by).collect()
}

impl Proof<'_> {
    /// Records `what` as proved if each of `rests` is zero. Records nothing if there are no `rests`.
    fn claim(&mut self, what: &str, rests: impl IntoIterator<Item = Atom>) -> Result<(), Slip> {
        let mut any = false;
        for rest in rests {
            if !is_zero(&rest) {
                return Err(self.unproved(what, &rest));
            }
            any = true;
        }
        if any {
            self.proved.push(what.into());
        }
        Ok(())
    }

    /// The error that `what` was not proved, with the remainder that should be zero or, for a sign, the term that may have the wrong one.
    fn unproved(&self, what: &str, rest: &Atom) -> Slip {
        let rest = print(&Tree::new(&rest.expand()), Style::Plain);
        Slip::Unproved { model: self.model.name.clone(), what: what.into(), rest }
    }
}

/// Replaces the names of constants by their definitions in parameters.
pub(crate) fn exact(motion: &EquationsOfMotion, e: &Atom) -> Atom {
    let constants = motion.constants.iter().rev();
    constants.fold(e.clone(), |e, (name, value)| set(&e, symbol(Kind::Constant, name), value))
}
