//! The functions of `Equations` for the effects E. Those that are called at every step have separate code for each set of effects;
//! the others call code that all sets share.

use proc_macro2::TokenStream;
use quote::quote;
use syn::Index;

use crate::cells::cells;
use crate::cold::Cold;
use crate::dead_bands;
use crate::forces;
use crate::gated;
use crate::jumps::step;
use crate::model::*;
use crate::share::{Function, LARGE, Place};
use crate::sums::{Ask, body, position};

/// The functions of `Equations`, and the functions of `Numbers` that only they call.
pub fn functions(m: &Model, cold: &[Cold]) -> (TokenStream, Vec<TokenStream>) {
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
        first: [quote!(let k = &k[..Self::VALUES]; #effects #d #d_dot #forces), quote!(#values #d #d_dot #any_forces)],
    }
    .body(&places, &mut shared);
    let (step, dead_band) = (step(m), dead_bands::function(m));
    let cells = cells(m, &quote!(f64));
    let cold = cells.iter().chain(cold).map(Cold::call);
    let functions = quote! {
        #[inline]
        fn dissipation(&self, q_dot: &#vector, k: &[f64]) -> f64 { #dissipation }
        #[inline]
        fn force(&self, q: &#vector, q_dot: &#vector, k: &[f64], dk: &[f64]) -> #vector { #force }
        #[inline]
        fn step(&self, law: usize, q: &#vector, k: &[f64], dk: f64) -> f64 { #step }
        #dead_band
        #(#cold)*
    };
    (functions, shared)
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
