//! cos(x)^2 = 1 - sin(x)^2, which Symbolica does not apply by itself: inertias written in Cartesian coordinates need it.

use symbolica::atom::{Atom, AtomCore, AtomView, Symbol};

use crate::expr::number;
use crate::markers::terms;
use crate::tree::Tree;

/// The expanded expression; with squares of cosines replaced by those of sines where it then has fewer terms.
pub(crate) fn simplified(e: &Atom) -> Atom {
    let (plain, replaced) = (e.expand(), without_squared_cosines(e.as_view()).expand());
    if terms(&replaced).len() < terms(&plain).len() { replaced } else { plain }
}

/// The expression as it is, or expanded and simplified if that takes fewer operations.
pub(crate) fn shorter(e: &Atom) -> Atom {
    let operations = |e: &Atom| Tree::new(e).operations().iter().sum::<usize>();
    let simplified = simplified(e);
    if operations(&simplified) < operations(e) { simplified } else { e.clone() }
}

/// The expression with cos(x)^n, n >= 2, in powers of 1 - sin(x)^2.
pub(crate) fn without_squared_cosines(e: AtomView) -> Atom {
    match e {
        AtomView::Pow(p) => {
            let (base, exponent) = p.get_base_exp();
            match (base, Tree::new(&exponent.to_owned())) {
                (AtomView::Fun(f), Tree::Number(n, 1)) if n >= 2 && f.get_symbol() == Symbol::COS => {
                    let sine = f.iter().map(|x| symbolica::function!(Symbol::SIN, x)).next().unwrap_or_default();
                    let square = number(1) - &sine * &sine;
                    square.pow(number(n / 2)) * base.to_owned().pow(number(n % 2))
                }
                _ => without_squared_cosines(base).pow(exponent.to_owned()),
            }
        }
        AtomView::Mul(m) => m.iter().fold(number(1), |product, factor| product * without_squared_cosines(factor)),
        AtomView::Add(a) => a.iter().fold(number(0), |sum, term| sum + without_squared_cosines(term)),
        AtomView::Num(_) | AtomView::Var(_) | AtomView::Fun(_) => e.to_owned(),
    }
}
