//! Large sums are compiled once instead of once for every set of effects: the terms of each condition become a function of
//! `Numbers`, and the code for a set of effects calls the functions whose conditions are met. Small sums are written in place, to be
//! inlined.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::Ident;

use crate::model::Sum;
use crate::sums::{Ask, block};

/// A function with more terms than this, in all entries together, is shared.
pub const LARGE: usize = 40;

/// A function that fills the result `v`.
pub struct Function<'a> {
    pub name: &'a str,
    /// Its parameters, `q: &[f64; 2], k: &[f64],`.
    pub takes: TokenStream,
    /// Its arguments, `q, k,`.
    pub given: TokenStream,
    /// The type of the result, `[f64; 2]`.
    pub returns: TokenStream,
    /// The result before anything is added, `[0.0; 2]`.
    pub zero: TokenStream,
    /// The first statements, `let d = ..;`: for code that knows the effects, and for code that does not.
    pub first: [TokenStream; 2],
}

/// An entry of the result, `v[0]`, and its sum.
pub struct Place<'a> {
    pub at: TokenStream,
    pub sum: &'a Sum,
}

impl Function<'_> {
    /// The statements of the function; the functions that they call are added to `shared`.
    pub fn body(&self, places: &[Place], shared: &mut Vec<TokenStream>) -> TokenStream {
        let Function { name, takes, given, returns, zero, first: [first, first_of_any] } = self;
        if places.iter().map(|p| p.sum.len()).sum::<usize>() <= LARGE {
            let set = places.iter().filter(|p| !p.sum.is_empty()).map(|Place { at, sum }| {
                let value = block(sum, Ask::Compiled);
                quote!(#at = #value;)
            });
            return quote!(#first let mut v = #zero; #(#set)* v);
        }
        let mut conditions: Vec<Option<Ident>> = vec![];
        for term in places.iter().flat_map(|p| p.sum) {
            if !conditions.contains(&term.condition) {
                conditions.push(term.condition.clone());
            }
        }
        let calls: Vec<TokenStream> = conditions
            .iter()
            .map(|condition| {
                let part = match condition {
                    Some(condition) => format_ident!("{name}_of_{condition}"),
                    None => format_ident!("{name}_always"),
                };
                let add = places.iter().flat_map(|Place { at, sum }| {
                    let terms = sum.iter().filter(|term| term.condition == *condition).map(|term| &term.value);
                    terms.map(move |value| quote!(#at += #value;))
                });
                shared.push(quote!(fn #part(&self, #takes v: &mut #returns) { #first_of_any #(#add)* }));
                let call = quote!(self.#part(#given &mut v););
                match condition.as_ref().map(|c| Ask::Compiled.tell(c)) {
                    Some(met) => quote!(if #met { #call }),
                    None => call,
                }
            })
            .collect();
        quote!(let mut v = #zero; #(#calls)* v)
    }
}
