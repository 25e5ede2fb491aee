//! The functions that are called at every step. They are compiled once for each set of effects E, so that the terms of absent
//! effects are not in their code.

use proc_macro2::TokenStream;
use quote::quote;
use syn::Index;

use crate::forces;
use crate::gated;
use crate::jumps::step;
use crate::model::*;
use crate::share::{Function, LARGE, Place};
use crate::sums::{Ask, body, position};

/// These functions of `Numbers`, and the functions that only they call.
pub fn functions(m: &Model) -> TokenStream {
    let n = Index::from(m.coordinates.len());
    let vector = quote!([f64; #n]);
    let (d, d_dot) = deflections(m);
    let bands = || [gated::of_effects(m, Ask::Compiled), gated::of_values(m)];
    let mut shared = vec![];

    let dissipation = if m.dissipation.len() <= LARGE {
        let body = body(&m.dissipation, Ask::Compiled);
        let [bands, _] = bands();
        quote!(#bands #d_dot #body)
    } else {
        let (takes, given) = (quote!(q_dot: &#vector, k: &[f64],), quote!(q_dot, k,));
        let (returns, zero, first) = (quote!(f64), quote!(0.0), bands().map(|bands| quote!(#bands #d_dot)));
        Function { name: "dissipation", takes, given, returns, zero, first }
            .body(&[Place { at: quote!(*v), sum: &m.dissipation }], &mut shared)
    };
    let places: Vec<Place> = m
        .force
        .iter()
        .flatten()
        .map(|r| {
            let i = position(m, &r.name);
            Place { at: quote!(v[#i]), sum: &r.sum }
        })
        .collect();
    let [effects, values] = bands();
    let (forces, any_forces) = (forces::of_effects(m, Ask::Compiled), forces::of_values(m));
    let force = Function {
        name: "force",
        takes: quote!(q: &#vector, q_dot: &#vector, k: &[f64], dk: &[f64],),
        given: quote!(q, q_dot, k, dk,),
        returns: vector.clone(),
        zero: quote!([0.0; #n]),
        // One bounds check for all law values instead of one for each.
        first: [
            quote!(let k = &k[..With::<E>::VALUES]; #effects #d #d_dot #forces),
            quote!(#values #d #d_dot #any_forces),
        ],
    }
    .body(&places, &mut shared);
    let step = step(m);
    let functions = quote! {
        fn dissipation<const E: u32>(&self, q_dot: &#vector, k: &[f64]) -> f64 { #dissipation }
        fn force<const E: u32>(&self, q: &#vector, q_dot: &#vector, k: &[f64], dk: &[f64], force: &mut #vector) {
            *force = { #force };
        }
        fn step<const E: u32>(&self, law: usize, q: &#vector, k: &[f64], dk: f64) -> f64 { #step }
        #(#shared)*
    };
    functions
}

/// `let d = ..;` and `let d_dot = ..;`: all deflections and their rates. The compiler drops those that are not used.
pub fn deflections(m: &Model) -> (TokenStream, TokenStream) {
    match m.deflections.is_empty() {
        true => (quote!(), quote!()),
        false => {
            let offsets = gated::offsets(m);
            (quote!(let d = self.deflections(q, #(#offsets),*);), quote!(let d_dot = self.rates(q_dot);))
        }
    }
}
