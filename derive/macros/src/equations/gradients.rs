//! Gradients of deflections by the coordinates. Matrices are written in coordinates and deflections: an entry k of the deflections
//! d and e is the matrix k g_d g_eᵀ. So each spring has one entry, however many coordinates it moves with.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{BinOp, Expr, ExprLit, Ident, Index, Lit, UnOp, parse_quote};

use crate::equations::cells::any_number;
use crate::equations::deflections::addends;
use crate::equations::lets::names;
use crate::equations::model::Model;
use crate::equations::scope::speed;

/// The variable of a row or a column of a matrix, with its index.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum ByVariable {
    Coordinate(usize),
    Speed(usize),
    Deflection(usize),
    Rate(usize),
}

impl ByVariable {
    /// The variable with this name; `check` has made sure that it exists.
    pub fn of(m: &Model, name: &Ident) -> Self {
        let (q, x) = (&m.coordinates, &m.deflections);
        let coordinate = q.iter().position(|c| c.name == *name).map(Self::Coordinate);
        let by_speed = || q.iter().position(|c| *name == speed(&c.name)).map(Self::Speed);
        let deflection = || x.iter().position(|d| d.name == *name).map(Self::Deflection);
        let rate = || m.rates.iter().position(|rate| rate.name == *name).map(Self::Rate);
        coordinate.or_else(by_speed).or_else(deflection).or_else(rate).expect("checked")
    }
}

/// The nonzero entries `[(i, g_i), ..]` of the gradient of a coordinate or deflection. Addends of a deflection with functions of positions
/// are left out.
pub fn straight(m: &Model, place: ByVariable) -> TokenStream {
    match place {
        ByVariable::Coordinate(i) | ByVariable::Speed(i) => {
            let i = Index::from(i);
            quote!([(#i, R::from(1.0))])
        }
        ByVariable::Deflection(d) | ByVariable::Rate(d) => {
            let bends = |addend: &Expr| m.functions.iter().any(|f| names(addend).contains(&f.name.to_string()));
            entries(m, d, |addend| !bends(addend), any_number)
        }
    }
}

/// The nonzero entries of the gradient of deflection `d`, in f64, with all addends. Functions of positions are variables in this code.
pub fn bent(m: &Model, d: usize) -> TokenStream {
    entries(m, d, |_| true, |e| quote!(#e))
}

fn entries(m: &Model, d: usize, which: impl Fn(&Expr) -> bool, code: impl Fn(&Expr) -> TokenStream) -> TokenStream {
    let addends: Vec<_> = addends(&m.rates[d].value, false).into_iter().filter(|(_, addend)| which(addend)).collect();
    let entry = |i: usize| {
        let factors = addends.iter().filter_map(|(minus, addend)| Some((*minus, code(&factor(addend, i)?))));
        // A sum cannot begin with `+`.
        let parts = factors.enumerate().map(|(at, (minus, factor))| match minus {
            true => quote!(- #factor),
            false if at == 0 => factor,
            false => quote!(+ #factor),
        });
        let parts: Vec<_> = parts.collect();
        let i = Index::from(i);
        (!parts.is_empty()).then(|| quote!((#i, #(#parts)*)))
    };
    let entries = (0..m.coordinates.len()).filter_map(entry);
    quote!([#(#entries),*])
}

/// The factor of the speed `q_dot[i]` in an expression that is linear in the speeds; `None` if it is zero.
fn factor(e: &Expr, i: usize) -> Option<Expr> {
    let of = |e: &Expr| factor(e, i);
    match e {
        Expr::Index(e) => {
            let of_speeds = matches!(&*e.expr, Expr::Path(speeds) if speeds.path.is_ident("q_dot"));
            (of_speeds && is_number(&e.index, &i.to_string())).then(|| parse_quote!(1.0))
        }
        Expr::Paren(e) => of(&e.expr),
        Expr::Group(e) => of(&e.expr),
        Expr::Unary(e) if matches!(e.op, UnOp::Neg(_)) => of(&e.expr).map(negative),
        Expr::Binary(e) => {
            let (left, right) = (&e.left, &e.right);
            match (&e.op, of(left), of(right)) {
                (BinOp::Mul(_), Some(one), _) if is_one(&one) => Some((**right).clone()),
                (BinOp::Mul(_), _, Some(one)) if is_one(&one) => Some((**left).clone()),
                (BinOp::Mul(_), Some(left), _) => Some(parse_quote!(#left*#right)),
                (BinOp::Mul(_), _, Some(right)) => Some(parse_quote!(#left*#right)),
                (BinOp::Div(_), Some(left), _) => Some(parse_quote!(#left/#right)),
                (BinOp::Add(_), Some(left), Some(right)) => Some(parse_quote!((#left + #right))),
                (BinOp::Sub(_), Some(left), Some(right)) => Some(parse_quote!((#left - #right))),
                (BinOp::Sub(_), None, Some(right)) => Some(negative(right)),
                (BinOp::Add(_) | BinOp::Sub(_), left, right) => left.or(right),
                _ => None,
            }
        }
        _ => None,
    }
}

fn negative(e: Expr) -> Expr {
    parse_quote!((-#e))
}

fn is_one(e: &Expr) -> bool {
    is_number(e, "1.0")
}

/// Whether an expression is the number of these digits.
fn is_number(e: &Expr, digits: &str) -> bool {
    match e {
        Expr::Lit(ExprLit { lit: Lit::Int(number), .. }) => number.base10_digits() == digits,
        Expr::Lit(ExprLit { lit: Lit::Float(number), .. }) => number.base10_digits() == digits,
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn factor_in(e: Expr, i: usize) -> Option<String> {
        factor(&e, i).map(|factor| quote!(#factor).to_string().replace(' ', ""))
    }

    #[test]
    fn factors_of_speeds_are_found_in_sums_of_products() {
        let rate: Expr = parse_quote!(-a * q_dot[0] * f / c + (b + 1.0) * q_dot[1] - (q_dot[0] - d * q_dot[2]) / e);
        assert_eq!(factor_in(rate.clone(), 0).as_deref(), Some("(-a*f/c-1.0/e)"));
        assert_eq!(factor_in(rate.clone(), 1).as_deref(), Some("(b+1.0)"));
        assert_eq!(factor_in(rate.clone(), 2).as_deref(), Some("(-(-d)/e)"));
        assert_eq!(factor_in(rate, 3), None);
    }
}
