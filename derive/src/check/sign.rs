//! The sign of an expression, as far as its form shows it.

use symbolica::atom::{Atom, AtomView};

use crate::expr::{Kind, symbols};
use crate::model::{Factor, Model, Range, Role, Switch};
use crate::tree::Tree;

/// Whether the form of an expression shows that it is >= 0 for all admissible values.
pub(crate) fn never_negative(model: &Model, e: &Atom) -> bool {
    sign(model, e, false)
}

/// Whether the form of an expression shows that it is > 0 for all admissible values.
pub(crate) fn positive(model: &Model, e: &Atom) -> bool {
    sign(model, e, true)
}

fn sign(model: &Model, e: &Atom, strictly: bool) -> bool {
    let admissible = |range: Range| match range {
        Range::Any => false,
        Range::Positive | Range::Above(_) => true,
        Range::NotNegative => !strictly,
    };
    match e.as_view() {
        AtomView::Num(_) => matches!(Tree::new(e), Tree::Number(n, _) if n > 0 || (n == 0 && !strictly)),
        AtomView::Var(_) => match symbols(e).as_slice() {
            [(Kind::Parameter, name)] => model.parameters.iter().any(|p| p.name == *name && admissible(p.range)),
            [(Kind::Constant, name)] => {
                model.constants.iter().any(|(c, value)| c == name && sign(model, &value.atom(), strictly))
            }
            // Stiffnesses are >= 0 in every scene.
            [(Kind::Mid | Kind::Law, _)] => !strictly,
            // A factor of a switch is >= 0 if it is in every mode.
            [(Kind::Switched, name)] => {
                !strictly && model.switches.iter().any(|switch| in_every_mode(model, switch, name))
            }
            // The arms of rolling friction are >= 0 in every scene.
            [(Kind::Friction, name)] => {
                let arm = Role::Factor(Factor::Arm);
                !strictly && model.laws.iter().any(|law| law.name == *name && law.role == arm)
            }
            // The diagonal entries W_ii of M⁻¹ are > 0, because M is positive definite.
            [(Kind::Mobility, name)] => name[1..].split_once('_').is_some_and(|(i, j)| i == j),
            _ => false,
        },
        AtomView::Pow(p) => {
            let (base, exponent) = p.get_base_exp();
            let base = base.to_owned();
            match Tree::new(&exponent.to_owned()) {
                // An even power is >= 0; an inverse is never zero where it is finite.
                Tree::Number(n, 1) if n % 2 == 0 && (n < 0 || !strictly) => true,
                Tree::Number(_, 2) if !strictly => true,
                _ => sign(model, &base, strictly),
            }
        }
        AtomView::Mul(m) => m.iter().all(|f| sign(model, &f.to_owned(), strictly)),
        AtomView::Add(a) => a.iter().all(|t| sign(model, &t.to_owned(), strictly)),
        AtomView::Fun(_) => false,
    }
}

/// Whether a factor of a switch is >= 0 in every mode and without the effect.
fn in_every_mode(model: &Model, switch: &Switch, factor: &str) -> bool {
    let Some(i) = switch.symbols.iter().position(|s| s.name == factor) else { return false };
    let values = switch.modes.iter().filter_map(|mode| mode.values.get(i));
    switch.symbols[i].neutral >= 0 && values.into_iter().all(|value| sign(model, &value.atom(), false))
}
