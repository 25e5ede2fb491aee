//! The stages of a derivation, one after another.

use symbolica::atom::Atom;

use super::Derivation;
use crate::jump::{self, Jump};
use crate::lagrange::{self, EquationsOfMotion};
use crate::model::{MOVING_PHASE, Model};
use crate::slip::Slip;
use crate::symbols::{Partials, Symbols, Variable, expanded};
use crate::{cell, check, proof};

/// Derives the equations of motion, the cells and the jump rules from the energies of `model`, and proves them.
///
/// # Errors
/// A [`Slip`] that names the offending symbol or term, if the model is not valid or a proof fails.
pub fn derive(model: &Model) -> Result<Derivation<'_>, Slip> {
    derive_with(model, |_| {})
}

/// The formulas that are proved.
pub(crate) struct Formulas {
    pub symbols: Symbols,
    pub motion: EquationsOfMotion,
    pub jumps: Vec<Jump>,
}

/// [`derive`], but `change` may modify the formulas before they are proved.
pub(crate) fn derive_with(model: &Model, change: impl FnOnce(&mut Formulas)) -> Result<Derivation<'_>, Slip> {
    check::check(model)?;
    let symbols = Symbols::new(model);
    let motion = lagrange::derive(model, &symbols)?;
    let jumps = jump::derive(model, &motion, &symbols);
    let mut formulas = Formulas { symbols, motion, jumps };
    change(&mut formulas);
    let Formulas { symbols: s, motion, jumps } = formulas;
    let proofs = proof::prove(model, &s, &motion, &jumps)?;
    let cell = cell::derive(model, &s, &motion);
    let jacobian = jacobian(&s, &motion);
    let named = model.forces.iter().zip(&s.forces);
    let partials: Vec<_> = named
        .flat_map(|(force, f)| f.partials.iter().map(|(name, e)| (name.clone(), force.with.clone(), e.clone())))
        .collect();
    let derived =
        motion.acceleration.iter().flatten().chain(&motion.force).chain(jacobian.iter().flatten().map(|(_, by)| by));
    let derived = derived.chain(partials.iter().map(|(.., value)| value));
    let derived = derived.chain(motion.mobility.iter().flatten().flatten());
    let derived = derived.chain(motion.inertia.iter().flatten().flatten()).chain(motion.mass.iter().flatten());
    for equation in derived.chain(jumps.iter().map(|j| &j.step)).chain(motion.constants.iter().map(|c| &c.1)) {
        check::numbers(model, equation.as_view(), "the derived equations")?;
    }
    Ok(Derivation { model, symbols: s, partials, motion, jacobian, cell, jumps, proofs })
}

/// The derivatives of each force by the coordinates, the speeds, and the deflections and rates in which it is written.
fn jacobian(s: &Symbols, motion: &EquationsOfMotion) -> Vec<Partials> {
    let row = |force: &Atom| {
        let through_laws = lagrange::through_laws(s, force, MOVING_PHASE);
        let through_laws = through_laws.into_iter().map(|(i, by)| (Variable::Coordinate(i), by));
        expanded(s.by_positions(force).into_iter().chain(through_laws).chain(s.by_motions(force)))
    };
    motion.force.iter().map(row).collect()
}
