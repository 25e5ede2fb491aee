//! The matrices of a cell in any kind of number. They are worked out once a scene, so that their code asks for the
//! effects as it runs: one function a model, not one a set of effects.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Expr, Index, Lit};

use crate::effects::{self, constant};
use crate::model::*;
use crate::sums::position;

/// The function `matrices` of `With<E, R>`.
pub fn matrices(m: &Model) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let conditions = effects::variables(m);
    let (mass, damping, stiffness) = (matrix(m, &m.mass), matrix(m, &m.damping), matrix(m, &m.stiffness));
    let mobility = match &m.mobility {
        Some(entries) => {
            let inverse = matrix(m, entries);
            quote!(Some(#inverse))
        }
        None => quote!(None),
    };
    let load = m.load.iter().map(|row| {
        let (i, value) = (position(m, &row.name), sum(&row.sum));
        quote!(load[#i] = #value;)
    });
    quote! {
        fn matrices(&self, effects: u32, k: &[R]) -> equations::Matrices<#n, R> {
            #conditions
            let zero = R::from(0.0);
            let mut load = [zero; #n];
            #(#load)*
            equations::Matrices { mass: #mass, mobility: #mobility, damping: #damping, stiffness: #stiffness, load }
        }
    }
}

/// A symmetric matrix, given by one of its triangles.
fn matrix(m: &Model, entries: &[Entry]) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let entries = entries.iter().map(|e| {
        let (i, j, value) = (position(m, &e.row), position(m, &e.column), sum(&e.sum));
        let mirror = (i != j).then(|| quote!(m[#j][#i] = m[#i][#j];));
        quote!(m[#i][#j] = #value; #mirror)
    });
    quote!({ let mut m = [[zero; #n]; #n]; #(#entries)* m })
}

fn sum(sum: &Sum) -> TokenStream {
    let terms = sum.iter().map(|Term { condition, value }| {
        let value = any_number(value);
        match condition.as_ref().map(constant) {
            Some(condition) => quote!(if #condition { sum += #value; }),
            None => quote!(sum += #value;),
        }
    });
    quote!({ let mut sum = zero; #(#terms)* sum })
}

/// An expression whose literals are numbers of the kind R.
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
