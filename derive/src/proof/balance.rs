//! The balance of power. The rates of V, D and Q are computed again from the energies as the author wrote them, not from the gradients that
//! gave F: a proof must not repeat the errors of the formula that it proves.

use symbolica::atom::{Atom, AtomCore, Symbol};

use super::Proof;
use crate::expr::{Expr, Kind, kind_and_name, number, set, symbol, total};
use crate::lagrange::gradient;
use crate::markers::all_present;
use crate::model::{JUMP_TERMS, Model, Torque};
use crate::print::{Style, print};
use crate::slip::Slip;
use crate::symbols::Symbols;
use crate::tree::Tree;

/// Proves the balance of power along the motion.
pub(super) fn prove(p: &mut Proof) -> Result<(), Slip> {
    let lossy = p.model.switches.iter().any(|switch| !switch.loss.atom().is_zero());
    let clipped = if lossy { "; q'.dD/dq' includes the power that switches take" } else { "" };
    let what = format!(
        "d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of \
         the additive effects{clipped}"
    );
    // T is quadratic in the speeds, so that d/dt (q'.dT/dq' - T) = dT/dt = q'.(M q'') + dT/dq.q', and M q'' = F along the motion.
    let m = p.model;
    let inertia = p.motion.force.iter().zip(&p.s.v).map(|(force, v)| Atom::var(*v) * with_jump_terms(force));
    let inertia = inertia.chain(m.kinetic.iter().map(|t| rate(m, &t.atom())));
    let stored = m.potential.iter().map(|v| rate(m, &v.atom()));
    let damped = m.dissipation.iter().map(|d| damper_power(m, d));
    let speed = |t: &Torque| t.along.map_or_else(|| displacement_rate(m, &t.through.atom()), |along| along.atom());
    let fed = m.torques.iter().map(|t| -(t.value.atom() * speed(t)));
    let rest = total(inertia.chain(stored).chain(damped).chain(switched_powers(m)).chain(fed).collect());
    p.claim(&what, [rest])
}

/// The power that a term of D takes, q'.dD/dq', written in the speeds.
pub(super) fn damper_power(model: &Model, d: &Expr) -> Atom {
    along(&d.atom(), |kind, name| match kind {
        Kind::Speed => Some(Atom::var(symbol(kind, name))),
        Kind::Rate => Some(deflection_rate(model, name.strip_suffix("_dot")?)),
        _ => None,
    })
}

/// The power that each switch takes, f x', with the marker of its effect.
fn switched_powers(model: &Model) -> impl Iterator<Item = Atom> {
    model.switches.iter().map(|switch| switch.lost() * deflection_rate(model, &switch.over))
}

/// The rate of a deflection on which its damper acts: without the rates of transmission errors.
pub(super) fn deflection_rate(model: &Model, name: &str) -> Atom {
    let deflection = model.deflections.iter().find(|d| d.name == name);
    deflection.map_or(number(0), |d| d.value.dot().atom())
}

/// The rate of the displacement of a torque, written in the speeds: without the rates of transmission errors.
fn displacement_rate(model: &Model, through: &Atom) -> Atom {
    along(through, |kind, name| match kind {
        Kind::Coordinate => Some(Expr::var(kind, name).dot().atom()),
        Kind::Deflection => Some(deflection_rate(model, name)),
        Kind::Function => function_rate(model, name),
        _ => None,
    })
}

/// The rate of a named function, or of one of its derivatives.
fn function_rate(model: &Model, name: &str) -> Option<Atom> {
    model.functions.iter().find_map(|function| {
        let which = function.derivatives().iter().position(|d| d.name == name)?;
        Some(model.function_rate(function, which))
    })
}

/// The rate of an expression of positions and laws along the motion, written in the speeds and the slopes of the laws.
fn rate(model: &Model, e: &Atom) -> Atom {
    along(e, |kind, name| match kind {
        Kind::Coordinate => Some(Expr::var(kind, name).dot().atom()),
        Kind::Deflection => model.deflections.iter().find(|d| d.name == name).map(|d| rate(model, &d.value.atom())),
        Kind::Function => function_rate(model, name),
        Kind::Law | Kind::Error => {
            let law = model.laws.iter().find(|law| law.name == name)?;
            let slope = Atom::var(symbol(Kind::Slope, &format!("d{name}")));
            let present = law.with.as_ref().map_or(number(1), |effect| Atom::var(symbol(Kind::Marker, effect)));
            Some(present * slope * law.phase.dot().atom())
        }
        _ => None,
    })
}

/// The sum over the symbols of `e` of the derivative by the symbol times the value of `factor` for its kind and name.
fn along(e: &Atom, factor: impl Fn(Kind, &str) -> Option<Atom>) -> Atom {
    let part = |s: Symbol| {
        let (kind, name) = kind_and_name(s);
        Some(e.derivative(s) * factor(kind, &name)?)
    };
    total(e.get_all_symbols(false).into_iter().filter_map(part).collect())
}

/// The expression with the jump terms present and other effects unchanged.
fn with_jump_terms(e: &Atom) -> Atom {
    set_jump_terms(e, 1)
}

fn set_jump_terms(e: &Atom, value: i64) -> Atom {
    set(e, symbol(Kind::Marker, JUMP_TERMS), &number(value))
}

/// The error of the power balance without the jump terms, as a warning to the reader.
pub(super) fn without_jump_terms(model: &Model, s: &Symbols) -> Option<String> {
    let rows = model.potential.iter().flat_map(|v| gradient(s, &v.atom(), JUMP_TERMS));
    let missing = rows.map(|(i, full)| Atom::var(s.v[i]) * (with_jump_terms(&full) - set_jump_terms(&full, 0)));
    let missing = total(missing.collect()).expand();
    (!missing.is_zero()).then(|| {
        format!(
            "without the jump terms the balance fails: energy is created at the rate {}",
            print(&Tree::new(&all_present(&missing)), Style::Plain)
        )
    })
}
