//! Code for sums and vectors that skips the terms of absent effects.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Ident, Index};

use crate::equations::effects::is_met;
use crate::equations::model::*;

/// The statements of a function that returns a vector; entries without a row are zero.
pub fn vector<'a>(m: &Model, rows: impl IntoIterator<Item = &'a Row>) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let rows = rows.into_iter().filter(|r| !r.sum.is_empty()).map(|r| {
        let (i, value) = (position(m, &r.name), block(&r.sum));
        quote!(v[#i] = #value;)
    });
    quote!(let mut v = [0.0; #n]; #(#rows)* v)
}

/// The statements of a function that returns a sum.
pub fn body(sum: &Sum) -> TokenStream {
    let (first, rest) = match &sum[..] {
        [] => return quote!(0.0),
        [Term { condition: None, value }] => return quote!(#value),
        [Term { condition: None, value }, rest @ ..] => (quote!(#value), rest),
        // x + -0.0 is x for every x, so the compiler drops the addition. x + 0.0 is not x for x = -0.0.
        all => (quote!(-0.0), all),
    };
    let terms = rest.iter().map(|Term { condition, value }| match condition.as_ref().map(is_met) {
        Some(met) => quote!(if #met { sum += #value; }),
        None => quote!(sum += #value;),
    });
    quote!(let mut sum = #first; #(#terms)* sum)
}

/// A sum as an expression.
pub fn block(sum: &Sum) -> TokenStream {
    let body = body(sum);
    if matches!(&sum[..], [] | [Term { condition: None, .. }]) { body } else { quote!({ #body }) }
}

/// `match i { 0 => .., 1 => .., _ => no_such("torque", i) }`
pub fn by_index(kind: &str, i: Ident, arms: impl Iterator<Item = TokenStream>) -> TokenStream {
    let arms = arms.enumerate().map(|(at, arm)| {
        let at = Index::from(at);
        quote!(#at => #arm,)
    });
    quote!(match #i { #(#arms)* _ => equations::no_such(#kind, #i) })
}

/// The index of a coordinate; `check` has made sure that it exists.
pub fn position(m: &Model, name: &Ident) -> Index {
    Index::from(m.coordinates.iter().position(|c| c.name == *name).expect("checked"))
}
