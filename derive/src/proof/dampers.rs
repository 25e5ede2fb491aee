//! Proves that no damper adds energy.

use symbolica::atom::Atom;

use super::{Proof, balance};
use crate::check::never_negative;
use crate::expr::{Expr, Kind, number, set, symbol, symbols};
use crate::markers::all_present;
use crate::mobility::is_zero;
use crate::slip::Slip;

/// Proves the sign of the power of every damper.
pub(super) fn prove(p: &mut Proof) -> Result<(), Slip> {
    let what = "every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative";
    for d in &p.model.dissipation {
        takes(p, what, d)?;
    }
    if !p.model.dissipation.is_empty() {
        p.proved.push(what.into());
    }
    Ok(())
}

/// Checks that the power of a term of D is never negative. Either the form of the power shows this, or the power is a multiple of the term,
/// and the form of the term shows it. (D is homogeneous in the speeds, usually of degree two.)
fn takes(p: &Proof, what: &str, d: &Expr) -> Result<(), Slip> {
    const DEGREES: [i64; 3] = [2, 4, 6];
    let energy = all_present(&d.atom());
    let power = in_speeds(p, &all_present(&balance::damper_power(p.model, d)));
    let multiple = |degree: &i64| is_zero(&(&power - number(*degree) * in_speeds(p, &energy)));
    match never_negative(p.model, &power) || (never_negative(p.model, &energy) && DEGREES.iter().any(multiple)) {
        true => Ok(()),
        false => Err(p.unproved(what, &power)),
    }
}

/// The expression with the rates of deflections written in the speeds.
fn in_speeds(p: &Proof, e: &Atom) -> Atom {
    symbols(e).into_iter().filter(|(kind, _)| *kind == Kind::Rate).fold(e.clone(), |e, (kind, name)| {
        let rate = all_present(&balance::deflection_rate(p.model, name.trim_end_matches("_dot")));
        set(&e, symbol(kind, &name), &rate)
    })
}
