//! The functions that describe a cell, for any number type R: its matrices, its potential energy, the modes and guards of switches.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Expr, Index, Lit};

use crate::equations::cold::{Cold, Returns, Takes, in_any_number};
use crate::equations::effects::is_met;
use crate::equations::gradients::{self, ByVariable};
use crate::equations::jumps;
use crate::equations::lets::{positions, with_lets};
use crate::equations::model::*;
use crate::equations::sums::{body, position};
use crate::equations::switches;

/// The functions for M, M⁻¹ (if the file has it), C, K, f, V and the steps of V, in numbers of type R. If the model has switches, their
/// functions too.
pub fn cells(m: &Model) -> Vec<Cold> {
    let n = Index::from(m.coordinates.len());
    let square = |name, entries| Cold { name, takes: &[], returns: Returns::Matrix, body: matrix(m, entries) };
    let at = |cold: Cold| {
        let (positions, body) = (positions(m, &cold.body), cold.body);
        Cold { takes: &[Takes::Coordinates("q")], body: quote!(#positions #body), ..cold }
    };
    // Adds the argument `k`, the values of laws and switches.
    let of_values = |cold: Cold| {
        let body = with_lets(m, cold.body);
        Cold { takes: &[Takes::Values("k")], body, ..cold }
    };
    let mut all = vec![at(square("mass", &m.mass))];
    all.extend(m.mobility.as_ref().map(|entries| at(square("mobility", entries))));
    let products = |name, entries| Cold { name, takes: &[], returns: Returns::Matrix, body: products(m, entries) };
    all.extend([products("damping", &m.damping), products("stiffness", &m.stiffness)].map(of_values));
    let load = m.load.iter().map(|row| {
        let (along, value) = (gradients::straight(m, ByVariable::of(m, &row.name)), sum(&row.sum));
        quote!(equations::add_force(&mut v, #value, &#along);)
    });
    all.push(of_values(Cold {
        name: "load",
        takes: &[],
        returns: Returns::Vector,
        body: quote!(let zero = R::from(0.0); let mut v = [zero; #n]; #(#load)* v),
    }));
    all.push(Cold {
        name: "potential",
        takes: &[Takes::Coordinates("q"), Takes::Values("k")],
        returns: Returns::In(Clone::clone),
        body: in_any_number(with_lets(m, body(&m.potential))),
    });
    all.push(jumps::step(m));
    if !m.switches.is_empty() {
        all.extend(switches::cells(m));
    }
    all
}

/// The functions of [`cells`] for `Numbers<R>`, and `matrices`, which calls those of M, M⁻¹, C, K, f and V.
pub fn matrices(m: &Model, cells: &[Cold]) -> TokenStream {
    let mobility = match &m.mobility {
        Some(_) => quote!(Some(equations::matrix(&self.mobility(met, &q)))),
        None => quote!(None),
    };
    let n = Index::from(m.coordinates.len());
    let values = m.values();
    let each = cells.iter().map(|f| f.define(m, &quote!(R)));
    quote! {
        #(#each)*

        fn matrices(&self, met: &Met, k: &[R; #values]) -> equations::Matrices<R> {
            // In linear cells M is the same everywhere.
            let q = [R::from(0.0); #n];
            equations::Matrices {
                mass: equations::matrix(&self.mass(met, &q)),
                mobility: #mobility,
                damping: equations::matrix(&self.damping(met, k)),
                stiffness: equations::matrix(&self.stiffness(met, k)),
                load: equations::vector(&self.load(met, k)),
                at_zero: self.potential(met, &q, k),
            }
        }
    }
}

/// The statements of a function that returns a symmetric matrix; `entries` has one of each pair of equal entries.
fn matrix(m: &Model, entries: &[Entry]) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let entries = entries.iter().map(|e| {
        let (i, j, value) = (position(m, &e.row), position(m, &e.column), sum(&e.sum));
        let mirror = (i != j).then(|| quote!(v[#j][#i] = v[#i][#j];));
        quote!(v[#i][#j] = #value; #mirror)
    });
    quote!(let zero = R::from(0.0); let mut v = [[zero; #n]; #n]; #(#entries)* v)
}

/// The statements of a function that returns a symmetric matrix, from entries in coordinates and deflections as described in [`gradients`].
fn products(m: &Model, entries: &[Entry]) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let entries = entries.iter().map(|e| {
        let [row, column] = [&e.row, &e.column].map(|name| gradients::straight(m, ByVariable::of(m, name)));
        let value = sum(&e.sum);
        if e.row == e.column {
            quote!(equations::add_square(v.as_flattened_mut(), #n, #value, &#row);)
        } else {
            quote!(equations::add_product(v.as_flattened_mut(), #n, #value, &#row, &#column);)
        }
    });
    quote!(let zero = R::from(0.0); let mut v = [[zero; #n]; #n]; #(#entries)* v)
}

fn sum(sum: &Sum) -> TokenStream {
    if let [Term { condition: None, value }] = &sum[..] {
        return any_number(value);
    }
    let terms = sum.iter().map(|Term { condition, value }| {
        let value = any_number(value);
        match condition.as_ref().map(is_met) {
            Some(met) => quote!(if #met { sum += #value; }),
            None => quote!(sum += #value;),
        }
    });
    quote!({ let mut sum = zero; #(#terms)* sum })
}

/// The expression with its literals as numbers of type R.
pub fn any_number(e: &Expr) -> TokenStream {
    match e {
        Expr::Lit(lit) if matches!(lit.lit, Lit::Float(_)) => quote!(R::from(#lit)),
        Expr::Paren(e) => {
            let e = any_number(&e.expr);
            quote!((#e))
        }
        Expr::Group(e) => any_number(&e.expr),
        Expr::Unary(e) => {
            let (op, e) = (&e.op, any_number(&e.expr));
            quote!(#op #e)
        }
        Expr::Binary(e) => {
            let (left, op, right) = (any_number(&e.left), &e.op, any_number(&e.right));
            quote!(#left #op #right)
        }
        Expr::MethodCall(e) => {
            let (receiver, method) = (any_number(&e.receiver), &e.method);
            let arguments = e.args.iter().map(any_number);
            quote!(#receiver.#method(#(#arguments),*))
        }
        _ => quote!(#e),
    }
}
