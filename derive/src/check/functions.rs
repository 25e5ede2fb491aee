//! Checks that every function is a known smooth one, and that every number can be written as code.

use symbolica::atom::{AtomCore, AtomView};
use symbolica::coefficient::CoefficientView;

use crate::model::Model;
use crate::slip::Slip;

const SMOOTH: [&str; 5] = ["sin", "cos", "exp", "log", "atan"];

/// Refuses functions that are not smooth or not known, and numbers that cannot be written as code; `place` is for the message.
pub(super) fn functions(model: &Model, e: AtomView, place: &str) -> Result<(), Slip> {
    match e {
        AtomView::Num(_) => numbers(model, e, place),
        AtomView::Var(_) => Ok(()),
        AtomView::Fun(f) => {
            let symbol = f.get_symbol();
            let name = symbol.get_stripped_name();
            if !SMOOTH.contains(&name) {
                let (model, place) = (model.name.clone(), place.to_string());
                return Err(Slip::Function { model, function: name.to_string(), place });
            }
            f.iter().try_for_each(|a| functions(model, a, place))
        }
        AtomView::Pow(p) => {
            let (base, exponent) = p.get_base_exp();
            functions(model, base, place)?;
            functions(model, exponent, place)
        }
        AtomView::Mul(m) => m.iter().try_for_each(|a| functions(model, a, place)),
        AtomView::Add(a) => a.iter().try_for_each(|a| functions(model, a, place)),
    }
}

/// All integers up to this one are exact in f64.
const EXACT: u64 = 1 << 53;

/// Every number must be rational and finite, its numerator and denominator exact in f64. A division by zero, for example, gives a number
/// that is not.
pub(crate) fn numbers(model: &Model, e: AtomView, place: &str) -> Result<(), Slip> {
    match e {
        AtomView::Num(n) => match n.get_coeff_view() {
            CoefficientView::Natural(n, d, 0, _) if n.unsigned_abs() <= EXACT && d.unsigned_abs() <= EXACT => Ok(()),
            _ => Err(Slip::Number { model: model.name.clone(), number: e.to_canonical_string(), place: place.into() }),
        },
        AtomView::Var(_) => Ok(()),
        AtomView::Fun(f) => f.iter().try_for_each(|a| numbers(model, a, place)),
        AtomView::Pow(p) => {
            let (base, exponent) = p.get_base_exp();
            numbers(model, base, place)?;
            numbers(model, exponent, place)
        }
        AtomView::Mul(m) => m.iter().try_for_each(|a| numbers(model, a, place)),
        AtomView::Add(a) => a.iter().try_for_each(|a| numbers(model, a, place)),
    }
}
