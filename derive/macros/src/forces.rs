//! Named forces, of which torques are made: variables, each computed once however many rows it stands in.

use proc_macro2::TokenStream;
use quote::quote;

use crate::model::{Model, Term};
use crate::sums::{Ask, block};

/// `let F = ..;` for each, zero where its effect is not there.
pub fn of_effects(m: &Model, ask: Ask) -> TokenStream {
    let lets = m.forces.iter().map(|force| {
        let (name, value) = (&force.name, block(&force.sum, ask));
        quote!(let #name: f64 = #value;)
    });
    quote!(#(#lets)*)
}

/// The same where the effects are not known, for terms that ask for none.
pub fn of_values(m: &Model) -> TokenStream {
    let lets = m.forces.iter().map(|force| {
        let terms = force.sum.iter().map(|Term { value, .. }| value);
        let name = &force.name;
        quote!(let #name: f64 = #(#terms)+*;)
    });
    quote!(#(#lets)*)
}
