//! Every damper takes energy or none, and so does the damper of a dead band where its force is clipped to that of the spring.

use symbolica::atom::{Atom, AtomCore};

use super::{Proof, balance};
use crate::check::never_negative;
use crate::expr::{Expr, Kind, number, symbol, symbols, total};
use crate::markers::all_present;
use crate::mobility::is_zero;
use crate::model::DeadBand;
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
    for band in &p.model.dead_bands {
        clipped(p, band)?;
    }
    Ok(())
}

/// Whether the power of a term of D is never negative: by its form, or as a multiple of the term, whose form shows it (D is
/// homogeneous in the speeds, of degree two as a rule).
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
        let rate = balance::deflection_rate(p.model, name.trim_end_matches("_dot"));
        e.replace(Atom::var(symbol(kind, &name)).to_pattern()).with(rate.to_pattern())
    })
}

/// The damper of a dead band. In contact, at x = over, its spring has the force F_s = dV/dx and its damper would have the force
/// F_d = dD/dx'. Where c F_d x > F_s x, with c = 1 or -1, it is clipped to the force c F_s, and takes the power c F_s x'. Now
///
/// ```text
/// (c F_s x') (c F_d x) = (F_s x) (F_d x')      since c² = 1
/// ```
///
/// and c F_d x > F_s x >= 0. So c F_s x' >= 0 follows from F_s x >= 0 and F_d x' >= 0, which their forms show.
fn clipped(p: &mut Proof, band: &DeadBand) -> Result<(), Slip> {
    let [over, rate] = [(Kind::Deflection, band.over.clone()), (Kind::Rate, crate::expr::speed_name(&band.over))]
        .map(|(kind, name)| symbol(kind, &name));
    let force = |energies: &[Expr], by| {
        all_present(&total(energies.iter().map(|e| e.atom().derivative(by)).collect()).expand())
    };
    let (spring, damper) = (force(&p.model.potential, over), force(&p.model.dissipation, rate));
    if damper.is_zero() {
        return Ok(());
    }
    let what = format!(
        "the damper of {0}, clipped to the force F = dV/d{0} of its spring, takes energy or none: {1} F {0}_dot >= 0, since \
         F {0} >= 0, {0}_dot dD/d{0}_dot >= 0 and, where it is clipped, {1} {0} dD/d{0}_dot >= F {0}",
        band.over, band.clip
    );
    let (at, moving) = ((spring * Atom::var(over)).expand(), (damper * Atom::var(rate)).expand());
    for product in [&at, &moving] {
        if !never_negative(p.model, product) {
            return Err(p.unproved(&what, product));
        }
    }
    // The force in the rows of F that has `clip` as a factor does the power c F_s x'.
    let clip = symbol(Kind::Clip, &band.clip);
    let rows = p.motion.force.iter().zip(&p.s.v).map(|(force, v)| force.derivative(clip) * Atom::var(*v));
    let expected = total(balance::clipped_powers(p.model)).derivative(clip);
    p.claim(&what, [all_present(&(total(rows.collect()) + expected))])
}
